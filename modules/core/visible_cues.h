// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exercise_cues.h"
#include "core/geometry.h"
#include "core/session_state.h"

#include <cstdint>

namespace chiron::core {

/// The information that a person in front of the screen can see at this tick. A level lists its cues; cues
/// that it hides are absent here too, so neither a window nor a scripted operator can learn more than the
/// level allows.
struct VisibleCues {
    std::uint16_t trial = 0;
    TrialPhase phase = TrialPhase::idle;
    ForceState force = ForceState::off;
    double timeLeft_s = 0.0;
    bool objectShown = false;      ///< cue "object"
    Vec3 p_WObject = Vec3::Zero(); ///< m; zero unless objectShown
    double objectRadius_m = 0.0;   ///< zero unless objectShown
    /// ‖tissue force‖ on this tool, filled in by the loop for input-only devices (slowed motion); zero on a
    /// device that renders force, because the hand feels it there.
    double shownForce_N = 0.0;
    ExerciseCues exercise; ///< the cues that only this exercise shows
};

} // namespace chiron::core
