// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/wrist.h"

#include "mechanisms/rotation_vector.h"

namespace chiron::mechanisms {

using core::Quat;
using core::Vec3;

Wrist::Wrist(const HandParameters& parameters, std::uint64_t seed, double toolInertia_kgm2) noexcept
    : m_parameters(parameters), m_seed(seed), m_tremor(tremorFromStart()),
      m_movedInertia_kgm2(parameters.wristInertia_kgm2 + toolInertia_kgm2) {}

Tremor Wrist::tremorFromStart() const noexcept {
    return {m_parameters.wristTremorRms_rad, core::Random::stream(m_seed, "hand/wrist_tremor")};
}

void Wrist::reset(const Quat& q_D) noexcept {
    m_q = m_wanted = q_D;
    m_w = m_wantedRate = Vec3::Zero();
    m_tremor = tremorFromStart();
    m_tremorTorque = Vec3::Zero();
}

void Wrist::beginTick(const HandIntention& acting) noexcept {
    m_wanted = acting.q_DDesired;
    m_wantedRate = acting.w_DDesired;
    m_tremor.advance();
    m_tremorTorque = m_movedInertia_kgm2 * m_tremor.acceleration() +
                     m_parameters.wristDamping_Nms_per_rad * m_tremor.velocity() +
                     m_parameters.wristStiffness_Nm_per_rad * m_tremor.displacement_m();
}

Vec3 Wrist::gripTorqueOnTool(const Quat& q_DT, const Vec3& w_DT) const noexcept {
    return m_parameters.gripAngularStiffness_Nm_per_rad * rotationVectorOf(m_q * q_DT.conjugate()) +
           m_parameters.gripAngularDamping_Nms_per_rad * (m_w - w_DT);
}

void Wrist::integrate(double dt_s, const Vec3& gripTorqueOnTool_D) noexcept {
    const double b = m_parameters.wristDamping_Nms_per_rad;
    const double inertia = m_parameters.wristInertia_kgm2;
    const Vec3 drive = m_parameters.wristStiffness_Nm_per_rad * rotationVectorOf(m_wanted * m_q.conjugate()) +
                       b * m_wantedRate + m_tremorTorque - gripTorqueOnTool_D;
    m_w = (m_w + (dt_s / inertia) * drive) / (1.0 + b * dt_s / inertia);
    m_q = turned(m_q, dt_s * m_w);
}

} // namespace chiron::mechanisms
