// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "mechanisms/fingertip_plant.h"
#include "mechanisms/markov_noise.h"

#include <array>
#include <cstdint>

namespace chiron::mechanisms {

/// Three force-sensitive resistors under the plate, each in a voltage divider in front of the converter
/// (P3 §2.1):
///   conductance ∝ (load with hysteresis and creep)^p,  V/3.3 V = x/(1 + x),  x = divider · gain · load^p.
/// The voltage is counted in 2^bits steps and converted back as the host does, which knows the divider but
/// neither the gain error nor p. The plate rests on the three like a tripod, so that a force F at (u, v)
/// loads sensor i with F(1/3 + ⅔ (u, v)·e_i/r). Readings come every `period_ticks`, `delay_ticks` late.
/// Thread: haptic; allocates nothing.
class FingertipForceSensors {
public:
    FingertipForceSensors(const FingertipForceSensorParameters& parameters, std::uint64_t seed) noexcept;

    void reset() noexcept; ///< unloaded for a long time, and tared
    /// Runs one tick with the force on the plate and its position. Returns true if a reading is new.
    bool tick(double force_N, const core::Vec2& place_m) noexcept;

    /// Sum of the three, as the host knows it.
    double force_N() const noexcept { return m_line[index(m_p.delay_ticks)]; }
    const std::array<int, 3>& counts() const noexcept { return m_counts; } ///< newest
    double resolution_N(double load_N) const noexcept; ///< newtons per count of one sensor at a load on it
    int fullScale() const noexcept { return (1 << m_p.adcBits) - 1; }

private:
    static constexpr int kLine = 64;
    std::size_t index(int ticksAgo) const noexcept {
        return static_cast<std::size_t>((m_now + kLine - ticksAgo) % kLine);
    }
    int countsFor(std::size_t sensor, double load_N, double noise_counts) const noexcept;
    double loadOf(int counts) const noexcept;

    FingertipForceSensorParameters m_p;
    std::uint64_t m_seed;
    core::Random m_random;
    struct Sensor {
        double gain = 1.0, exponent = 1.0;
        double turn = 0.0; ///< position in its hysteresis, −1..1
        double late = 0.0; ///< load that creep has followed so far
        double before = 0.0;
        double tare_N = 0.0;
    };
    std::array<Sensor, 3> m_sensor{};
    std::array<int, 3> m_counts{};
    std::array<double, kLine> m_line{};
    int m_now = 0;
    int m_until = 0;
};

/// Pitch and roll of the platform from its own IMU: constant bias, noise, at its own rate. Its errors are
/// independent of those of the handle's IMU (attitude_sensor.h) with the same seed.
class FingertipImu {
public:
    FingertipImu(const FingertipImuParameters& parameters, std::uint64_t seed) noexcept;
    void reset() noexcept;
    void tick(const FingertipPose& pose) noexcept;
    double pitch_rad() const noexcept { return m_pitch; }
    double roll_rad() const noexcept { return m_roll; }

private:
    FingertipImuParameters m_p;
    std::uint64_t m_seed;
    core::Random m_random;
    std::array<MarkovNoise, 2> m_noise{};
    std::array<double, 2> m_bias{};
    double m_pitch = 0.0, m_roll = 0.0;
    int m_until = 0;
};

} // namespace chiron::mechanisms
