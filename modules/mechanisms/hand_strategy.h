// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"
#include "core/visible_cues.h"

#include <cstdint>

namespace chiron::mechanisms {

/// What a hand feels and sees at one tick, *before* its own perceptual noise (the strategy adds it).
struct HandPerception {
    double time_s = 0.0; ///< executed ticks · 1 ms since the device was opened
    core::Vec3 p_DT =
        core::Vec3::Zero(); ///< where the hand really is, D (m); a grip's deflection away from the tip
    core::Vec3 v_DT = core::Vec3::Zero(); ///< m/s
    core::Vec3 f_T_D =
        core::Vec3::Zero(); ///< force that the plant really puts on the hand, D (N), mean over the last tick
    core::VisibleCues cues; ///< what the screen shows (object in W)
    core::Vec3 p_DObject =
        core::Vec3::Zero(); ///< the shown object's centre in D; zero unless cues.objectShown
    core::Quat q_DT = core::Quat::Identity(); ///< how the hand holds the tool; identity where the device does not turn
    core::Vec3 w_DT = core::Vec3::Zero();     ///< rad/s
    bool fingertip = false; ///< the finger pad is pressed by a platform (P3); the arm itself then feels no force
    core::DisplayPose pad;  ///< what the platform truly does to the pad: force along its normal (N), pitch and roll (rad)
    core::Vec3 t_T_D = core::Vec3::Zero(); ///< torque that the plant really puts on the hand, D (N·m), mean over the last tick
};

/// What a hand wants: where to be, and which buttons to hold.
struct HandIntention {
    core::Vec3 p_DDesired = core::Vec3::Zero();
    core::Vec3 v_DDesired = core::Vec3::Zero();
    core::Quat q_DDesired = core::Quat::Identity(); ///< used by devices that turn
    core::Vec3 w_DDesired = core::Vec3::Zero();     ///< rad/s
    std::uint32_t buttons = 0;
    double jaw_rad = 0.0;
};

/// A scripted trainee's mind for one exercise: called once a tick inside the simulated device, so noexcept
/// and free of allocation. Seeded and reproducible: the same perceptions give the same intentions.
class HandStrategy {
public:
    HandStrategy() = default;
    HandStrategy(const HandStrategy&) = delete;
    HandStrategy& operator=(const HandStrategy&) = delete;
    virtual ~HandStrategy() = default;
    virtual HandIntention decide(const HandPerception& seen) noexcept = 0;
};

} // namespace chiron::mechanisms
