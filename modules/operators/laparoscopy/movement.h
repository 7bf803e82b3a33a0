// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <algorithm>
#include <array>

namespace chiron::operators {

/// Returns a velocity towards a goal: proportional to the remaining distance, at most `speed`. SI, in any one
/// frame.
inline core::Vec3 velocityTo(const core::Vec3& goal, const core::Vec3& here, double gain_per_s,
                             double speed_m_per_s) noexcept {
    const core::Vec3 left = goal - here;
    const double distance = left.norm();
    if (!(distance > 1e-9))
        return core::Vec3::Zero();
    return left * (std::min(gain_per_s * distance, speed_m_per_s) / distance);
}

inline core::Vec3 vectorOf(const std::array<double, 3>& p) noexcept {
    return {p[0], p[1], p[2]};
}

/// First-order smoothing by one step.
template <class Value> void smoothTowards(Value& value, const Value& now, double share) noexcept {
    value += share * (now - value);
}

} // namespace chiron::operators
