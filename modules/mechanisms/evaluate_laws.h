// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

#include <span>

namespace chiron::mechanisms {

/// The laws of this module that the command line can evaluate over a table: "polar_forces" (a Cartesian force
/// to P2's F_h, F_p, F_d, as published and exact, with the error that realising the published ones costs) and
/// "polar_weight" (a mass' weight as P2 prints it, and exact), both in vendor axes (GimbalKinematics);
/// "five_bar_pose" (P1's linkage: tip, Jacobian, how far from singular) and "five_bar_efforts" (a wrench on its endoscope
/// to the five axes), in D. Static data; thread: any.
std::span<const core::LawDescription> evaluateLaws() noexcept;

} // namespace chiron::mechanisms
