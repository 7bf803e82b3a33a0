// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/five_bar_plant.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

namespace {

constexpr int kAxes = static_cast<int>(FiveBarPlantParameters::kAxes);
using PerAxis = FiveBarPlantParameters::PerAxis;

PerAxis toValues(const FiveBarVector& v) noexcept {
    return {v[0], v[1], v[2], v[3], v[4]};
}
FiveBarVector toVector(const PerAxis& values) noexcept {
    FiveBarVector v;
    v << values[0], values[1], values[2], values[3], values[4];
    return v;
}

} // namespace

FiveBarPlant::FiveBarPlant(const FiveBarPlantParameters& parameters) noexcept
    : m_parameters(parameters), m_dynamics(parameters), m_host(parameters),
      m_encoders(parameters.resolution, parameters.sampleDelay_ticks) {
    m_parameters.substeps = std::max(parameters.substeps, 4);
    reset(0.5 * (toVector(parameters.minimum) + toVector(parameters.maximum)));
}

void FiveBarPlant::reset(const FiveBarVector& q) noexcept {
    m_q = m_motorAngle = q;
    m_rates.setZero();
    m_motorRate.setZero();
    m_target.setZero();
    m_motor.setZero();
    m_feedForward.setZero();
    m_measured_D = {};
    m_saturated = false;
    for (LugreFriction& friction : m_friction)
        friction.reset();
    m_dynamics.place(q);
    m_encoders.settle(toValues(q));
}

void FiveBarPlant::beginTick(const AxisEfforts& render, bool enabled) noexcept {
    m_saturated = false;
    m_feedForward.setZero();
    m_target.setZero();
    if (!enabled)
        return;
    if (m_parameters.gravityFeedForward) {
        m_host.place(toVector(m_encoders.sensed()));
        m_feedForward = (1.0 - m_parameters.counterbalance) * m_host.gravity();
    }
    for (int axis = 0; axis < kAxes; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double limit = m_parameters.renderLimit[i];
        const double reserve = m_parameters.gravityReserve[i];
        m_feedForward[axis] = std::clamp(m_feedForward[axis], -reserve, reserve);
        m_target[axis] = std::clamp(render[i], -limit, limit) + m_feedForward[axis];
        m_saturated = m_saturated || std::abs(render[i]) > limit;
    }
}

double FiveBarPlant::beyondStop(int axis) const noexcept {
    const auto i = static_cast<std::size_t>(axis);
    return m_q[axis] - std::clamp(m_q[axis], m_parameters.minimum[i], m_parameters.maximum[i]);
}

FiveBarVector FiveBarPlant::stopTorques() const noexcept {
    FiveBarVector tau = FiveBarVector::Zero();
    for (int axis = 0; axis < kAxes; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double beyond = beyondStop(axis);
        if (beyond == 0.0)
            continue;
        const double inwards = beyond * m_rates[axis] > 0.0 ? m_rates[axis] : 0.0; // no pull on the way out
        tau[axis] = -m_parameters.stopStiffness[i] * beyond - m_parameters.stopDamping[i] * inwards;
    }
    return tau;
}

void FiveBarPlant::step(double dt_s, const core::Wrench& onTool_D) noexcept {
    const FiveBarPlantParameters& p = m_parameters;
    const double lag = p.amplifierLag_s > 0.0 ? dt_s / (dt_s + p.amplifierLag_s) : 1.0;
    m_motor += lag * (m_target - m_motor);

    FiveBarVector tendon;
    for (int axis = 0; axis < kAxes; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        tendon[axis] = p.tendonStiffness[i] * (m_motorAngle[axis] - m_q[axis]) +
                       p.tendonDamping[i] * (m_motorRate[axis] - m_rates[axis]);
        const double bristle = m_friction[i].advance(p.friction[i], m_motorRate[axis], dt_s);
        m_motorRate[axis] =
            (m_motorRate[axis] + dt_s * (m_motor[axis] - tendon[axis] + bristle) / p.rotorInertia[i]) /
            (1.0 + p.friction[i].viscous * dt_s / p.rotorInertia[i]);
    }
    const FiveBarVector load = tendon + stopTorques() + m_dynamics.efforts(onTool_D) -
                               m_dynamics.bias(m_rates) - (1.0 - p.counterbalance) * m_dynamics.gravity();
    m_rates += dt_s * FiveBarDynamics::solve(m_dynamics.inertia(), load);
    m_q += dt_s * m_rates;
    m_motorAngle += dt_s * m_motorRate;
    m_dynamics.place(m_q);
}

void FiveBarPlant::endTick() noexcept {
    m_encoders.push(toValues(m_motorAngle));
    m_measured_D = m_dynamics.wrench_D(m_motor - m_feedForward);
}

ToolMotion FiveBarPlant::motion() const noexcept {
    const SphericalJoint& joint = m_dynamics.joint();
    const FiveBarLoop& loop = m_dynamics.loop();
    return {FiveBarKinematics::toD(loop.tip), joint.orientation_DT(),
            FiveBarKinematics::toD(loop.jacobian * m_rates.head<2>()),
            joint.angularVelocity_D(m_rates.tail<3>())};
}

double FiveBarPlant::energy_J() const noexcept {
    double energy = 0.5 * m_rates.dot(m_dynamics.inertia() * m_rates) +
                    (1.0 - m_parameters.counterbalance) * m_dynamics.potential_J();
    for (int axis = 0; axis < kAxes; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double stretch = m_motorAngle[axis] - m_q[axis];
        const double beyond = beyondStop(axis);
        energy += 0.5 * (m_parameters.tendonStiffness[i] * stretch * stretch +
                         m_parameters.rotorInertia[i] * m_motorRate[axis] * m_motorRate[axis] +
                         m_parameters.stopStiffness[i] * beyond * beyond) +
                  m_friction[i].energy_J(m_parameters.friction[i]);
    }
    return energy;
}

} // namespace chiron::mechanisms
