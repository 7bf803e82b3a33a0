// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace chiron::haptics {

/// Counts durations in logarithmic buckets, 16 per factor of two, so that a percentile is at most 6.25 %
/// above the true one. Below 32 ns every nanosecond has its own bucket; all values from 2³⁵ ns (34 s) on
/// share the last one. Fixed size, trivially copyable.
/// Thread: one at a time; pass copies to others.
class LatencyHistogram {
public:
    static constexpr int kSubBits = 4;
    static constexpr int kBuckets = 32 + (35 - 5) * 16;

    /// Adds a value; negative values count as 0.
    void add(std::int64_t value_ns) noexcept;
    void merge(const LatencyHistogram& other) noexcept;

    std::uint64_t count() const noexcept { return m_count; }
    /// Returns the exact largest value, ns; 0 if empty.
    std::int64_t maximum_ns() const noexcept { return m_maximum_ns; }
    /// Returns the value that a share `fraction` (0..1) of all values does not exceed: the upper edge of its
    /// bucket, at most the maximum. 0 if empty.
    /// Unit: µs.
    double percentile_us(double fraction) const noexcept;
    /// Returns how many values lie in buckets that end at `limit_ns` or below.
    std::uint64_t countUpTo(std::int64_t limit_ns) const noexcept;

private:
    static int bucketOf(std::int64_t value_ns) noexcept;
    static std::int64_t upperEdge_ns(int bucket) noexcept;

    std::array<std::uint64_t, kBuckets> m_counts{};
    std::uint64_t m_count = 0;
    std::int64_t m_maximum_ns = 0;
};

} // namespace chiron::haptics
