// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_arm_chain.h"
#include "mechanisms/plant.h"

#include <array>
#include <cstdint>

namespace chiron::mechanisms {

/// P3's console arm as a hand moves it, seven links in series:
///   M(q) q̈ + c(q, q̇) + (1 − κ) g(q) = Jᵀ f_hand + τ_fingers + τ_stop − friction(q̇)
/// with LuGre friction, whose viscous part is implicit;
/// where κ is the share of the weight that is balanced and τ_fingers comes from a spring and a damper on the
/// lever's joint. The arm has no motors: it ignores every requested effort. Its sensors are absolute magnetic
/// encoders on the three arm joints (resolution, noise, run-out), the handle's IMU (attitude_sensor.h) and a
/// Hall sensor for the grasp. The counts are yaw, shoulder, elbow, then the IMU's rotation vector. The ends
/// of travel are rubber stops that damp only on the way in. The integration is semi-implicit Euler; the
/// result is deterministic. Source: P3 §2.2; devices.md §5; models.md §3, Arm.
/// Unit: SI.
/// Frame: D.
/// Thread: haptic; allocates nothing.
class FingertipArmPlant final : public Plant {
public:
    static constexpr std::size_t kAxes = 6;

    FingertipArmPlant(const FingertipArmParameters& parameters, std::uint64_t seed) noexcept;

    /// Places the arm at rest at this position, pad down (identity), jaw closed, with the sensors in their
    /// initial state. If the position is out of reach, the middle of the box is used.
    void reset(const core::Vec3& p_DT) noexcept;

    void beginTick(const AxisEfforts&, bool) noexcept override {} ///< no motors
    /// Sets where the fingers hold the lever from now on.
    void holdLever(double fingers_rad) noexcept { m_fingers_rad = fingers_rad; }
    void step(double dt_s, const core::Wrench& onTool_D) noexcept override;
    void endTick() noexcept override; ///< reads the sensors

    ToolMotion motion() const noexcept override;
    std::span<const std::int32_t> encoderCounts() const noexcept override { return m_counts; }
    std::int32_t jawCounts() const noexcept { return m_jawCounts; } ///< of the Hall sensor
    core::Wrench measured_D() const noexcept override { return {}; }
    bool saturated() const noexcept override { return false; }
    int substeps() const noexcept override { return m_parameters.substeps; }
    bool turns() const noexcept override { return true; }

    const FingertipArmParameters& parameters() const noexcept { return m_parameters; }
    const FingertipArmDynamics& dynamics() const noexcept { return m_dynamics; } ///< placed at q()
    const FingertipArmJoints& q() const noexcept { return m_q; }
    const FingertipArmJoints& rates() const noexcept { return m_rates; }
    FingertipArmJoints& ratesForTests() noexcept { return m_rates; }
    const AttitudeSensor& imu() const noexcept { return m_imu; }
    /// Kinetic energy and the energy of the unbalanced weight, bristles, stops and the pinch.
    double energy_J() const noexcept;

    /// Inertia that a hand moves at the handle's present pose, kg and kg·m²: a third of the trace of (J M⁻¹
    /// Jᵀ)⁻¹ for force and for torque.
    double apparentMass_kg() const noexcept;
    double apparentInertia_kgm2() const noexcept;

private:
    FingertipArmJoints stopTorques() const noexcept;
    core::Vec3 place() const noexcept { return m_dynamics.joint(FingertipArmParameters::kWrist); }
    double apparent(bool turning) const noexcept;
    void readEncoders() noexcept;

    FingertipArmParameters m_parameters;
    FingertipArmDynamics m_dynamics;
    std::uint64_t m_seed;
    core::Random m_random;
    AttitudeSensor m_imu;
    std::array<double, 2> m_runoutPhase_rad[FingertipArmParameters::kArm]{};
    std::array<LugreFriction, FingertipArmParameters::kJoints> m_friction{};
    FingertipArmJoints m_q = FingertipArmJoints::Zero();
    FingertipArmJoints m_rates = FingertipArmJoints::Zero();
    core::Vec3 m_velocityBefore = core::Vec3::Zero();
    double m_fingers_rad = 0.0;
    std::array<std::int32_t, kAxes> m_counts{};
    std::int32_t m_jawCounts = 0;
};

} // namespace chiron::mechanisms
