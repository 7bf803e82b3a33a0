// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace chiron::simulation {

/// S(u) = u²(3 − 2u), exactly 0 below 0 and 1 above 1; its slope is continuous. Pure.
/// Thread: haptic.
constexpr double smoothstep(double u) noexcept {
    const double v = std::clamp(u, 0.0, 1.0);
    return v * v * (3.0 - 2.0 * v);
}

/// dS/du = 6u(1 − u), 0 outside.
constexpr double smoothstepSlope(double u) noexcept {
    const double v = std::clamp(u, 0.0, 1.0);
    return 6.0 * v * (1.0 - v);
}

} // namespace chiron::simulation
