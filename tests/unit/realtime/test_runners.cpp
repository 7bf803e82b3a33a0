// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/monotonic_clock.h"
#include "realtime/periodic_runner.h"
#include "realtime/realtime_thread.h"
#include "realtime/virtual_clock.h"

#include <QtTest>
#include <algorithm>
#include <limits>
#include <pthread.h>
#include <sys/prctl.h>
#include <thread>
#include <vector>

using namespace chiron::realtime;

namespace {
constexpr std::int64_t kMs = 1'000'000;

/// Records what it was given, and takes as long on the virtual clock as its script says.
struct ScriptedTask {
    VirtualClock* clock = nullptr;
    std::vector<std::int64_t> durations_ns{};  ///< by tick; 0 beyond the end
    std::vector<std::int64_t> wakeDelays_ns{}; ///< of the wake-up after the tick
    std::size_t stopAfter = 0;
    std::vector<std::uint64_t> indices{};
    std::vector<std::int64_t> starts_ns{};
    std::vector<TickTiming> timings{};

    bool tick(const HapticTick& now) noexcept {
        const std::size_t n = indices.size();
        indices.push_back(now.index());
        starts_ns.push_back(now.now_ns());
        if (clock != nullptr) {
            clock->advance(n < durations_ns.size() ? durations_ns[n] : 0);
            clock->delayNextWake(n < wakeDelays_ns.size() ? wakeDelays_ns[n] : 0);
        }
        return indices.size() < stopAfter;
    }
    void timing(const TickTiming& t) noexcept { timings.push_back(t); }
};

struct VoidTask {
    std::atomic<bool>* stop;
    int ticks = 0;
    void tick(const HapticTick&) noexcept { stop->store(++ticks == 3); }
};
} // namespace

class TestRunners : public QObject {
    Q_OBJECT
private slots:
    void ticksAreOneMillisecondApart() {
        VirtualClock clock(5 * kMs);
        TickSource ticks;
        ScriptedTask task{.clock = &clock, .stopAfter = 4};
        const std::atomic<bool> stop{false};
        const RunReport report = PeriodicRunner(clock, ticks).run(task, stop);
        QCOMPARE(report.executed, 4u);
        QCOMPARE(report.skipped, 0u);
        QCOMPARE(task.starts_ns, (std::vector<std::int64_t>{5 * kMs, 6 * kMs, 7 * kMs, 8 * kMs}));
    }

    void deadlinesThatAreOverAreSkippedAndCounted() {
        VirtualClock clock;
        TickSource ticks;
        // Tick 1 takes 3.2 ms: deadlines 2 and 3 are over when it ends, 4 is served 0.2 ms late, 5 in time.
        ScriptedTask task{.clock = &clock, .durations_ns = {0, 3'200'000}, .stopAfter = 4};
        const std::atomic<bool> stop{false};
        const RunReport report = PeriodicRunner(clock, ticks).run(task, stop);
        QCOMPARE(task.starts_ns, (std::vector<std::int64_t>{0, kMs, 4'200'000, 5 * kMs}));
        QCOMPARE(task.indices, (std::vector<std::uint64_t>{0, 1, 2, 3}));
        QCOMPARE(report.skipped, 2u);
        QCOMPARE(task.timings[1].duration_ns, 3'200'000);
        QCOMPARE(task.timings[2].skipped, 2u);
        QCOMPARE(task.timings[2].lateness_ns, 2'200'000);
        QCOMPARE(task.timings[3].lateness_ns, 0);
    }

    void aVeryLateStartSkipsTheNextDeadlineInsteadOfMakingABurst() {
        VirtualClock clock;
        TickSource ticks;
        ScriptedTask task{.clock = &clock, .wakeDelays_ns = {0, 900'000}, .stopAfter = 4};
        const std::atomic<bool> stop{false};
        const RunReport report = PeriodicRunner(clock, ticks).run(task, stop);
        // Deadline 2 starts at 2.9 ms; deadline 3 would follow after 0.1 ms and is skipped.
        QCOMPARE(task.starts_ns, (std::vector<std::int64_t>{0, kMs, 2'900'000, 4 * kMs}));
        QCOMPARE(report.skipped, 1u);
        QCOMPARE(task.timings[3].skipped, 1u);
    }

    void ticksNeverComeCloserThanHalfAPeriodWhateverTheyTake() {
        VirtualClock clock;
        TickSource ticks;
        ScriptedTask task{.clock = &clock, .stopAfter = 3000};
        for (std::int64_t n = 0; n < 3000; ++n) {
            task.durations_ns.push_back((n * 7919) % 2'700'000);
            task.wakeDelays_ns.push_back((n * 104'729) % 1'300'000);
        }
        const std::atomic<bool> stop{false};
        const RunReport report = PeriodicRunner(clock, ticks).run(task, stop);
        std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
        std::uint64_t skipped = 0;
        for (std::size_t n = 1; n < task.starts_ns.size(); ++n)
            smallest = std::min(smallest, task.starts_ns[n] - task.starts_ns[n - 1]);
        for (const TickTiming& t : task.timings)
            skipped += t.skipped;
        QVERIFY2(smallest >= kMs / 2, qPrintable(QString::number(smallest)));
        QCOMPARE(report.skipped, skipped);
        // Every deadline up to the last start was either served or skipped.
        const auto deadlines = static_cast<std::uint64_t>(task.starts_ns.back() / kMs) + 1;
        QCOMPARE(report.executed + report.skipped, deadlines);
    }

    void stopFlagEndsATaskThatReturnsNothing() {
        VirtualClock clock;
        TickSource ticks;
        std::atomic<bool> stop{false};
        VoidTask task{&stop};
        QCOMPARE(PeriodicRunner(clock, ticks).run(task, stop).executed, 3u);
        QCOMPARE(task.ticks, 3);
    }

    void asFastRunnerGivesVirtualMilliseconds() {
        TickSource ticks;
        ScriptedTask task{.stopAfter = 3};
        const std::atomic<bool> stop{false};
        QCOMPARE(AsFastRunner(ticks).run(task, stop).executed, 3u);
        QCOMPARE(task.starts_ns, (std::vector<std::int64_t>{0, kMs, 2 * kMs}));
        // A second run on the same source goes on where the first ended.
        task.stopAfter = 4;
        AsFastRunner(ticks).run(task, stop);
        QCOMPARE(task.indices.back(), 3u);
        QCOMPARE(task.starts_ns.back(), 3 * kMs);
    }

    void theRealClockNeverWakesEarlyAndTicksOnTheSameCode() {
        MonotonicClock clock;
        const std::int64_t deadline = clock.now_ns() + 2 * kMs;
        clock.waitUntil(deadline);
        QVERIFY(clock.now_ns() >= deadline);
        TickSource ticks;
        ScriptedTask task{.stopAfter = 20};
        const std::atomic<bool> stop{false};
        const RunReport report = PeriodicRunner(clock, ticks).run(task, stop);
        QCOMPARE(report.executed, 20u);
        for (std::size_t n = 1; n < task.starts_ns.size(); ++n)
            QVERIFY(task.starts_ns[n] - task.starts_ns[n - 1] >= kMs / 2);
    }

    void threadSetUpSaysWhatWasGrantedOrWhyNot() {
        RealtimeStatus status;
        double denormalProduct = 1.0;
        int slack_ns = -1, policy = -1;
        sched_param granted{};
        std::thread thread([&] {
            status = setUpRealtimeThread();
            slack_ns = prctl(PR_GET_TIMERSLACK, 0UL, 0UL, 0UL, 0UL);
            pthread_getschedparam(pthread_self(), &policy, &granted);
            volatile double tiny = std::numeric_limits<double>::min();
            volatile double half = 0.5;
            denormalProduct = tiny * half;
        });
        thread.join();
        QVERIFY(!status.priorityDetail.empty());
        QVERIFY(!status.memoryDetail.empty());
        QCOMPARE(status.priorityGranted, status.priorityDetail.rfind("SCHED_FIFO priority", 0) == 0);
        QCOMPARE(status.memoryLocked, status.memoryDetail == "memory locked");
        QCOMPARE(status.priorityGranted, policy == SCHED_FIFO);
        QCOMPARE(granted.sched_priority, status.priorityGranted ? 80 : 0);
        QVERIFY2(status.priorityDetail.find("80") != std::string::npos, status.priorityDetail.c_str());
        QVERIFY2(status.memoryLocked || status.memoryDetail.rfind("memory not locked: ", 0) == 0,
                 status.memoryDetail.c_str());
        QVERIFY2(slack_ns >= 0 && slack_ns <= 1,
                 qPrintable(QString::number(slack_ns))); // the default of 50 µs is half of what is spun
        QVERIFY2(denormalProduct == 0.0, "denormals are flushed on that thread");
    }
};

QTEST_APPLESS_MAIN(TestRunners)
#include "test_runners.moc"
