// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/periodic_runner.h"
#include "realtime/realtime_thread.h"
#include "session/loop_report.h"

#include <atomic>
#include <cstdint>

namespace chiron::session {

/// The result of a self-test of the loop: its punctuality without any device, and the scheduling that the
/// system granted to its thread.
struct SelfTestResult {
    LoopReport loop;
    realtime::RealtimeStatus granted;
    bool cancelled = false;
};

/// A task whose ticks only count. Lateness measured here is caused by the machine, not by an exercise.
class SelfTestTask {
public:
    explicit SelfTestTask(std::uint64_t ticks) noexcept : m_wanted(ticks) {}
    bool tick(const realtime::HapticTick& now) noexcept {
        m_done.store(now.index() + 1, std::memory_order_relaxed);
        return now.index() + 1 < m_wanted;
    }
    void timing(const realtime::TickTiming& timing) noexcept { m_statistics.add(timing); }

    /// Valid after the run.
    const haptics::LoopStatistics& statistics() const noexcept { return m_statistics; }
    std::uint64_t done() const noexcept { return m_done.load(std::memory_order_relaxed); } ///< any thread

private:
    std::uint64_t m_wanted;
    std::atomic<std::uint64_t> m_done{0};
    haptics::LoopStatistics m_statistics;
};

/// Runs `task` on `clock` until it has had its number of ticks or `cancel` is set. The clock is a
/// MonotonicClock, or a VirtualClock in tests. Runs on the calling thread, which should have been set up with
/// setUpRealtimeThread().
template <class Clock>
LoopReport runSelfTest(Clock& clock, SelfTestTask& task, const std::atomic<bool>& cancel) {
    realtime::TickSource ticks;
    realtime::PeriodicRunner runner(clock, ticks);
    const realtime::RunReport run = runner.run(task, cancel);
    LoopReport report;
    report.ticks = run.executed;
    report.skipped = run.skipped;
    setPunctuality(report, task.statistics());
    return report;
}

/// Does the same in real time, on a separate thread with real-time scheduling that ends with the test.
/// Blocks; call it on a worker. `task` reports the progress meanwhile.
SelfTestResult selfTestOnOwnThread(SelfTestTask& task, const std::atomic<bool>& cancel);

} // namespace chiron::session
