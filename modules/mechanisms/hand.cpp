// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/hand.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Vec3;

Hand::Hand(const HandParameters& parameters, std::uint64_t seed, double toolMass_kg) noexcept
    : m_parameters(parameters), m_seed(seed), m_tremor(tremorFromStart()),
      m_movedMass_kg(parameters.mass_kg + toolMass_kg),
      m_delay_ticks(static_cast<std::size_t>(std::clamp(
          std::lround(parameters.reactionDelay_s / core::kTickSeconds), 0L, static_cast<long>(kLine) - 1))) {}

Tremor Hand::tremorFromStart() const noexcept {
    return {m_parameters.tremorRms_m, core::Random::stream(m_seed, "hand/tremor")};
}

void Hand::reset(const Vec3& p_D, const core::Quat& q_D) noexcept {
    HandIntention stay;
    stay.p_DDesired = p_D;
    stay.q_DDesired = q_D;
    m_line.fill(stay);
    m_acting = stay;
    m_tremor = tremorFromStart();
    m_tremorForce = Vec3::Zero();
    m_p = p_D;
    m_v = Vec3::Zero();
}

void Hand::beginTick(const HandIntention& wanted) noexcept {
    m_line[m_next] = wanted;
    m_acting = m_line[(m_next + kLine - m_delay_ticks) % kLine];
    m_next = (m_next + 1) % kLine;
    m_tremor.advance();
    m_tremorForce = m_movedMass_kg * m_tremor.acceleration() +
                    m_parameters.damping_Ns_per_m * m_tremor.velocity() +
                    m_parameters.stiffness_N_per_m * m_tremor.displacement_m();
}

Vec3 Hand::gripForceOnTool(const Vec3& p_DT, const Vec3& v_DT) const noexcept {
    return m_parameters.gripStiffness_N_per_m * (m_p - p_DT) +
           m_parameters.gripDamping_Ns_per_m * (m_v - v_DT);
}

void Hand::integrate(double dt_s, const Vec3& gripForceOnTool_D) noexcept {
    const double b = m_parameters.damping_Ns_per_m;
    const Vec3 drive = m_parameters.stiffness_N_per_m * (m_acting.p_DDesired - m_p) +
                       b * m_acting.v_DDesired + m_tremorForce - gripForceOnTool_D;
    m_v = (m_v + (dt_s / m_parameters.mass_kg) * drive) / (1.0 + b * dt_s / m_parameters.mass_kg);
    m_p += dt_s * m_v;
}

} // namespace chiron::mechanisms
