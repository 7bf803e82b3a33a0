// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/velocity_estimator.h"

#include <algorithm>

namespace chiron::simulation {

namespace {

constexpr double kMicrosecondsPerSecond = 1e6;
static_assert((VelocityEstimator::kCapacity & (VelocityEstimator::kCapacity - 1)) == 0, "ring index by mask");

/// The slopes (counts/µs, as a fraction with a positive denominator) that keep a line through the newest
/// sample within the noise bound of every sample seen so far: lower/age ≤ slope ≤ upper/age.
struct SlopeBound {
    std::int64_t numerator = 0;
    std::int64_t age_us = 0; ///< 0: no bound yet
};

/// Sums for the least-squares line of displacement (counts before the newest) against age (µs).
struct LineSums {
    std::int64_t n = 1; ///< the newest sample itself, at (0, 0)
    std::int64_t age = 0;
    std::int64_t displacement = 0;
    std::int64_t product = 0;
    std::int64_t ageSquared = 0;

    void add(std::int64_t age_us, std::int64_t counts) noexcept {
        ++n;
        age += age_us;
        displacement += counts;
        product += age_us * counts;
        ageSquared += age_us * age_us;
    }
    double slope() const noexcept {
        const std::int64_t numerator = n * product - age * displacement;
        const std::int64_t denominator = n * ageSquared - age * age;
        return denominator == 0 ? 0.0 : static_cast<double>(numerator) / static_cast<double>(denominator);
    }
};

} // namespace

VelocityEstimator::VelocityEstimator(int coordinates) noexcept
    : m_coordinates(std::clamp(coordinates, 1, core::kMaxCoordinates)) {}

void VelocityEstimator::reset() noexcept {
    m_size = 0;
    m_rates.fill(0.0);
}

const VelocityEstimator::Entry& VelocityEstimator::entry(int age) const noexcept {
    return m_history[static_cast<std::size_t>((m_newest - age) & (kCapacity - 1))];
}

const VelocityEstimator::Rates& VelocityEstimator::update(const core::DeviceSample& sample) noexcept {
    if ((sample.status & core::sample_status::kInvalid) != 0)
        return m_rates;
    if (m_size > 0) {
        // Serial-number arithmetic: the packet counter may wrap round.
        if (static_cast<std::int32_t>(sample.packet - m_packet) <= 0)
            return m_rates;
        if (sample.deviceTime_us <= entry(0).time_us)
            reset();
    }
    push(sample);
    for (int axis = 0; axis < m_coordinates; ++axis)
        m_rates[static_cast<std::size_t>(axis)] = slope(axis);
    return m_rates;
}

void VelocityEstimator::push(const core::DeviceSample& sample) noexcept {
    m_newest = (m_newest + 1) & (kCapacity - 1);
    m_history[static_cast<std::size_t>(m_newest)] = {sample.deviceTime_us, sample.counts};
    m_packet = sample.packet;
    m_size = std::min(m_size + 1, kCapacity);
    // After a gap of more than the window this leaves the newest sample alone.
    while (sample.deviceTime_us - entry(m_size - 1).time_us > kWindow_us)
        --m_size;
}

double VelocityEstimator::slope(int axis) const noexcept {
    const auto column = static_cast<std::size_t>(axis);
    const Entry& newest = entry(0);
    SlopeBound lower;
    SlopeBound upper;
    LineSums sums;
    for (int i = 1; i < m_size; ++i) {
        const Entry& past = entry(i);
        const auto age = static_cast<std::int64_t>(newest.time_us - past.time_us);
        const std::int64_t moved = static_cast<std::int64_t>(newest.counts[column]) - past.counts[column];
        if (lower.age_us > 0 &&
            (moved * lower.age_us < lower.numerator * age || moved * upper.age_us > upper.numerator * age))
            break; // the line from here to the newest sample would miss a sample between them by more than
                   // the bound
        sums.add(age, moved);
        const std::int64_t least = moved - kNoiseBound_counts;
        const std::int64_t most = moved + kNoiseBound_counts;
        if (lower.age_us == 0 || least * lower.age_us > lower.numerator * age)
            lower = {least, age};
        if (upper.age_us == 0 || most * upper.age_us < upper.numerator * age)
            upper = {most, age};
    }
    return sums.slope() * kMicrosecondsPerSecond;
}

} // namespace chiron::simulation
