// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"
#include "mechanisms/tremor.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::mechanisms {

/// The arm that closes the loop: a point mass that a spring and a damper pull towards the desired motion and
/// that holds the tool through a stiff damped grip:
///   m ẍ = k(x_d − x) + b(ẋ_d − ẋ) + f_tremor − f_grip,   f_grip = k_g(x − x_T) + b_g(ẋ − ẋ_T) (on the tool).
/// The reaction delay acts on the intention only; the arm's mechanics respond at once (inside the stiffness
/// loop the delay would be unstable from 30 ms). Tremor enters as the force that makes the free hand, with
/// the tool, move by the tremor's displacement. Source: models.md §4.
/// Unit: SI.
/// Frame: D.
/// Thread: haptic; allocates nothing.
class Hand {
public:
    Hand(const HandParameters& parameters, std::uint64_t seed, double toolMass_kg) noexcept;

    /// Places the hand at rest at this pose, with the intention to stay there; the tremor begins anew.
    void reset(const core::Vec3& p_D, const core::Quat& q_D = core::Quat::Identity()) noexcept;
    /// Starts a tick: the operator's newest intention enters the delay line, the delayed one takes effect,
    /// and the tremor advances.
    void beginTick(const HandIntention& wanted) noexcept;
    core::Vec3 gripForceOnTool(const core::Vec3& p_DT, const core::Vec3& v_DT) const noexcept; ///< N, D
    /// One integration step (semi-implicit Euler, damping implicit) under the reaction to the grip force.
    void integrate(double dt_s, const core::Vec3& gripForceOnTool_D) noexcept;

    const core::Vec3& p_D() const noexcept { return m_p; }
    const core::Vec3& v_D() const noexcept { return m_v; }
    /// The delayed intention that is now in effect.
    const HandIntention& acting() const noexcept { return m_acting; }

private:
    Tremor tremorFromStart() const noexcept;

    static constexpr std::size_t kLine = 512;
    HandParameters m_parameters;
    std::uint64_t m_seed;
    Tremor m_tremor;
    double m_movedMass_kg;
    std::size_t m_delay_ticks;
    std::size_t m_next = 0;
    std::array<HandIntention, kLine> m_line{};
    HandIntention m_acting;
    core::Vec3 m_tremorForce = core::Vec3::Zero();
    core::Vec3 m_p = core::Vec3::Zero();
    core::Vec3 m_v = core::Vec3::Zero();
};

} // namespace chiron::mechanisms
