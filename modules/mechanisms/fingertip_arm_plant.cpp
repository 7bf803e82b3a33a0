// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_arm_plant.h"

#include "core/units.h"
#include "mechanisms/rotation_vector.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Vec3;

namespace {
std::int32_t count(double value, double resolution) noexcept {
    return static_cast<std::int32_t>(std::floor(value / resolution + 0.5));
}
} // namespace

FingertipArmPlant::FingertipArmPlant(const FingertipArmParameters& parameters, std::uint64_t seed) noexcept
    : m_parameters(parameters), m_seed(seed), m_random(core::Random::stream(seed, "fingertip/arm")) {
    m_parameters.substeps = std::max(parameters.substeps, 4);
    m_parameters.imuPeriod_ticks = std::max(parameters.imuPeriod_ticks, 1);
    reset(Vec3::Zero());
}

void FingertipArmPlant::reset(const Vec3& p_DT) noexcept {
    m_motion = {};
    m_motion.p_DT = p_DT;
    m_random = core::Random::stream(m_seed, "fingertip/arm");
    for (LugreFriction& friction : m_friction)
        friction.reset();
    const double dt = core::kTickSeconds * m_parameters.imuPeriod_ticks;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_noise[axis] = MarkovNoise(m_parameters.imuNoise_rad, m_parameters.imuNoiseTime_s, dt, m_random);
        m_drift[axis] = MarkovNoise(m_parameters.imuDrift_rad, m_parameters.imuDriftTime_s, dt, m_random);
    }
    m_sinceImu = 0;
    readImu();
    readEncoders();
}

void FingertipArmPlant::step(double dt_s, const core::Wrench& onTool_D) noexcept {
    const FingertipArmParameters& a = m_parameters;
    for (int axis = 0; axis < 3; ++axis) {
        double& v = m_motion.v_DT[axis];
        double& p = m_motion.p_DT[axis];
        const double bristle = m_friction[static_cast<std::size_t>(axis)].advance(a.friction, v, dt_s);
        v = (v + dt_s / a.mass_kg * (onTool_D.force[axis] + bristle)) / (1.0 + dt_s * a.friction.viscous / a.mass_kg);
        p += dt_s * v;
        const double inside = std::clamp(p, a.minimum_m[axis], a.maximum_m[axis]);
        if (inside != p) { // the end of the travel
            p = inside;
            v = 0.0;
        }
    }
    m_motion.w_DT = (m_motion.w_DT + dt_s / a.inertia_kgm2 * onTool_D.torque) /
                    (1.0 + dt_s * a.turningViscous_Nms_per_rad / a.inertia_kgm2);
    m_motion.q_DT = turned(m_motion.q_DT, dt_s * m_motion.w_DT);
}

void FingertipArmPlant::endTick() noexcept {
    readEncoders();
    if (++m_sinceImu < m_parameters.imuPeriod_ticks)
        return;
    m_sinceImu = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_noise[axis].advance(m_random);
        m_drift[axis].advance(m_random);
    }
    readImu();
}

void FingertipArmPlant::readEncoders() noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_counts[axis] = count(m_motion.p_DT[static_cast<int>(axis)], m_parameters.resolution_m);
}

void FingertipArmPlant::readImu() noexcept {
    const Vec3 turn = rotationVectorOf(m_motion.q_DT);
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_counts[axis + 3] = count(turn[static_cast<int>(axis)] + m_noise[axis].value() + m_drift[axis].value(),
                                   m_parameters.imuResolution_rad);
}

double FingertipArmPlant::energy_J() const noexcept {
    double bristles = 0.0;
    for (const LugreFriction& friction : m_friction)
        bristles += m_parameters.friction.bristleStiffness * friction.bristle() * friction.bristle();
    return 0.5 * (m_parameters.mass_kg * m_motion.v_DT.squaredNorm() +
                  m_parameters.inertia_kgm2 * m_motion.w_DT.squaredNorm() + bristles);
}

} // namespace chiron::mechanisms
