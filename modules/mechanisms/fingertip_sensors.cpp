// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_sensors.h"

namespace chiron::mechanisms {

namespace {
constexpr double kHalfRoot3 = 0.86602540378443864676;
constexpr std::array<double, 3> kAlong{0.5, -1.0, 0.5}; ///< e_i at 60°, 180°, 300°: between the legs
constexpr std::array<double, 3> kAcross{kHalfRoot3, 0.0, -kHalfRoot3};
} // namespace

FingertipForceSensors::FingertipForceSensors(const FingertipForceSensorParameters& parameters,
                                             std::uint64_t seed) noexcept
    : m_p(parameters), m_seed(seed), m_random(seed) {
    m_p.delay_ticks = std::clamp(m_p.delay_ticks, 0, kLine - 1);
    m_p.period_ticks = std::max(m_p.period_ticks, 1);
    m_p.adcBits = std::clamp(m_p.adcBits, 4, 16);
    reset();
}

void FingertipForceSensors::reset() noexcept {
    m_random = core::Random::stream(m_seed, "fingertip/force");
    m_line.fill(0.0);
    m_until = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        Sensor& s = m_sensor[i];
        s = {};
        s.gain = 1.0 + m_p.gainSd * m_random.normal();
        s.exponent = 1.0 + m_p.exponentSd * m_random.normal();
        s.late = s.before = m_p.preload_N;
        // A tare is a mean over many readings, so it is finer than a count.
        double mean = 0.0;
        constexpr int kReadings = 64;
        for (int n = 0; n < kReadings; ++n)
            mean += loadOf(countsFor(i, m_p.preload_N, m_p.adcNoise_counts * m_random.normal())) / kReadings;
        s.tare_N = mean;
        m_counts[i] = countsFor(i, m_p.preload_N, 0.0);
    }
}

int FingertipForceSensors::countsFor(std::size_t sensor, double load_N, double noise_counts) const noexcept {
    const Sensor& s = m_sensor[sensor];
    const double x = m_p.divider_per_N * s.gain * std::pow(std::max(load_N, 0.0), s.exponent);
    const double counts = (1 << m_p.adcBits) * x / (1.0 + x) + noise_counts;
    return static_cast<int>(std::clamp(std::floor(counts + 0.5), 0.0, static_cast<double>(fullScale())));
}

double FingertipForceSensors::loadOf(int counts) const noexcept {
    const double share = static_cast<double>(std::min(counts, fullScale())) / (1 << m_p.adcBits);
    return share / (1.0 - share) / m_p.divider_per_N;
}

double FingertipForceSensors::resolution_N(double load_N) const noexcept {
    const double open = 1.0 + m_p.divider_per_N * load_N;
    return open * open / (m_p.divider_per_N * (1 << m_p.adcBits));
}

bool FingertipForceSensors::tick(double force_N, const core::Vec2& place_m) noexcept {
    const double before = m_line[index(0)];
    m_now = (m_now + 1) % kLine;
    m_line[index(0)] = before;
    std::array<double, 3> share{};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        share[i] = std::max(
            0.0, 1.0 / 3.0 + 2.0 / 3.0 * (kAlong[i] * place_m.x() + kAcross[i] * place_m.y()) / m_p.radius_m);
        sum += share[i]; // beyond the tripod's edge the plate rests on two
    }
    std::array<double, 3> load{};
    for (std::size_t i = 0; i < 3; ++i) {
        Sensor& s = m_sensor[i];
        load[i] = m_p.preload_N + force_N * share[i] / sum;
        const double change = load[i] - s.before;
        s.before = load[i];
        s.turn = (s.turn + change / m_p.hysteresisForce_N) / (1.0 + std::abs(change) / m_p.hysteresisForce_N);
        s.late += core::kTickSeconds / m_p.creepTime_s * (load[i] - s.late);
    }
    if (--m_until > 0)
        return false;
    m_until = m_p.period_ticks;
    double total = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Sensor& s = m_sensor[i];
        // While loading it shows too little, while unloading too much; a static load is shown truly.
        const double shown = load[i] - m_p.hysteresis * (load[i] - m_p.preload_N) * s.turn -
                             m_p.creep * (load[i] - s.late) +
                             m_p.noise_N / std::sqrt(3.0) * m_random.normal();
        m_counts[i] = countsFor(i, shown, m_p.adcNoise_counts * m_random.normal());
        total += loadOf(m_counts[i]) - s.tare_N;
    }
    m_line[index(0)] = total;
    return true;
}

FingertipImu::FingertipImu(const FingertipImuParameters& parameters, std::uint64_t seed) noexcept
    : m_p(parameters), m_seed(seed), m_random(seed) {
    m_p.period_ticks = std::max(m_p.period_ticks, 1);
    reset();
}

void FingertipImu::reset() noexcept {
    m_random = core::Random::stream(m_seed, "fingertip/platform_imu");
    for (double& bias : m_bias)
        bias = m_p.bias_rad * m_random.normal();
    for (MarkovNoise& noise : m_noise)
        noise = MarkovNoise(m_p.noise_rad, m_p.noiseTime_s, core::kTickSeconds * m_p.period_ticks, m_random);
    m_until = 0;
    m_pitch = m_bias[0];
    m_roll = m_bias[1];
}

void FingertipImu::tick(const FingertipPose& pose) noexcept {
    if (--m_until > 0)
        return;
    m_until = m_p.period_ticks;
    m_pitch = pose.pitch_rad + m_bias[0] + m_noise[0].advance(m_random);
    m_roll = pose.roll_rad + m_bias[1] + m_noise[1].advance(m_random);
}

} // namespace chiron::mechanisms
