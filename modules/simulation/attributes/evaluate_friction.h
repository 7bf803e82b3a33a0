// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// "friction" as a table for the command line (evaluate_laws.h): CoulombFriction, normal force and velocity → force, V₀. Static data;
/// thread: any.
core::LawDescription frictionLaw() noexcept;

} // namespace chiron::simulation
