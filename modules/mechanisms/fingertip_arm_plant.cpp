// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_arm_plant.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Vec3;

namespace {
constexpr int kJoints = FingertipArmParameters::kJoints;
constexpr int kArm = FingertipArmParameters::kArm;
constexpr int kHandle = FingertipArmParameters::kHandle;
constexpr int kJaw = FingertipArmParameters::kJaw;

std::int32_t countOf(double value, double resolution) noexcept {
    return static_cast<std::int32_t>(std::floor(value / resolution + 0.5));
}
} // namespace

FingertipArmPlant::FingertipArmPlant(const FingertipArmParameters& parameters, std::uint64_t seed) noexcept
    : m_parameters(parameters), m_dynamics(fingertipArmLinks(parameters)), m_seed(seed),
      m_random(core::Random::stream(seed, "fingertip/arm")), m_imu(parameters.imu, seed) {
    m_parameters.substeps = std::max(parameters.substeps, 4);
    reset(0.5 * (parameters.boxMinimum_m + parameters.boxMaximum_m));
}

void FingertipArmPlant::reset(const Vec3& p_DT) noexcept {
    ArmPosture posture = fingertipArmPosture(m_parameters, p_DT, core::Quat::Identity());
    if (posture.reach != ArmReach::reached)
        posture =
            fingertipArmPosture(m_parameters, 0.5 * (m_parameters.boxMinimum_m + m_parameters.boxMaximum_m),
                                core::Quat::Identity());
    m_q = posture.q;
    m_rates.setZero();
    m_velocityBefore.setZero();
    m_fingers_rad = 0.0;
    m_dynamics.place(m_q);
    for (LugreFriction& friction : m_friction)
        friction.reset();
    m_random = core::Random::stream(m_seed, "fingertip/arm");
    for (auto& phases : m_runoutPhase_rad)
        for (double& phase : phases)
            phase = m_random.uniform(0.0, 2.0 * core::kPi);
    m_imu.reset(motion().q_DT);
    readEncoders();
}

FingertipArmJoints FingertipArmPlant::stopTorques() const noexcept {
    FingertipArmJoints tau = FingertipArmJoints::Zero();
    for (int joint = 0; joint < kJoints; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        const double beyond =
            m_q[joint] - std::clamp(m_q[joint], m_parameters.minimum[i], m_parameters.maximum[i]);
        if (beyond == 0.0)
            continue;
        const double inwards = beyond * m_rates[joint] > 0.0 ? m_rates[joint] : 0.0; // no pull on the way out
        tau[joint] = -m_parameters.stopStiffness[i] * beyond - m_parameters.stopDamping[i] * inwards;
    }
    return tau;
}

void FingertipArmPlant::step(double dt_s, const core::Wrench& onTool_D) noexcept {
    const FingertipArmParameters& p = m_parameters;
    FingertipArmDynamics::Matrix inertia = m_dynamics.inertia();
    FingertipArmJoints load = m_dynamics.efforts(kHandle, place(), onTool_D) + stopTorques() -
                              m_dynamics.inverseDynamics(m_rates, FingertipArmJoints::Zero(),
                                                         (1.0 - p.counterbalance) * core::kStandardGravity);
    load[kJaw] += p.fingerStiffness_Nm_per_rad * (m_fingers_rad - m_q[kJaw]);
    for (int joint = 0; joint < kJoints; ++joint)
        load[joint] += m_friction[static_cast<std::size_t>(joint)].advance(
            p.friction[static_cast<std::size_t>(joint)], m_rates[joint], dt_s);
    // (M + dt D) q̇⁺ = M q̇ + dt τ: implicit viscosity never makes energy, however light a joint is.
    const FingertipArmJoints momentum = inertia * m_rates + dt_s * load;
    for (int joint = 0; joint < kJoints; ++joint)
        inertia(joint, joint) += dt_s * p.friction[static_cast<std::size_t>(joint)].viscous;
    inertia(kJaw, kJaw) += dt_s * p.fingerDamping_Nms_per_rad;
    m_rates = FingertipArmDynamics::solve(inertia, momentum);
    m_q += dt_s * m_rates;
    m_dynamics.place(m_q);
}

ToolMotion FingertipArmPlant::motion() const noexcept {
    ToolMotion motion;
    motion.p_DT = place();
    motion.q_DT = core::Quat(m_dynamics.orientation(kHandle));
    m_dynamics.velocity(kHandle, motion.p_DT, m_rates, motion.v_DT, motion.w_DT);
    return motion;
}

void FingertipArmPlant::endTick() noexcept {
    const ToolMotion now = motion();
    m_imu.tick(now.q_DT, now.w_DT, (now.v_DT - m_velocityBefore) / core::kTickSeconds);
    m_velocityBefore = now.v_DT;
    readEncoders();
}

void FingertipArmPlant::readEncoders() noexcept {
    const double resolution = m_parameters.encoderResolution_rad();
    for (int joint = 0; joint < kArm; ++joint) {
        const double q = m_q[joint];
        const auto& phase = m_runoutPhase_rad[joint];
        const double seen = q + m_parameters.encoderRunout_rad[0] * std::sin(q + phase[0]) +
                            m_parameters.encoderRunout_rad[1] * std::sin(2.0 * q + phase[1]) +
                            m_parameters.encoderNoise_counts * resolution * m_random.normal();
        m_counts[static_cast<std::size_t>(joint)] = countOf(seen, resolution);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_counts[axis + kArm] = m_imu.counts()[axis];
    m_jawCounts =
        std::clamp(countOf(m_q[kJaw], m_parameters.grasp.resolution_rad()), 0, m_parameters.grasp.steps);
}

double FingertipArmPlant::energy_J() const noexcept {
    double energy = 0.5 * m_rates.dot(m_dynamics.inertia() * m_rates) +
                    (1.0 - m_parameters.counterbalance) * m_dynamics.potential_J();
    for (int joint = 0; joint < kJoints; ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        const double beyond =
            m_q[joint] - std::clamp(m_q[joint], m_parameters.minimum[i], m_parameters.maximum[i]);
        energy += m_friction[i].energy_J(m_parameters.friction[i]) +
                  0.5 * m_parameters.stopStiffness[i] * beyond * beyond;
    }
    const double pinch = m_fingers_rad - m_q[kJaw];
    return energy + 0.5 * m_parameters.fingerStiffness_Nm_per_rad * pinch * pinch;
}

double FingertipArmPlant::apparent(bool turning) const noexcept {
    const FingertipArmDynamics::Jacobian j = m_dynamics.jacobian(kHandle, place());
    const FingertipArmDynamics::Matrix inertia = m_dynamics.inertia();
    core::Mat3 mobility; // J M⁻¹ Jᵀ of one half
    for (int column = 0; column < 3; ++column) {
        const FingertipArmJoints row = j.row(column + (turning ? 3 : 0)).transpose();
        const FingertipArmJoints moved = FingertipArmDynamics::solve(inertia, row);
        for (int other = 0; other < 3; ++other)
            mobility(other, column) = j.row(other + (turning ? 3 : 0)).dot(moved);
    }
    return mobility.inverse().trace() / 3.0;
}

double FingertipArmPlant::apparentMass_kg() const noexcept {
    return apparent(false);
}
double FingertipArmPlant::apparentInertia_kgm2() const noexcept {
    return apparent(true);
}

} // namespace chiron::mechanisms
