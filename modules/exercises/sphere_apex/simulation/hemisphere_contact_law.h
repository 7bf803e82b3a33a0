// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// The law "hemisphere" as a table for the command line (evaluate_laws.h): HemisphereContact without friction
/// computes force, outward normal, depth and energy from the tool's position and velocity. The data are
/// static.
/// Thread: any.
core::LawDescription hemisphereLaw() noexcept;

} // namespace chiron::simulation
