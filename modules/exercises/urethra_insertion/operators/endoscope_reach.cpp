// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/operators/endoscope_reach.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec3;

namespace {

template <class Vector> void approach(Vector& value, const Vector& wanted, double most) noexcept {
    const Vector change = wanted - value;
    const double size = change.norm();
    value += size > most ? Vector(change * (most / size)) : change;
}

/// Moves an angle by one tick and stops it at the ends.
void turn(double& angle, double& rate, double low, double high) noexcept {
    angle += core::kTickSeconds * rate;
    if (angle < low || angle > high) {
        angle = std::clamp(angle, low, high);
        rate = 0.0;
    }
}

} // namespace

void EndoscopeReach::start(const Vec3& p_D, const core::Quat& q_D) noexcept {
    m_place = p_D;
    m_angles = mechanisms::SphericalJoint::anglesOf(q_D);
    m_angles.roll = 0.0;
    m_velocity.setZero();
    m_wantedVelocity.setZero();
    m_rate.setZero();
    m_wantedRate.setZero();
}

void EndoscopeReach::wish(const EndoscopeWish& wish, double pitch_rad) noexcept {
    const double c = std::cos(pitch_rad), s = std::sin(pitch_rad);
    m_wantedVelocity = Vec3(0.0, wish.along_m_per_s * c - wish.across_m_per_s * s,
                            wish.along_m_per_s * s + wish.across_m_per_s * c);
    m_wantedRate = core::Vec2(wish.pitch_rad_per_s, wish.yaw_rad_per_s);
}

mechanisms::HandIntention EndoscopeReach::advance() noexcept {
    approach(m_velocity, m_wantedVelocity, kAcceleration_m_per_s2 * core::kTickSeconds);
    approach(m_rate, m_wantedRate, kAcceleration_rad_per_s2 * core::kTickSeconds);
    m_place += core::kTickSeconds * m_velocity;
    turn(m_angles.pitch, m_rate.x(), kLowestPitch_rad, kHighestPitch_rad);
    turn(m_angles.yaw, m_rate.y(), -kWidestYaw_rad, kWidestYaw_rad);
    const mechanisms::SphericalJoint joint(m_angles);
    mechanisms::HandIntention wanted;
    wanted.p_DDesired = m_place;
    wanted.v_DDesired = m_velocity;
    wanted.q_DDesired = joint.orientation_DT();
    wanted.w_DDesired = joint.angularVelocity_D(Vec3(m_rate.x(), m_rate.y(), 0.0));
    return wanted;
}

} // namespace chiron::operators
