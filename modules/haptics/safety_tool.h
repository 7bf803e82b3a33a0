// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "devices/api/workspace_map.h"

#include <array>
#include <cstdint>

namespace chiron::haptics {

/// Describes one tool to the supervisor. The kinematics must outlive the supervisor's use of it.
struct SafetyTool {
    const devices::DeviceDescriptor& device;
    const devices::IToolKinematics& kinematics;
    devices::WorkspaceMapping mapping;
};

/// The same, reduced at configure time to what a tick needs: no strings, no vectors.
struct SafetyToolLimits {
    const devices::IToolKinematics* kinematics = nullptr;
    bool renders = false;   ///< renders force and is fast enough to do so
    bool inProcess = false; ///< stepped in the tick, so the age is 0 by definition
    devices::WorkspaceMap map{devices::WorkspaceMapping()}; ///< W <-> D
    double scale = 1.0;                                     ///< W per D
    std::uint32_t period_us = 1000;
    std::uint32_t watchdogStart_us = 0;
    std::uint32_t watchdogZero_us = 0;
    std::uint32_t watchdogFault_us = 0;
    /// Age of the samples against which energy is balanced (DeviceDescriptor::guardedDelay_us).
    std::uint8_t late_ticks = devices::kUsualOldestSample_us / 1000;
    int axes = 0;
    std::array<double, core::kMaxCoordinates> axisCap{}; ///< N or N·m; 0: not actuated, not limited
    /// True if some axis has a motor. Otherwise the force is displayed to a finger's pad (P3): it does no
    /// work on the tool's motion, so it does not enter the energy balance and is not damped.
    bool pushesHand = true;
    double forceCap_N = 0.0;       ///< 0: the device gives no force
    double torqueCap_Nm = 0.0;     ///< 0: the device gives no torque
    double damping_Ns_per_m = 0.0; ///< b_max of the device
};

} // namespace chiron::haptics
