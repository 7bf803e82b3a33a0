// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/latency_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace chiron::haptics {

namespace {
constexpr int kSub = 1 << LatencyHistogram::kSubBits;
constexpr int kLinear = 2 * kSub; // below this every value has its own bucket
} // namespace

int LatencyHistogram::bucketOf(std::int64_t value_ns) noexcept {
    if (value_ns < kLinear)
        return value_ns < 0 ? 0 : static_cast<int>(value_ns);
    const auto value = static_cast<std::uint64_t>(value_ns);
    const int exponent =
        static_cast<int>(std::bit_width(value)) - 1; // value is in [2^exponent, 2^(exponent+1))
    const int sub = static_cast<int>(value >> (exponent - kSubBits)) - kSub;
    return std::min(kLinear + (exponent - kSubBits - 1) * kSub + sub, kBuckets - 1);
}

std::int64_t LatencyHistogram::upperEdge_ns(int bucket) noexcept {
    if (bucket < kLinear)
        return bucket;
    const int exponent = (bucket - kLinear) / kSub + kSubBits + 1;
    const std::int64_t sub = (bucket - kLinear) % kSub;
    return ((kSub + sub + 1) << (exponent - kSubBits)) - 1;
}

void LatencyHistogram::add(std::int64_t value_ns) noexcept {
    ++m_counts[static_cast<std::size_t>(bucketOf(value_ns))];
    ++m_count;
    m_maximum_ns = std::max(m_maximum_ns, value_ns);
}

void LatencyHistogram::merge(const LatencyHistogram& other) noexcept {
    for (std::size_t i = 0; i < m_counts.size(); ++i)
        m_counts[i] += other.m_counts[i];
    m_count += other.m_count;
    m_maximum_ns = std::max(m_maximum_ns, other.m_maximum_ns);
}

double LatencyHistogram::percentile_us(double fraction) const noexcept {
    if (m_count == 0)
        return 0.0;
    const auto rank =
        static_cast<std::uint64_t>(std::ceil(std::clamp(fraction, 0.0, 1.0) * static_cast<double>(m_count)));
    const std::uint64_t wanted = std::max<std::uint64_t>(rank, 1);
    std::uint64_t seen = 0;
    for (int i = 0; i < kBuckets - 1; ++i) {
        seen += m_counts[static_cast<std::size_t>(i)];
        if (seen >= wanted)
            return static_cast<double>(std::min(upperEdge_ns(i), m_maximum_ns)) * 1e-3;
    }
    return static_cast<double>(m_maximum_ns) * 1e-3;
}

std::uint64_t LatencyHistogram::countUpTo(std::int64_t limit_ns) const noexcept {
    std::uint64_t seen = 0;
    for (int i = 0; i < kBuckets - 1 && upperEdge_ns(i) <= limit_ns; ++i)
        seen += m_counts[static_cast<std::size_t>(i)];
    return seen;
}

} // namespace chiron::haptics
