// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "haptics/safety_slew.h"

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

/// How far a fingertip platform leans at most (P3; models.md §3): 30° in all, of which pitch ±30°, roll ±20°, rad.
inline constexpr double kMaximumLean_rad = 0.5235987755982988;
inline constexpr double kMaximumPitch_rad = 0.5235987755982988;
inline constexpr double kMaximumRoll_rad = 0.3490658503988659;
/// How much further it may lean in a tick: 600°/s, ASSUMPTION, faster than the drives follow (400°/s), so that a scene's step is
/// not passed on as a blow to the pad. Back towards level is free, as giving way is for force.
inline constexpr double kLeanStep_rad = 0.010471975511965978;

/// What a fingertip platform may do, from what the scene asked of it and what the supervisor let through of the tool's force:
/// the normal force is scaled alike, so that gain, ramp, damping, caps and slew act on it; the lean goes level with it below
/// 0.05 N, as the scene's own does (models.md §3), and is scaled along its own direction into the platform's limits. The last word is the cap's. `asked_N`, `allowed_N`: norms of the tissue and
/// the commanded force. Pure; haptic thread. Source: models.md §5; "safety supervisor last".
inline core::DisplayPose displayUnder(const core::DisplayPose& asked, double asked_N, double allowed_N, bool enabled,
                                      double cap_N) noexcept {
    const bool usable = std::isfinite(asked.normalForce_N) && std::isfinite(asked.pitch_rad) && std::isfinite(asked.roll_rad);
    if (!enabled || !usable || !(asked_N > 0.0) || !(allowed_N > 0.0))
        return {};
    const double share = std::min(1.0, allowed_N / asked_N);
    const double t = std::min(1.0, allowed_N / 0.05);
    const double level = share < 1.0 ? t * t * (3.0 - 2.0 * t) : 1.0; // unlimited, the scene's own fade is in `asked` already
    core::DisplayPose safe;
    safe.normalForce_N = std::clamp(asked.normalForce_N * share, 0.0, std::max(0.0, cap_N));
    const double lean = std::hypot(asked.pitch_rad, asked.roll_rad);
    const double over = level * std::max({std::abs(asked.pitch_rad) / kMaximumPitch_rad, std::abs(asked.roll_rad) / kMaximumRoll_rad,
                                          lean / kMaximumLean_rad});
    const double scale = over > 1.0 ? level / over : level; // along its own direction, as the scene's own limit
    safe.pitch_rad = asked.pitch_rad * scale;
    safe.roll_rad = asked.roll_rad * scale;
    return safe;
}

/// The display of this tick after that of the last one: normal force rises by at most `step_N`, the lean goes outwards or round
/// by at most kLeanStep_rad; giving way is free (safety_slew.h). The scene's wrench passes the slew before, but nothing ties its
/// display pose to that wrench, so the display has one of its own. `limited` is set where it acted. Pure; haptic thread.
inline core::DisplayPose slewDisplay(const core::DisplayPose& last, const core::DisplayPose& target, double step_N,
                                     bool& limited) noexcept {
    core::DisplayPose safe = target;
    if (target.normalForce_N > last.normalForce_N + step_N) {
        safe.normalForce_N = last.normalForce_N + step_N;
        limited = true;
    }
    const core::Vec3 lean = limitSlew({last.pitch_rad, last.roll_rad, 0.0}, {target.pitch_rad, target.roll_rad, 0.0}, kLeanStep_rad, limited);
    safe.pitch_rad = lean.x();
    safe.roll_rad = lean.y();
    return safe;
}

} // namespace chiron::haptics
