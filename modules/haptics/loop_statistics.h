// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/latency_histogram.h"
#include "realtime/tick_task.h"

#include <cstdint>

namespace chiron::haptics {

/// Timing statistics of the loop: lateness and duration of every executed tick, late ticks and skipped
/// deadlines. Trivially copyable: a copy is a snapshot.
/// Thread: the haptic thread writes; others get copies.
class LoopStatistics {
public:
    /// a tick that starts more than 100 µs late counts (speed.md).
    static constexpr std::int64_t kLate_ns = 100'000;

    void add(const realtime::TickTiming& timing) noexcept {
        m_lateness.add(timing.lateness_ns);
        m_duration.add(timing.duration_ns);
        m_late += timing.lateness_ns > kLate_ns ? 1 : 0;
        m_skipped += timing.skipped;
    }
    void merge(const LoopStatistics& other) noexcept {
        m_lateness.merge(other.m_lateness);
        m_duration.merge(other.m_duration);
        m_late += other.m_late;
        m_skipped += other.m_skipped;
    }

    std::uint64_t ticks() const noexcept { return m_lateness.count(); }
    std::uint64_t late() const noexcept { return m_late; }
    std::uint64_t skippedDeadlines() const noexcept { return m_skipped; }
    const LatencyHistogram& lateness() const noexcept { return m_lateness; }
    const LatencyHistogram& duration() const noexcept { return m_duration; }

private:
    LatencyHistogram m_lateness;
    LatencyHistogram m_duration;
    std::uint64_t m_late = 0;
    std::uint64_t m_skipped = 0;
};

} // namespace chiron::haptics
