// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::haptics {

/// Limits how fast a vector may rise or turn (models.md §5, slew). Decreases are free: from p, the vector
/// shown last, every λp with 0 <= λ <= 1 may be reached at once. From the point c of that segment nearest to
/// the target t, the step is at most `step`: result = c + min(1, step/‖t-c‖)(t-c). So a rise and a turn are
/// limited, and a decrease, a stop or a ramp-down never is. ‖result‖ <= ‖target‖: the limit never holds force
/// above the requested one. step > 0, in the vector's unit per tick. Sets `limited` if the target was not
/// reached.
/// Thread: haptic.
core::Vec3 limitSlew(const core::Vec3& last, const core::Vec3& target, double step, bool& limited) noexcept;

} // namespace chiron::haptics
