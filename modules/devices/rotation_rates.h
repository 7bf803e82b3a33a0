// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::devices {

/// Returns the left Jacobian of SO(3): w = J(r) r˙ for q = exp(r),
///   J(r) = 1 + (1 - cos θ)/θ² [r]× + (θ - sin θ)/θ³ [r]×², θ = ‖r‖
/// (Chirikjian 2011, Stochastic Models, Information Theory, and Lie Groups, vol. 2, §10.6).
/// Thread: any.
inline core::Mat3 leftJacobian(const core::Vec3& r) noexcept {
    const double angle = r.norm();
    // Below this angle the next term of the series is smaller than a double resolves beside the first.
    constexpr double kSmall = 1e-4;
    const bool small = angle < kSmall;
    const double a = small ? 0.5 - angle * angle / 24.0 : (1.0 - std::cos(angle)) / (angle * angle);
    const double b =
        small ? 1.0 / 6.0 - angle * angle / 120.0 : (angle - std::sin(angle)) / (angle * angle * angle);
    core::Mat3 cross;
    cross << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
    return core::Mat3::Identity() + a * cross + b * cross * cross;
}

} // namespace chiron::devices
