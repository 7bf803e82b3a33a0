// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// "hemisphere" as a table for the command line (evaluate_laws.h): HemisphereContact without friction, position and velocity of the tool →
/// force, outward normal, depth, energy. Static data; thread: any.
core::LawDescription hemisphereLaw() noexcept;

} // namespace chiron::simulation
