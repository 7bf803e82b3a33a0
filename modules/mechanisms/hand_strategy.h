// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"
#include "core/visible_cues.h"

#include <cstdint>

namespace chiron::mechanisms {

/// The true input of a hand's senses at one tick, *before* perceptual noise, which the strategy adds.
struct HandPerception {
    double time_s = 0.0; ///< executed ticks · 1 ms since the device was opened
    /// True position of the hand, D (m); it is off the tip by the grip's deflection.
    core::Vec3 p_DT = core::Vec3::Zero();
    core::Vec3 v_DT = core::Vec3::Zero();  ///< m/s
    core::Vec3 f_T_D = core::Vec3::Zero(); ///< force that the plant really exerts on the hand, D (N), mean
                                           ///< over the last tick
    core::VisibleCues cues;                ///< cues on the screen (object in W)
    /// Centre of the shown object in D; zero unless cues.objectShown.
    core::Vec3 p_DObject = core::Vec3::Zero();
    /// Orientation in which the hand holds the tool; identity if the device does not turn.
    core::Quat q_DT = core::Quat::Identity();
    core::Vec3 w_DT = core::Vec3::Zero(); ///< rad/s
    /// A platform presses the finger pad (P3); the arm itself then feels no force.
    bool fingertip = false;
    /// True action of the platform on the pad: force along its normal (N), pitch and roll (rad).
    core::DisplayPose pad;
    /// Torque that the plant really exerts on the hand, D (N·m), mean over the last tick.
    core::Vec3 t_T_D = core::Vec3::Zero();
};

/// The intention of a hand: where to be, and which buttons to hold.
struct HandIntention {
    core::Vec3 p_DDesired = core::Vec3::Zero();
    core::Vec3 v_DDesired = core::Vec3::Zero();
    core::Quat q_DDesired = core::Quat::Identity(); ///< used by devices that turn
    core::Vec3 w_DDesired = core::Vec3::Zero();     ///< rad/s
    std::uint32_t buttons = 0;
    double jaw_rad = 0.0;
};

/// Decision model of a scripted trainee for one exercise. It is called once per tick inside the simulated
/// device. It is seeded and reproducible: the same perceptions give the same intentions.
/// Thread: haptic; noexcept, allocates nothing.
class HandStrategy {
public:
    HandStrategy() = default;
    HandStrategy(const HandStrategy&) = delete;
    HandStrategy& operator=(const HandStrategy&) = delete;
    virtual ~HandStrategy() = default;
    virtual HandIntention decide(const HandPerception& seen) noexcept = 0;
};

} // namespace chiron::mechanisms
