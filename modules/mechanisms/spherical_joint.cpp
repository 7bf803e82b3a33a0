// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/spherical_joint.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Quat;
using core::Vec3;

SphericalJoint::SphericalJoint(const EndoscopeAngles& angles) noexcept {
    // Half angles of the three turns; R_x(pitch) R_0 is one turn about x, and R_a turns about −z of T.
    const double x = 0.5 * angles.pitch + 0.25 * core::kPi;
    const double sx = std::sin(x), cx = std::cos(x);
    const double sy = std::sin(0.5 * angles.yaw), cy = std::cos(0.5 * angles.yaw);
    const double sz = -std::sin(0.5 * angles.roll), cz = std::cos(0.5 * angles.roll);
    const double w = cx * cy, i = sx * cy, j = cx * sy, k = sx * sy; // R_x R_y
    m_q_DT = Quat(w * cz - k * sz, i * cz + j * sz, j * cz - i * sz, k * cz + w * sz);
    const double sinPitch = 1.0 - 2.0 * cx * cx, cosPitch = 2.0 * sx * cx; // of 2x − 90°
    m_sinYaw = 2.0 * sy * cy;
    m_cosYaw = 1.0 - 2.0 * sy * sy;
    m_yawAxis_D = Vec3(0.0, -sinPitch, cosPitch);
    m_view_D = Vec3(-m_sinYaw, cosPitch * m_cosYaw, sinPitch * m_cosYaw);
}

Vec3 SphericalJoint::column(int axis) const noexcept {
    return axis == 0 ? Vec3(Vec3::UnitX()) : axis == 1 ? m_yawAxis_D : m_view_D;
}

Vec3 SphericalJoint::biasAcceleration_D(const Vec3& rates) const noexcept {
    const Vec3 turn = rates[0] * Vec3::UnitX();
    return rates[1] * turn.cross(m_yawAxis_D) + rates[2] * (turn + rates[1] * m_yawAxis_D).cross(m_view_D);
}

Vec3 SphericalJoint::rates(const Vec3& w_DT) const noexcept {
    // x̂, y′ and x̂ × y′ are orthonormal; a = −sin(yaw) x̂ − cos(yaw) x̂ × y′.
    const Vec3 third = Vec3::UnitX().cross(m_yawAxis_D);
    const double roll = -w_DT.dot(third) / m_cosYaw;
    return {w_DT.x() + m_sinYaw * roll, m_yawAxis_D.dot(w_DT), roll};
}

Vec3 SphericalJoint::torque_D(const Vec3& efforts) const noexcept {
    const Vec3 third = Vec3::UnitX().cross(m_yawAxis_D);
    return efforts[0] * Vec3::UnitX() + efforts[1] * m_yawAxis_D -
           (efforts[2] + m_sinYaw * efforts[0]) / m_cosYaw * third;
}

EndoscopeAngles SphericalJoint::anglesOf(const Quat& q_DT) noexcept {
    const Vec3 view = q_DT * -Vec3::UnitZ();
    EndoscopeAngles angles;
    angles.pitch = std::atan2(view.z(), view.y());
    angles.yaw = std::asin(std::clamp(-view.x(), -1.0, 1.0));
    const Quat rest = SphericalJoint({angles.pitch, angles.yaw, 0.0}).orientation_DT().conjugate() * q_DT;
    const double half = std::atan2(-rest.z(), rest.w()); // the roll that is left, about −z of T
    angles.roll = 2.0 * half;
    if (angles.roll > core::kPi)
        angles.roll -= 2.0 * core::kPi;
    else if (angles.roll <= -core::kPi)
        angles.roll += 2.0 * core::kPi;
    return angles;
}

} // namespace chiron::mechanisms
