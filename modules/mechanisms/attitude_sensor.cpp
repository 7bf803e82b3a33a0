// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/attitude_sensor.h"

#include "mechanisms/rotation_vector.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Quat;
using core::Vec3;

AttitudeSensor::AttitudeSensor(const AttitudeSensorParameters& parameters, std::uint64_t seed) noexcept
    : m_parameters(parameters), m_seed(seed), m_random(core::Random::stream(seed, "fingertip/imu")) {
    m_parameters.gyroPeriod_ticks = std::max(parameters.gyroPeriod_ticks, 1);
    m_parameters.tiltPeriod_ticks = std::max(parameters.tiltPeriod_ticks, 1);
    m_parameters.headingPeriod_ticks = std::max(parameters.headingPeriod_ticks, 1);
    reset(Quat::Identity());
}

void AttitudeSensor::reset(const Quat& q_DT) noexcept {
    const AttitudeSensorParameters& p = m_parameters;
    m_random = core::Random::stream(m_seed, "fingertip/imu");
    m_rateBias = noise(p.rateBias_rad_per_s);
    m_accelerationBias = noise(p.accelerationBias_m_per_s2);
    m_heading = MarkovNoise(p.headingError_rad, p.headingTime_s, core::kTickSeconds * p.headingPeriod_ticks,
                            m_random);
    // After a long rest: the tilt is that of the accelerometer, the heading that of the magnetic field.
    const Vec3 up(0.0, 0.0, 1.0);
    const Vec3 tilt_D = up.cross(q_DT * m_accelerationBias) / core::kStandardGravity;
    m_attitude = turned(q_DT, Vec3(-tilt_D.x(), -tilt_D.y(), m_heading.value()));
    m_rate_T = m_rateBias;
    m_specific_T = q_DT.conjugate() * Vec3(0.0, 0.0, core::kStandardGravity) + m_accelerationBias;
    m_tilt_T.setZero();
    m_turn_T.setZero();
    m_sinceGyro = m_sinceTilt = m_sinceHeading = 0;
    tell();
}

void AttitudeSensor::readTilt(const Quat& q_DT, const Vec3& a_D) noexcept {
    const double bandwidth = 0.5 / (core::kTickSeconds * m_parameters.tiltPeriod_ticks);
    m_specific_T = q_DT.conjugate() * (a_D + Vec3(0.0, 0.0, core::kStandardGravity)) + m_accelerationBias +
                   noise(m_parameters.accelerationNoise_m_per_s2_rtHz * std::sqrt(bandwidth));
    const Vec3 expected_T = m_attitude.conjugate() * Vec3(0.0, 0.0, 1.0);
    const double size = m_specific_T.norm();
    m_tilt_T = size > 0.0 ? Vec3(m_specific_T.cross(expected_T) / size) : Vec3(Vec3::Zero());
}

void AttitudeSensor::readHeading(const Quat& q_DT) noexcept {
    m_heading.advance(m_random);
    // The component of the attitude error about the vertical.
    const Vec3 error_D =
        rotationVectorOf(turned(q_DT, Vec3(0.0, 0.0, m_heading.value())) * m_attitude.conjugate());
    m_turn_T = m_attitude.conjugate() * Vec3(0.0, 0.0, error_D.z());
}

void AttitudeSensor::tick(const Quat& q_DT, const Vec3& w_DT, const Vec3& a_D) noexcept {
    const AttitudeSensorParameters& p = m_parameters;
    if (++m_sinceGyro >= p.gyroPeriod_ticks) {
        m_sinceGyro = 0;
        const double bandwidth = 0.5 / (core::kTickSeconds * p.gyroPeriod_ticks);
        m_rate_T =
            q_DT.conjugate() * w_DT + m_rateBias + noise(p.rateNoise_rad_per_s_rtHz * std::sqrt(bandwidth));
    }
    const Vec3 w_T = m_rate_T + p.gain_per_s * (m_tilt_T + m_turn_T);
    m_attitude = turned(m_attitude, m_attitude * (core::kTickSeconds * w_T));
    if (++m_sinceTilt >= p.tiltPeriod_ticks) {
        m_sinceTilt = 0;
        readTilt(q_DT, a_D);
    }
    if (++m_sinceHeading >= p.headingPeriod_ticks) {
        m_sinceHeading = 0;
        readHeading(q_DT);
    }
    if (m_sinceGyro == 0)
        tell();
}

void AttitudeSensor::tell() noexcept {
    const Vec3 turn = rotationVectorOf(m_attitude);
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_counts[axis] = static_cast<std::int32_t>(
            std::floor(turn[static_cast<int>(axis)] / m_parameters.resolution_rad + 0.5));
}

} // namespace chiron::mechanisms
