// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::mechanisms {

/// Returns the shorter rotation of a unit quaternion as axis times angle, rad.
/// Thread: any.
inline core::Vec3 rotationVectorOf(const core::Quat& q) noexcept {
    const double sine = q.vec().norm();
    const double side = q.w() < 0.0 ? -1.0 : 1.0;
    // Below this atan2(s, c)/s is 1 to the last bit.
    const double scale = sine < 1e-9 ? 2.0 : 2.0 * std::atan2(sine, side * q.w()) / sine;
    return side * scale * q.vec();
}

/// Returns q turned by the rotation vector r, in the frame in which r is expressed: exp(r) q, unit.
inline core::Quat turned(const core::Quat& q, const core::Vec3& r) noexcept {
    const double half = 0.5 * r.norm();
    const double scale = half < 1e-9 ? 0.5 : 0.5 * std::sin(half) / half;
    core::Quat result = core::Quat(std::cos(half), scale * r.x(), scale * r.y(), scale * r.z()) * q;
    result.normalize();
    return result;
}

} // namespace chiron::mechanisms
