// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

#include <span>

namespace chiron::mechanisms {

/// Returns the laws of this module that the command line can evaluate over a table. In vendor axes
/// (GimbalKinematics): "polar_forces" (a Cartesian force to P2's F_h, F_p, F_d, as published and exact, with
/// the error of the force that the published ones produce) and "polar_weight" (the weight of a mass as P2
/// prints it, and exact). In D: "five_bar_pose" (P1's linkage: tip, Jacobian, distance from singularity) and
/// "five_bar_efforts" (a wrench on its endoscope to the five axes). Static data.
/// Thread: any.
std::span<const core::LawDescription> evaluateLaws() noexcept;

} // namespace chiron::mechanisms
