// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/encoder_line.h"
#include "mechanisms/gimbal_plant_parameters.h"
#include "mechanisms/plant.h"

#include <array>
#include <cstdint>

namespace chiron::mechanisms {

/// The gimbal's dynamics, M(q)q̈ + c(q,q̇) + g(q) + friction = τ_motor + Jᵀf_hand, with the instrument as a
/// rod of mass m and transverse inertia I whose centre of mass lies s = d − c from the pivot:
///   M_h = (m s² + I) cos²p + I_h,  M_p = m s² + I + I_p,  M_r = I_r,  M_d = m + m_d
/// (diagonal; the spin of the thin rod about its own axis is left out), Coriolis terms from ∂M, and g from V
/// = −m g s cos h cos p. The integration is semi-implicit Euler with implicit viscous terms and bristles
/// (LugreFriction); positions are clamped at the end stops. Deterministic. Source: models.md §4,
/// devices.md §5.
/// Unit: SI.
/// Frame: D.
/// Thread: haptic; allocates nothing.
class GimbalPlant final : public Plant {
public:
    explicit GimbalPlant(const GimbalPlantParameters& parameters) noexcept;

    void reset(const GimbalCoordinates& q) noexcept; ///< at rest at this configuration, motors off, encoders
                                                     ///< settled

    /// Starts a tick with the motor efforts requested for rendering (N·m, N·m, –, N); gravity feed-forward is
    /// added from the newest counts. With `enabled` false the amplifiers are open: no effort at all.
    void beginTick(const GimbalVector& renderEfforts, bool enabled) noexcept;
    void beginTick(const AxisEfforts& render, bool enabled) noexcept override {
        beginTick(GimbalVector(render[0], render[1], render[2], render[3]), enabled);
    }
    /// One integration step of 1 ms / substeps under a force on the tool at the tip (D).
    void integrate(double dt_s, const core::Vec3& f_T_D) noexcept;
    void step(double dt_s, const core::Wrench& onTool_D) noexcept override {
        integrate(dt_s, onTool_D.force);
    }
    /// Ends a tick after its steps: reads the encoders.
    void endTick() noexcept override;

    ToolMotion motion() const noexcept override; ///< the hand holds a point, so there is no orientation

    const GimbalKinematics& kinematics() const noexcept { return m_kinematics; }
    const GimbalPlantParameters& parameters() const noexcept { return m_parameters; }
    const GimbalCoordinates& q() const noexcept { return m_q; }
    const GimbalVector& rates() const noexcept { return m_rates; }
    const core::Vec3& p_DT() const noexcept { return m_p_DT; } ///< true tip
    const core::Vec3& v_DT() const noexcept { return m_v_DT; }
    /// Encoder counts h, p, r, d as the host sees them (delayed by sampleDelay_ticks).
    const std::array<std::int32_t, 4>& counts() const noexcept { return m_encoders.counts(); }
    std::span<const std::int32_t> encoderCounts() const noexcept override { return counts(); }
    /// Force on the tool in D that the motors really gave over the last tick, without the gravity
    /// feed-forward.
    const core::Vec3& measuredForce_D() const noexcept { return m_measured_D; }
    core::Wrench measured_D() const noexcept override { return {m_measured_D, core::Vec3::Zero()}; }
    bool saturated() const noexcept override { return m_saturated; }
    int substeps() const noexcept override { return m_parameters.substeps; }
    bool turns() const noexcept override { return false; }

    GimbalVector inertia(const GimbalCoordinates& q) const noexcept; ///< diagonal of M
    GimbalVector
    gravity(const GimbalCoordinates& q) const noexcept; ///< ∂V/∂q of the instrument, spring included
    double energy_J() const noexcept;                   ///< kinetic + gravity + spring + bristles

private:
    GimbalVector coriolisAndWeight(double across, double acrossPerMetre) const noexcept;
    void updateTip() noexcept;
    void stopAtEnds() noexcept;
    std::array<double, 4> coordinates() const noexcept { return {m_q.h, m_q.p, m_q.r, m_q.d}; }
    GimbalCoordinates sensed() const noexcept;

    GimbalPlantParameters m_parameters;
    GimbalKinematics m_kinematics;
    GimbalCoordinates m_q;
    GimbalVector m_rates = GimbalVector::Zero();
    GimbalVector m_target = GimbalVector::Zero();      ///< requested motor efforts, clamped
    GimbalVector m_motor = GimbalVector::Zero();       ///< present motor efforts, after the amplifier
    GimbalVector m_feedForward = GimbalVector::Zero(); ///< share of m_target that carries the weight
    std::array<LugreFriction, 4> m_friction{};
    EncoderLine<4> m_encoders;
    core::Vec3 m_p_DT = core::Vec3::Zero();
    core::Vec3 m_v_DT = core::Vec3::Zero();
    core::Vec3 m_measured_D = core::Vec3::Zero();
    // State of the present step, set by updateTip(): unit directions in D in which the three axes move the
    // tip.
    core::Vec3 m_alongHeading_D = core::Vec3::Zero();
    core::Vec3 m_alongPitch_D = core::Vec3::Zero();
    core::Vec3 m_alongDepth_D = core::Vec3::Zero();
    double m_sh = 0.0, m_ch = 1.0, m_sp = 0.0, m_cp = 1.0;
    bool m_saturated = false;
};

} // namespace chiron::mechanisms
