// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

#include <span>

namespace chiron::simulation {

/// The laws of this module that the command line can evaluate over a table: "hemisphere" (HemisphereContact
/// without friction: position and velocity of the tool → force, outward normal, depth, energy) and "friction"
/// (CoulombFriction: normal force and velocity → force, V₀), and "urethra-force" (UrethraForces: pose and velocity of the
/// endoscope → every component); "urethra-centreline", "urethra-profile" and "urethra-surface" (UrethraCentreline, UrethraWall and
/// UrethraCurveNet by arc length); and P2's building blocks, "elasticity", "strain-stiffening", "mass", "deformation", "roughness",
/// "bristle-friction", "viscosity" and "elastic-tube" (attributes/evaluate_attributes.h). Static data; thread: any.
std::span<const core::LawDescription> evaluateLaws() noexcept;

} // namespace chiron::simulation
