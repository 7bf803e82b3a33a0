// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/gimbal_plant.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Vec3;

GimbalPlant::GimbalPlant(const GimbalPlantParameters& parameters) noexcept
    : m_parameters(parameters), m_kinematics(parameters.pivotHeight_m),
      m_encoders(parameters.resolution, parameters.sampleDelay_ticks) {
    m_parameters.substeps = std::max(parameters.substeps, 4);
    reset(m_q);
}

void GimbalPlant::reset(const GimbalCoordinates& q) noexcept {
    m_q = q;
    m_rates.setZero();
    m_target.setZero();
    m_motor.setZero();
    m_feedForward.setZero();
    m_measured_D.setZero();
    m_saturated = false;
    for (LugreFriction& friction : m_friction)
        friction.reset();
    updateTip();
    m_encoders.settle(coordinates());
}

GimbalVector GimbalPlant::inertia(const GimbalCoordinates& q) const noexcept {
    const double s = q.d - m_parameters.centreOfMassBehindTip_m;
    const double across = m_parameters.instrumentMass_kg * s * s + m_parameters.instrumentInertia_kgm2;
    const double cp = std::cos(q.p);
    return {across * cp * cp + m_parameters.axisInertia[0], across + m_parameters.axisInertia[1],
            m_parameters.axisInertia[2], m_parameters.instrumentMass_kg + m_parameters.axisInertia[3]};
}

GimbalVector GimbalPlant::gravity(const GimbalCoordinates& q) const noexcept {
    const double weight = m_parameters.instrumentMass_kg * core::kStandardGravity;
    const double s = q.d - m_parameters.centreOfMassBehindTip_m;
    const double sh = std::sin(q.h), ch = std::cos(q.h), sp = std::sin(q.p), cp = std::cos(q.p);
    return {weight * s * sh * cp, weight * s * ch * sp, 0.0,
            weight * (m_parameters.counterbalance - ch * cp)};
}

double GimbalPlant::energy_J() const noexcept {
    const double weight = m_parameters.instrumentMass_kg * core::kStandardGravity;
    const double s = m_q.d - m_parameters.centreOfMassBehindTip_m;
    const double kinetic = 0.5 * m_rates.dot(inertia(m_q).cwiseProduct(m_rates));
    double energy = kinetic - weight * s * m_ch * m_cp + weight * m_parameters.counterbalance * m_q.d;
    for (std::size_t axis = 0; axis < m_friction.size(); ++axis)
        energy += m_friction[axis].energy_J(m_parameters.friction[axis]);
    return energy;
}

GimbalCoordinates GimbalPlant::sensed() const noexcept {
    const auto q = m_encoders.sensed();
    return {q[0], q[1], q[2], q[3]};
}

void GimbalPlant::beginTick(const GimbalVector& renderEfforts, bool enabled) noexcept {
    m_saturated = false;
    m_feedForward.setZero();
    m_target.setZero();
    if (!enabled)
        return;
    if (m_parameters.gravityFeedForward)
        m_feedForward = gravity(sensed());
    for (int axis = 0; axis < 4; ++axis) {
        const double limit =
            m_parameters.currentLimit_A * m_parameters.effortPerAmpere[static_cast<std::size_t>(axis)];
        const double wanted = renderEfforts[axis] + m_feedForward[axis];
        m_target[axis] = std::clamp(wanted, -limit, limit);
        m_saturated = m_saturated || (limit > 0.0 && std::abs(wanted) > limit);
    }
}

GimbalVector GimbalPlant::coriolisAndWeight(double across, double acrossPerMetre) const noexcept {
    const double weight = m_parameters.instrumentMass_kg * core::kStandardGravity;
    const double s = m_q.d - m_parameters.centreOfMassBehindTip_m;
    const double hd = m_rates[0], pd = m_rates[1], dd = m_rates[3];
    const double dMhdp = -2.0 * across * m_cp * m_sp;
    return {(dMhdp * pd + acrossPerMetre * m_cp * m_cp * dd) * hd + weight * s * m_sh * m_cp,
            acrossPerMetre * dd * pd - 0.5 * dMhdp * hd * hd + weight * s * m_ch * m_sp, 0.0,
            -0.5 * acrossPerMetre * (m_cp * m_cp * hd * hd + pd * pd) +
                weight * (m_parameters.counterbalance - m_ch * m_cp)};
}

void GimbalPlant::integrate(double dt_s, const Vec3& f_T_D) noexcept {
    const auto& a = m_parameters;
    const double lag = a.amplifierLag_s > 0.0 ? dt_s / (dt_s + a.amplifierLag_s) : 1.0;
    m_motor += lag * (m_target - m_motor);

    const double s = m_q.d - a.centreOfMassBehindTip_m;
    const double across = a.instrumentMass_kg * s * s + a.instrumentInertia_kgm2;
    const GimbalVector inertiaNow{across * m_cp * m_cp + a.axisInertia[0], across + a.axisInertia[1],
                                  a.axisInertia[2], a.instrumentMass_kg + a.axisInertia[3]};
    const GimbalVector fromHand{m_q.d * m_cp * m_alongHeading_D.dot(f_T_D), m_q.d * m_alongPitch_D.dot(f_T_D),
                                0.0, m_alongDepth_D.dot(f_T_D)};
    const GimbalVector effort = m_motor + fromHand - coriolisAndWeight(across, 2.0 * a.instrumentMass_kg * s);
    for (int axis = 0; axis < 4; ++axis) {
        const LugreParameters& friction = a.friction[static_cast<std::size_t>(axis)];
        const double bristle =
            m_friction[static_cast<std::size_t>(axis)].advance(friction, m_rates[axis], dt_s);
        m_rates[axis] = (m_rates[axis] + dt_s * (effort[axis] + bristle) / inertiaNow[axis]) /
                        (1.0 + friction.viscous * dt_s / inertiaNow[axis]);
    }
    m_q.h += dt_s * m_rates[0];
    m_q.p += dt_s * m_rates[1];
    m_q.r += dt_s * m_rates[2];
    m_q.d += dt_s * m_rates[3];
    stopAtEnds();
    updateTip();
}

void GimbalPlant::stopAtEnds() noexcept {
    const std::array<double*, 4> coordinate{&m_q.h, &m_q.p, &m_q.r, &m_q.d};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        double& value = *coordinate[axis];
        if (value < m_parameters.minimum[axis] || value > m_parameters.maximum[axis]) {
            value = std::clamp(value, m_parameters.minimum[axis], m_parameters.maximum[axis]);
            m_rates[static_cast<int>(axis)] = 0.0; // a rigid, perfectly inelastic stop
        }
    }
}

void GimbalPlant::updateTip() noexcept {
    m_sh = std::sin(m_q.h);
    m_ch = std::cos(m_q.h);
    m_sp = std::sin(m_q.p);
    m_cp = std::cos(m_q.p);
    m_alongHeading_D = GimbalKinematics::directionToD({m_ch, 0.0, -m_sh});
    m_alongPitch_D = GimbalKinematics::directionToD({-m_sh * m_sp, m_cp, -m_ch * m_sp});
    m_alongDepth_D = GimbalKinematics::directionToD({m_sh * m_cp, m_sp, m_ch * m_cp});
    m_p_DT = m_q.d * m_alongDepth_D;
    m_p_DT.z() += m_parameters.pivotHeight_m;
    m_v_DT = (m_q.d * m_cp * m_rates[0]) * m_alongHeading_D + (m_q.d * m_rates[1]) * m_alongPitch_D +
             m_rates[3] * m_alongDepth_D;
}

void GimbalPlant::endTick() noexcept {
    m_encoders.push(coordinates());
    m_measured_D = GimbalKinematics::force_D(m_q, m_motor - m_feedForward);
}

ToolMotion GimbalPlant::motion() const noexcept {
    ToolMotion motion;
    motion.p_DT = m_p_DT;
    motion.v_DT = m_v_DT;
    return motion;
}

} // namespace chiron::mechanisms
