// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/tick_task.h"

namespace chiron::realtime {

inline constexpr std::int64_t kTickPeriod_ns = 1'000'000; ///< 1 kHz

/// Result of a run.
struct RunReport {
    std::uint64_t executed = 0;
    std::uint64_t skipped = 0; ///< deadlines without a tick
};

/// The 1 kHz runner. Its absolute deadlines are start + k·1 ms on `Clock` (MonotonicClock, or VirtualClock in
/// tests). Each deadline is served at most once, and the runner never catches up: it skips and counts
/// deadlines that have passed when their tick could start, and also the next one if that lies less than half
/// a period after a late start. Two ticks are therefore never closer than half a period. HapticTick::index
/// stays contiguous; a gap shows only in now_ns.
/// Thread: run() is called on the haptic thread, after setUpRealtimeThread(); `stop` may be set from any
/// other.
template <class Clock> class PeriodicRunner {
public:
    PeriodicRunner(Clock& clock, TickSource& ticks) noexcept : m_clock(clock), m_ticks(ticks) {}
    PeriodicRunner(const PeriodicRunner&) = delete;
    PeriodicRunner& operator=(const PeriodicRunner&) = delete;

    /// Runs until `stop` is set or the task ends the run; the first tick starts at once.
    template <TickTask Task> RunReport run(Task& task, const std::atomic<bool>& stop) noexcept {
        RunReport report;
        std::int64_t deadline_ns = m_clock.now_ns();
        bool goOn = true;
        std::uint32_t skipped = 0;
        while (goOn && !stop.load(std::memory_order_acquire)) {
            m_clock.waitUntil(deadline_ns);
            const std::int64_t start_ns = m_clock.now_ns();
            const auto passed = static_cast<std::uint32_t>((start_ns - deadline_ns) / kTickPeriod_ns);
            const HapticTick now = m_ticks.next(start_ns);
            goOn = runTick(task, now);
            const TickTiming timing{start_ns - deadline_ns, m_clock.now_ns() - start_ns, skipped + passed};
            report.skipped += timing.skipped;
            ++report.executed;
            if constexpr (ObservesTiming<Task>)
                task.timing(timing);
            deadline_ns += kTickPeriod_ns * (1 + static_cast<std::int64_t>(passed));
            skipped = 0;
            if (deadline_ns - start_ns < kTickPeriod_ns / 2) {
                deadline_ns += kTickPeriod_ns;
                skipped = 1;
            }
        }
        return report;
    }

private:
    Clock& m_clock;
    TickSource& m_ticks;
};

/// Runs ticks back to back with now_ns = index · 1 ms: faster than real time and without reading a clock, so
/// that each run gives the same result.
class AsFastRunner {
public:
    explicit AsFastRunner(TickSource& ticks) noexcept : m_ticks(ticks) {}
    AsFastRunner(const AsFastRunner&) = delete;
    AsFastRunner& operator=(const AsFastRunner&) = delete;

    template <TickTask Task> RunReport run(Task& task, const std::atomic<bool>& stop) noexcept {
        RunReport report;
        bool goOn = true;
        while (goOn && !stop.load(std::memory_order_acquire)) {
            const HapticTick now =
                m_ticks.next(static_cast<std::int64_t>(m_ticks.executed()) * kTickPeriod_ns);
            goOn = runTick(task, now);
            ++report.executed;
        }
        return report;
    }

private:
    TickSource& m_ticks;
};

} // namespace chiron::realtime
