// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace chiron::mechanisms {

/// Longest delay until the host sees the counts of a simulated mechanism.
inline constexpr int kMostSampleDelay_ticks = 3;

/// Incremental encoders that are read once per tick, with a delay of 0..kMostSampleDelay_ticks until the host
/// sees the counts.
template <std::size_t Axes> class EncoderLine {
public:
    using Values = std::array<double, Axes>; ///< rad or m
    using Counts = std::array<std::int32_t, Axes>;

    EncoderLine(const Values& resolution, int delay_ticks) noexcept
        : m_resolution(resolution), m_delay(std::clamp(delay_ticks, 0, kLength - 1)) {}

    void settle(const Values& values) noexcept { ///< fills the line as if it had been there for long
        for (Counts& counts : m_line)
            read(values, counts);
    }
    void push(const Values& values) noexcept {
        m_newest = (m_newest + 1) % kLength;
        read(values, m_line[static_cast<std::size_t>(m_newest)]);
    }
    const Counts& counts() const noexcept {
        return m_line[static_cast<std::size_t>((m_newest + kLength - m_delay) % kLength)];
    }
    Values sensed() const noexcept { ///< the coordinates as the host computes them
        Values values;
        for (std::size_t axis = 0; axis < Axes; ++axis)
            values[axis] = counts()[axis] * m_resolution[axis];
        return values;
    }

private:
    static constexpr int kLength = kMostSampleDelay_ticks + 1;
    void read(const Values& values, Counts& counts) const noexcept {
        for (std::size_t axis = 0; axis < Axes; ++axis)
            counts[axis] = static_cast<std::int32_t>(std::floor(values[axis] / m_resolution[axis] + 0.5));
    }

    Values m_resolution;
    int m_delay;
    int m_newest = 0;
    std::array<Counts, kLength> m_line{};
};

} // namespace chiron::mechanisms
