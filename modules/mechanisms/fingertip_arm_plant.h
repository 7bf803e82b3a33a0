// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_arm_parameters.h"
#include "mechanisms/markov_noise.h"
#include "mechanisms/plant.h"

#include <array>
#include <cstdint>

namespace chiron::mechanisms {

/// P3's arm as a hand moves it: a mass with friction along three axes and a body that turns against viscous friction,
///   m v˙ = f_hand − LuGre(v) − σ₂ v,   I ω˙ = τ_hand − b ω,
/// without motors and balanced: whatever effort is asked of it, none comes. Read by magnetic encoders (x, y, z) and by an IMU
/// with noise and drift, which reports the rotation vector of q_DT at its own rate. Counts in that order. Semi-implicit Euler,
/// viscous parts implicit. Haptic thread; no allocation. D, SI. Source: P3 §2.2; models.md §3, Arm.
class FingertipArmPlant final : public Plant {
public:
    static constexpr std::size_t kAxes = 6;

    FingertipArmPlant(const FingertipArmParameters& parameters, std::uint64_t seed) noexcept;

    void reset(const core::Vec3& p_DT) noexcept; ///< at rest there, pad down (identity), sensors from their start

    void beginTick(const AxisEfforts&, bool) noexcept override {} ///< no motors
    void step(double dt_s, const core::Wrench& onTool_D) noexcept override;
    void endTick() noexcept override; ///< the sensors are read

    ToolMotion motion() const noexcept override { return m_motion; }
    std::span<const std::int32_t> encoderCounts() const noexcept override { return m_counts; }
    core::Wrench measured_D() const noexcept override { return {}; }
    bool saturated() const noexcept override { return false; }
    int substeps() const noexcept override { return m_parameters.substeps; }
    bool turns() const noexcept override { return true; }

    double energy_J() const noexcept; ///< kinetic and of the bristles

private:
    void readImu() noexcept;
    void readEncoders() noexcept;

    FingertipArmParameters m_parameters;
    std::uint64_t m_seed;
    core::Random m_random;
    ToolMotion m_motion;
    std::array<LugreFriction, 3> m_friction{};
    std::array<MarkovNoise, 3> m_noise{};
    std::array<MarkovNoise, 3> m_drift{};
    std::array<std::int32_t, kAxes> m_counts{};
    int m_sinceImu = 0;
};

} // namespace chiron::mechanisms
