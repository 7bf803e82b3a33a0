// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"
#include "mechanisms/tremor.h"

#include <cstdint>

namespace chiron::mechanisms {

/// The wrist that turns the tool, the rotational counterpart of Hand: an isotropic inertia that a spring and
/// a damper pull towards the desired orientation and that holds the tool through a stiff damped grip:
///   I ω˙ = k log(q_d q⁻¹) + b (ω_d − ω) + τ_tremor − τ_grip,  τ_grip = k_g log(q q_T⁻¹) + b_g (ω − ω_T)  (on
///   the tool).
/// log is the rotation vector, whose spring torque is the gradient of ½ k angle². The reaction delay is in
/// Hand, which hands over the intention that acts. Source: models.md §4.
/// Unit: SI.
/// Frame: D.
/// Thread: haptic; allocates nothing.
class Wrist {
public:
    /// `toolInertia_kgm2`: of the held tool, so that tremor moves the free hand by its displacement.
    Wrist(const HandParameters& parameters, std::uint64_t seed, double toolInertia_kgm2) noexcept;

    /// Places the wrist at rest at this orientation, with the intention to stay there; the tremor begins
    /// anew.
    void reset(const core::Quat& q_D) noexcept;
    /// Starts a tick with the intention that acts now (Hand::acting()); the tremor advances.
    void beginTick(const HandIntention& acting) noexcept;
    core::Vec3 gripTorqueOnTool(const core::Quat& q_DT, const core::Vec3& w_DT) const noexcept; ///< N·m, D
    /// One integration step (semi-implicit Euler, damping implicit) under the reaction to the grip's torque.
    void integrate(double dt_s, const core::Vec3& gripTorqueOnTool_D) noexcept;

    const core::Quat& q_D() const noexcept { return m_q; }
    const core::Vec3& w_D() const noexcept { return m_w; }

private:
    Tremor tremorFromStart() const noexcept;

    HandParameters m_parameters;
    std::uint64_t m_seed;
    Tremor m_tremor; ///< its displacement is an angle here
    double m_movedInertia_kgm2;
    core::Quat m_wanted = core::Quat::Identity();
    core::Vec3 m_wantedRate = core::Vec3::Zero();
    core::Vec3 m_tremorTorque = core::Vec3::Zero();
    core::Quat m_q = core::Quat::Identity();
    core::Vec3 m_w = core::Vec3::Zero();
};

} // namespace chiron::mechanisms
