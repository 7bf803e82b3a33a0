// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/periodic_runner.h"
#include "realtime/realtime_thread.h"
#include "session/loop_report.h"

#include <atomic>
#include <cstdint>

namespace chiron::session {

/// What a self-test of the loop found: its punctuality without any device, and what the system granted its thread.
struct SelfTestResult {
    LoopReport loop;
    realtime::RealtimeStatus granted;
    bool cancelled = false;
};

/// Ticks that do nothing but count: what is late here is late because of the machine, not because of an exercise.
class SelfTestTask {
public:
    explicit SelfTestTask(std::uint64_t ticks) noexcept : m_wanted(ticks) {}
    bool tick(const realtime::HapticTick& now) noexcept {
        m_done.store(now.index() + 1, std::memory_order_relaxed);
        return now.index() + 1 < m_wanted;
    }
    void timing(const realtime::TickTiming& timing) noexcept { m_statistics.add(timing); }

    const haptics::LoopStatistics& statistics() const noexcept { return m_statistics; } ///< after the run
    std::uint64_t done() const noexcept { return m_done.load(std::memory_order_relaxed); } ///< any thread

private:
    std::uint64_t m_wanted;
    std::atomic<std::uint64_t> m_done{0};
    haptics::LoopStatistics m_statistics;
};

/// Runs `task` on `clock` until it has its ticks or `cancel` is set; MonotonicClock, or VirtualClock in tests. On the calling
/// thread, which should be one that setUpRealtimeThread() was asked for.
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

/// The same in real time, on a thread of its own that is made fit for ticks and gone afterwards. Blocking; a
/// worker's task. `task` tells how far it is meanwhile.
SelfTestResult selfTestOnOwnThread(SelfTestTask& task, const std::atomic<bool>& cancel);

} // namespace chiron::session
