// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/finger_pad.h"

#include <array>

namespace chiron::mechanisms {

/// P3's platform as a body on three geared drives, against a finger's pad:
///   m_m q̈_m = f_motor − friction(q˙_m) − f_gear,   f_gear = k e + c e˙ beyond the backlash, e = q_m − q(x),
///   M ẍ = Gᵀ f_gear − F ∂δ/∂x − bands − joint damping,  x = (z, β, α),
/// where M is the mass matrix of platform and carriages at level (when leaning, the true one is 0.62 to 1.16
/// of it in the worst direction; the three rotors, seven times as heavy together, are exact). The bands carry
/// the weight and pull back to level. The motors follow their command with the amplifier's lag and are
/// limited by the current limit. The integration is semi-implicit Euler, with bristles and viscous friction
/// implicit. Source: P3 §2.1.
/// Unit: SI.
/// Frame: F.
/// Thread: haptic; allocates nothing.
class FingertipPlant {
public:
    explicit FingertipPlant(const FingertipPlatformParameters& parameters) noexcept;

    /// Places it at rest at this pose, motors off, gears in the middle of their backlash.
    void reset(const FingertipPose& pose) noexcept;
    void step(double dt_s, const core::Vec3& motorForces) noexcept; ///< forces requested of the motors, N
                                                                    ///< along the rails

    const FingertipPose& pose() const noexcept { return m_pose; }
    const FingertipLoop& loop() const noexcept { return m_loop; }
    const core::Vec3& motors() const noexcept { return m_motor; } ///< q_m, m
    /// Moves the finger in its holder, along z, m.
    void shiftFinger(double up_m) noexcept { m_shift_m = up_m; }
    double padForce_N() const noexcept { return m_padForce_N; } ///< along the platform's normal, ≥ 0
    core::Vec2 padPlace() const noexcept { return m_pad.place(m_loop); }
    bool saturated() const noexcept { return m_saturated; } ///< in the last step
    /// Kinetic energy and that of gears, bands and pad, for a pad that does not relax.
    double energy_J() const noexcept;

    FingertipPose& poseForTests() noexcept { return m_pose; }
    core::Vec3& ratesForTests() noexcept { return m_rates; }

private:
    void stopAtEnds() noexcept;
    double gearStretch(int drive) const noexcept;
    /// Penetration of the pad, m.
    double depth() const noexcept { return m_pad.penetration(m_loop) - m_shift_m * m_loop.normal.z(); }

    FingertipPlatformParameters m_p;
    FingertipKinematics m_kinematics;
    FingerPad m_pad;
    core::Vec3 m_mass; ///< diagonal of M
    core::Vec3 m_band; ///< stiffness for z, β, α
    FingertipPose m_pose;
    FingertipLoop m_loop;
    core::Vec3 m_rates = core::Vec3::Zero(); ///< ẋ
    core::Vec3 m_motor = core::Vec3::Zero();
    core::Vec3 m_motorRate = core::Vec3::Zero();
    core::Vec3 m_motorForce = core::Vec3::Zero(); ///< after the amplifier
    std::array<LugreFriction, 3> m_friction{};
    PadRelaxation m_relaxation;
    double m_shift_m = 0.0;
    double m_padForce_N = 0.0;
    bool m_saturated = false;
};

} // namespace chiron::mechanisms
