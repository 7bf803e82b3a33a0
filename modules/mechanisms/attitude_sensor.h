// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "core/units.h"
#include "mechanisms/markov_noise.h"

#include <array>
#include <cstdint>

namespace chiron::mechanisms {

/// Parameters of a nine-axis inertial measurement unit (IMU) on the handle and of the filter that computes an
/// attitude from it. P3 names no part. The figures are those of Bosch's BNO055 (data sheet BST-BNO055-DS000:
/// rate noise 0.014 °/s/√Hz, acceleration noise 150 µg/√Hz, 100 Hz of acceleration and 20 Hz of magnetic
/// field into the fusion, quaternion of 2¹⁴ counts). The errors that calibration leaves and the gains of the
/// filter are ASSUMPTIONS.
struct AttitudeSensorParameters {
    /// Rates are read every millisecond and propagate the attitude. If it were reported at 100 Hz, each step
    /// would be a spin of 50 rad/s.
    int gyroPeriod_ticks = 1;
    int tiltPeriod_ticks = 10;    ///< acceleration: 100 Hz
    int headingPeriod_ticks = 50; ///< magnetic field: 20 Hz
    double rateNoise_rad_per_s_rtHz = core::radFromDeg(0.014);
    double rateBias_rad_per_s = core::radFromDeg(0.02); ///< SD per axis, left by calibration at rest
    double accelerationNoise_m_per_s2_rtHz = 150e-6 * core::kStandardGravity;
    double accelerationBias_m_per_s2 = 5e-3 * core::kStandardGravity; ///< SD per axis, likewise: 0.3° of tilt
    double headingError_rad = 8.7e-3; ///< SD of the magnetic field's direction indoors, 0.5°, slow
    double headingTime_s = 60.0;
    /// Gain with which tilt and heading correct the attitude: low, since a moving hand accelerates too.
    double gain_per_s = 0.2;
    double resolution_rad = 2.0 / 16384.0; ///< of the reported rotation vector: a quaternion of 2¹⁴ counts
};

/// The sensor. It reads rates, specific force and heading, each at its own rate, holds them in between, and
/// fuses them with a complementary filter (Mahony, Hamel & Pflimlin 2008, "Nonlinear complementary filters on
/// the special orthogonal group", eq. 32, without the integral):
///   q̂˙ = ½ q̂ ω_m + gain · (the rotation from the measured down and heading to those of q̂).
/// It starts aligned except for its errors. The same seed gives the same readings.
/// Frame: D, z up.
/// Thread: haptic; allocates nothing.
class AttitudeSensor {
public:
    AttitudeSensor(const AttitudeSensorParameters& parameters, std::uint64_t seed) noexcept;
    void reset(const core::Quat& q_DT) noexcept; ///< starts at rest at this attitude
    /// Advances by one tick. The arguments are the true values at its end; `a_D` is the handle's mean
    /// acceleration over the tick, m/s².
    void tick(const core::Quat& q_DT, const core::Vec3& w_DT, const core::Vec3& a_D) noexcept;

    /// The rotation vector of q̂.
    const std::array<std::int32_t, 3>& counts() const noexcept { return m_counts; }
    const core::Quat& attitude() const noexcept { return m_attitude; }
    const core::Vec3& rate_T() const noexcept { return m_rate_T; } ///< as last read, rad/s, T
    /// Specific force as last read, m/s², T.
    const core::Vec3& acceleration_T() const noexcept { return m_specific_T; }

private:
    core::Vec3 noise(double sd) noexcept {
        return {sd * m_random.normal(), sd * m_random.normal(), sd * m_random.normal()};
    }
    void readTilt(const core::Quat& q_DT, const core::Vec3& a_D) noexcept;
    void readHeading(const core::Quat& q_DT) noexcept;
    void tell() noexcept;

    AttitudeSensorParameters m_parameters;
    std::uint64_t m_seed;
    core::Random m_random;
    core::Vec3 m_rateBias = core::Vec3::Zero(), m_accelerationBias = core::Vec3::Zero();
    MarkovNoise m_heading;
    core::Quat m_attitude = core::Quat::Identity();
    core::Vec3 m_rate_T = core::Vec3::Zero(), m_specific_T = core::Vec3::Zero();
    core::Vec3 m_tilt_T = core::Vec3::Zero(),
               m_turn_T = core::Vec3::Zero(); ///< corrections as last computed, rad
    std::array<std::int32_t, 3> m_counts{};
    int m_sinceGyro = 0, m_sinceTilt = 0, m_sinceHeading = 0;
};

} // namespace chiron::mechanisms
