// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::mechanisms {

/// Angles of an endoscope about its tip, rad. pitch: of its axis above +y_D, in the plane of symmetry; yaw:
/// out of that plane (positive to −x_D); roll: about the axis itself, right-handed about the viewing
/// direction.
struct EndoscopeAngles {
    double pitch = 0.0;
    double yaw = 0.0;
    double roll = 0.0;
    core::Vec3 vector() const noexcept { return {pitch, yaw, roll}; }
};

/// P1's spherical joint at one set of angles (P1 §2: three rotations about the tip; devices.md §5): a gimbal
/// with
///   R_DT = R_x(pitch) R_y'(yaw) R_a(roll) · R_0,  R_0 = R_x(90°): looking along +y_D with y_T up;
/// the endoscope looks along a = −z_T. ω = J_ω (pitch˙, yaw˙, roll˙), columns x̂, y′ = (0, −sin p, cos p), a;
/// τ = J_ωᵀ T. Singular at yaw = ±90° (det J_ω = −cos yaw). Pure.
/// Unit: rad.
/// Frame: D.
/// Thread: any; allocates nothing.
class SphericalJoint {
public:
    SphericalJoint() noexcept : SphericalJoint(EndoscopeAngles{}) {}
    explicit SphericalJoint(const EndoscopeAngles& angles) noexcept;

    const core::Quat& orientation_DT() const noexcept { return m_q_DT; }
    const core::Vec3& yawAxis_D() const noexcept { return m_yawAxis_D; } ///< y′
    const core::Vec3& view_D() const noexcept { return m_view_D; }       ///< a
    core::Vec3 column(int axis) const noexcept;                          ///< of J_ω

    core::Vec3 angularVelocity_D(const core::Vec3& rates) const noexcept {
        return rates[0] * core::Vec3::UnitX() + rates[1] * m_yawAxis_D + rates[2] * m_view_D;
    }
    /// Returns ω˙ for constant rates.
    core::Vec3 biasAcceleration_D(const core::Vec3& rates) const noexcept;
    /// Returns J_ωᵀ T: torques of the pitch, yaw and roll axes (N·m).
    core::Vec3 efforts(const core::Vec3& torque_D) const noexcept {
        return {torque_D.x(), m_yawAxis_D.dot(torque_D), m_view_D.dot(torque_D)};
    }
    core::Vec3 torque_D(const core::Vec3& efforts) const noexcept; ///< J_ω⁻ᵀ τ
    core::Vec3 rates(const core::Vec3& w_DT) const noexcept;       ///< J_ω⁻¹ ω

    /// Returns the angles of an orientation, |yaw| ≤ 90°, pitch and roll in (−π, π].
    static EndoscopeAngles anglesOf(const core::Quat& q_DT) noexcept;

private:
    core::Quat m_q_DT;
    core::Vec3 m_yawAxis_D;
    core::Vec3 m_view_D;
    double m_sinYaw = 0.0;
    double m_cosYaw = 1.0;
};

} // namespace chiron::mechanisms
