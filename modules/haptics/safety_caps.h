// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/geometry.h"
#include "haptics/safety_tool.h"

namespace chiron::haptics {

/// The factor that brings a wrench to the nearest cap (models.md §5, caps): min over the actuated axes of
/// cap/|effort|, of force cap/‖f‖ and of torque cap/‖τ‖. Above 1: there is room; infinity for a zero wrench;
/// 0 where the kinematics answers with something not finite. A cap of 0 is not a limit here (the part is
/// removed before). `sample`: the newest good one. Thread: haptic.
double capRatio(const SafetyToolLimits& limits, const core::DeviceSample& sample,
                const core::Wrench& wrench_W) noexcept;

/// Scales the whole wrench, so that its direction is kept, until every cap holds; true if it had to.
bool applyCaps(const SafetyToolLimits& limits, const core::DeviceSample& sample,
               core::Wrench& wrench_W) noexcept;

} // namespace chiron::haptics
