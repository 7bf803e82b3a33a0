// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// The law "friction" as a table for the command line (evaluate_laws.h): CoulombFriction computes friction
/// force and V₀ from normal force and velocity. The data are static.
/// Thread: any.
core::LawDescription frictionLaw() noexcept;

} // namespace chiron::simulation
