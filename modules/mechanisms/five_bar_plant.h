// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/encoder_line.h"
#include "mechanisms/five_bar_dynamics.h"
#include "mechanisms/plant.h"

namespace chiron::mechanisms {

/// P1's mechanism with motors at the base and elastic tendons to its joints; q: joints, m: motors, both as
/// seen at the joint:
///   M(q) q̈ + h(q, q̇) + (1 − κ) g(q) = τ_t + τ_stop + Jᵀ f_hand,   τ_t = k_t (m − q) + d_t (ṁ − q̇),
///   J_r m̈ = τ_motor − τ_t − friction(ṁ)   (LuGre, viscous part implicit).
/// The motors follow their command with the amplifier's lag. Each is limited to its share for rendering plus
/// what carries the weight. The encoders sit on the motor axes, so the host does not see the tendons stretch.
/// The ends of travel are rubber stops. The integration is semi-implicit Euler at 1 ms / substeps; the result
/// is deterministic. Source: P1 §2, devices.md §5.
/// Unit: SI.
/// Frame: D.
/// Thread: haptic; allocates nothing.
class FiveBarPlant final : public Plant {
public:
    explicit FiveBarPlant(const FiveBarPlantParameters& parameters) noexcept;

    /// Places it at rest at this configuration, motors off, encoders settled.
    void reset(const FiveBarVector& q) noexcept;

    void beginTick(const AxisEfforts& render, bool enabled) noexcept override;
    void step(double dt_s, const core::Wrench& onTool_D) noexcept override;
    void endTick() noexcept override;

    ToolMotion motion() const noexcept override;
    std::span<const std::int32_t> encoderCounts() const noexcept override { return m_encoders.counts(); }
    core::Wrench measured_D() const noexcept override { return m_measured_D; }
    bool saturated() const noexcept override { return m_saturated; }
    int substeps() const noexcept override { return m_parameters.substeps; }
    bool turns() const noexcept override { return true; }

    const FiveBarPlantParameters& parameters() const noexcept { return m_parameters; }
    const FiveBarDynamics& dynamics() const noexcept { return m_dynamics; }
    const FiveBarVector& q() const noexcept { return m_q; }
    const FiveBarVector& rates() const noexcept { return m_rates; }
    const FiveBarVector& motorAngles() const noexcept { return m_motorAngle; }
    /// Energy of links, endoscope, rotors, unbalanced weight, tendons, bristles and stops.
    double energy_J() const noexcept;

private:
    double beyondStop(int axis) const noexcept; ///< signed, 0 within the travel
    FiveBarVector stopTorques() const noexcept;

    FiveBarPlantParameters m_parameters;
    FiveBarDynamics m_dynamics; ///< placed at m_q
    /// Placed at the configuration that the encoders report; the feed-forward uses it.
    FiveBarDynamics m_host;
    EncoderLine<FiveBarPlantParameters::kAxes> m_encoders;
    std::array<LugreFriction, FiveBarPlantParameters::kAxes> m_friction{};
    FiveBarVector m_q = FiveBarVector::Zero();
    FiveBarVector m_rates = FiveBarVector::Zero();
    FiveBarVector m_motorAngle = FiveBarVector::Zero();
    FiveBarVector m_motorRate = FiveBarVector::Zero();
    FiveBarVector m_target = FiveBarVector::Zero();      ///< requested motor torques, limited
    FiveBarVector m_motor = FiveBarVector::Zero();       ///< present motor torques, after the amplifier
    FiveBarVector m_feedForward = FiveBarVector::Zero(); ///< share of m_target that carries weight
    core::Wrench m_measured_D;
    bool m_saturated = false;
};

} // namespace chiron::mechanisms
