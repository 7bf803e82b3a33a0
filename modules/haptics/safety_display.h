// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "haptics/safety_slew.h"

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

/// Largest lean of a fingertip platform (P3; models.md §3): 30° in total, within pitch ±30° and roll ±20°;
/// rad.
inline constexpr double kMaximumLean_rad = 0.5235987755982988;
inline constexpr double kMaximumPitch_rad = 0.5235987755982988;
inline constexpr double kMaximumRoll_rad = 0.3490658503988659;
/// Largest increase of the lean per tick: 600°/s, ASSUMPTION, faster than the drives follow (400°/s), so that
/// a step of the scene does not reach the pad as a blow. The return towards level is not limited, just as a
/// decrease of force is not.
inline constexpr double kLeanStep_rad = 0.010471975511965978;

/// Returns the pose that a fingertip platform may show, given the pose that the scene requests and the share
/// of the tool's force that the supervisor lets through. The normal force is scaled by the same share, so
/// that gain, ramp, damping, caps and slew act on it. The lean fades to level with this force below 0.05 N,
/// as the scene's own lean does (models.md §3), and is scaled along its own direction into the platform's
/// limits. The cap is applied last. `asked_N` and `allowed_N` are the norms of the tissue force and of the
/// commanded force. Pure. Source: models.md §5; "safety supervisor last".
/// Thread: haptic.
inline core::DisplayPose displayUnder(const core::DisplayPose& asked, double asked_N, double allowed_N,
                                      bool enabled, double cap_N) noexcept {
    const bool usable =
        std::isfinite(asked.normalForce_N) && std::isfinite(asked.pitch_rad) && std::isfinite(asked.roll_rad);
    if (!enabled || !usable || !(asked_N > 0.0) || !(allowed_N > 0.0))
        return {};
    const double share = std::min(1.0, allowed_N / asked_N);
    const double t = std::min(1.0, allowed_N / 0.05);
    // Without a limit, `asked` already contains the scene's own fade.
    const double level = share < 1.0 ? t * t * (3.0 - 2.0 * t) : 1.0;
    core::DisplayPose safe;
    safe.normalForce_N = std::clamp(asked.normalForce_N * share, 0.0, std::max(0.0, cap_N));
    const double lean = std::hypot(asked.pitch_rad, asked.roll_rad);
    const double over =
        level * std::max({std::abs(asked.pitch_rad) / kMaximumPitch_rad,
                          std::abs(asked.roll_rad) / kMaximumRoll_rad, lean / kMaximumLean_rad});
    const double scale = over > 1.0 ? level / over : level; // keeps the direction, as the scene's own limit
                                                            // does
    safe.pitch_rad = asked.pitch_rad * scale;
    safe.roll_rad = asked.roll_rad * scale;
    return safe;
}

/// Limits how fast the display changes from one tick to the next: the normal force rises by at most `step_N`,
/// and the lean moves outwards or around by at most kLeanStep_rad; decreases are not limited (safety_slew.h).
/// The scene's wrench has passed the slew stage before, but its display pose is not tied to that wrench, so
/// the display needs a limit of its own. Sets `limited` if the limit acted. Pure.
/// Thread: haptic.
inline core::DisplayPose slewDisplay(const core::DisplayPose& last, const core::DisplayPose& target,
                                     double step_N, bool& limited) noexcept {
    core::DisplayPose safe = target;
    if (target.normalForce_N > last.normalForce_N + step_N) {
        safe.normalForce_N = last.normalForce_N + step_N;
        limited = true;
    }
    const core::Vec3 lean = limitSlew({last.pitch_rad, last.roll_rad, 0.0},
                                      {target.pitch_rad, target.roll_rad, 0.0}, kLeanStep_rad, limited);
    safe.pitch_rad = lean.x();
    safe.roll_rad = lean.y();
    return safe;
}

} // namespace chiron::haptics
