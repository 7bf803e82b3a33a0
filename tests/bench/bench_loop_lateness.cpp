// SPDX-License-Identifier: GPL-3.0-or-later
// How late the 1 kHz loop starts its ticks while two processes are busy and a third writes and fsyncs:
// PeriodicRunner on a thread that setUpRealtimeThread() prepared, beside a QTimer (Qt::PreciseTimer, 1 ms) in
// an event loop. Both run the same haptic loop on the sphere-apex scene.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "bench/disturbers.h"
#include "core/clock.h"
#include "core/fp_environment.h"
#include "realtime/monotonic_clock.h"
#include "realtime/realtime_thread.h"
#include "recording/crash_ring.h"
#include "recording/ring_drain.h"
#include "support/haptic_bench.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <unistd.h>

using namespace chiron;
using namespace chiron::bench;

namespace {
constexpr int kRepeats = 5;
constexpr std::size_t kTicks = 2'500; ///< a repeat, of each way
constexpr double kLate_us = 100.0;

/// Lateness and duration of each tick, and what share of a processor the thread used.
struct Punctuality {
    std::vector<double> late_us;
    std::vector<double> duration_us;
    std::vector<double> interval_us; ///< |time since the last tick's start − 1 ms|: knows no phase
    std::int64_t lastStart_ns = 0;
    std::vector<double> p99_us; ///< a repeat
    double cpu_s = 0.0;
    double wall_s = 0.0;
    std::uint64_t skipped = 0;
    realtime::RealtimeStatus status;

    void started(std::int64_t start_ns, bool first) noexcept {
        if (!first)
            interval_us.push_back(std::abs(1e-3 * static_cast<double>(start_ns - lastStart_ns) - 1e3));
        lastStart_ns = start_ns;
    }
    double lateShare() const {
        const auto late =
            std::count_if(late_us.begin(), late_us.end(), [](double us) { return us > kLate_us; });
        return late_us.empty() ? 0.0 : static_cast<double>(late) / static_cast<double>(late_us.size());
    }
    double cpuShare() const { return wall_s > 0.0 ? cpu_s / wall_s : 0.0; }
    void closeRepeat() {
        p99_us.push_back(
            percentile({late_us.end() - static_cast<std::ptrdiff_t>(kTicks), late_us.end()}, 0.99));
    }
};

/// A whole haptic loop into a crash ring that this object's thread never empties in between: kTicks fit.
struct Loop {
    tests::BenchDevice device{tests::circlingPath};
    haptics::LiveInputs inputs;
    std::unique_ptr<recording::CrashRing> ring;
    std::unique_ptr<tests::LoopBench> bench;

    Loop() {
        auto made =
            recording::CrashRing::create({.folder = recording::defaultRingFolder(), .session = getpid()});
        if (!made) {
            std::fprintf(stderr, "%s\n", made.error().message.c_str());
            std::exit(1);
        }
        ring = std::move(*made);
        haptics::SafetySettings safety;
        safety.heartbeatWatched = false;
        bench = std::make_unique<tests::LoopBench>(std::vector<haptics::LoopTool>{{device, {}}}, inputs,
                                                   *ring, tests::apexScene(), safety);
        inputs.post({core::CommandKind::start});
    }
    ~Loop() { (void)ring->remove(); }
};

struct CountedTask {
    haptics::HapticLoop& loop;
    Punctuality& result;
    std::size_t left = kTicks;
    bool tick(const realtime::HapticTick& now) noexcept {
        result.started(now.now_ns(), now.index() == 0);
        return loop.tick(now) && --left > 0;
    }
    void timing(const realtime::TickTiming& t) noexcept {
        result.late_us.push_back(1e-3 * static_cast<double>(t.lateness_ns)); // room was made before
        result.duration_us.push_back(1e-3 * static_cast<double>(t.duration_ns));
        loop.timing(t);
    }
};

void reserveRoom(Punctuality& result) {
    result.late_us.reserve(kRepeats * kTicks);
    result.duration_us.reserve(kRepeats * kTicks);
    result.interval_us.reserve(kRepeats * kTicks);
}

void runPeriodic(Punctuality& result) {
    Loop loop;
    reserveRoom(result);
    std::thread haptic([&] {
        result.status = realtime::setUpRealtimeThread();
        realtime::MonotonicClock clock;
        realtime::TickSource ticks;
        CountedTask task{*loop.bench->loop, result};
        const std::atomic<bool> stop{false};
        const double cpu = seconds(CLOCK_THREAD_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
        result.skipped += realtime::PeriodicRunner(clock, ticks).run(task, stop).skipped;
        result.cpu_s += seconds(CLOCK_THREAD_CPUTIME_ID) - cpu;
        result.wall_s += seconds(CLOCK_MONOTONIC) - wall;
    });
    haptic.join();
    result.closeRepeat();
}

/// One QTimer's ticks. Its own schedule counts: a timeout that is over when it should be armed begins a new
/// one (as Qt does), so the peer is not charged twice for one delay.
class TimerTicks {
public:
    TimerTicks(haptics::HapticLoop& loop, Punctuality& result, QEventLoop& events)
        : m_loop(loop), m_result(result), m_events(events),
          m_deadline_ns(core::monotonicNow_ns() + 1'000'000) {}
    void timeout() {
        const std::int64_t start_ns = core::monotonicNow_ns();
        m_result.started(start_ns, m_ticks.executed() == 0);
        m_loop.tick(m_ticks.next(start_ns));
        m_result.late_us.push_back(1e-3 *
                                   static_cast<double>(std::max<std::int64_t>(0, start_ns - m_deadline_ns)));
        m_result.duration_us.push_back(1e-3 * static_cast<double>(core::monotonicNow_ns() - start_ns));
        m_deadline_ns += 1'000'000;
        if (m_deadline_ns < start_ns) {
            m_deadline_ns = start_ns + 1'000'000;
            ++m_result.skipped;
        }
        if (m_ticks.executed() == kTicks)
            m_events.quit();
    }

private:
    haptics::HapticLoop& m_loop;
    Punctuality& m_result;
    QEventLoop& m_events;
    realtime::TickSource m_ticks;
    std::int64_t m_deadline_ns;
};

void runTimer(Punctuality& result, bool askForPriority) {
    Loop loop;
    reserveRoom(result);
    std::thread haptic([&] {
        core::setModelFloatingPointEnvironment();
        if (askForPriority)
            result.status = realtime::setUpRealtimeThread();
        QEventLoop events;
        QTimer timer;
        timer.setTimerType(Qt::PreciseTimer);
        timer.setInterval(1);
        TimerTicks ticks(*loop.bench->loop, result, events);
        QObject::connect(&timer, &QTimer::timeout, &events, [&ticks] { ticks.timeout(); });
        const double cpu = seconds(CLOCK_THREAD_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
        timer.start();
        events.exec();
        result.cpu_s += seconds(CLOCK_THREAD_CPUTIME_ID) - cpu;
        result.wall_s += seconds(CLOCK_MONOTONIC) - wall;
    });
    haptic.join();
    result.closeRepeat();
}

/// Time that the virtual machine's processors wanted and did not get, since boot, all of them together; 0
/// where unknown.
double stolenSeconds() {
    unsigned long long user = 0, nice = 0, system = 0, idle = 0, wait = 0, irq = 0, softirq = 0, steal = 0;
    if (std::FILE* file = std::fopen("/proc/stat", "r")) {
        if (std::fscanf(file, "cpu %llu %llu %llu %llu %llu %llu %llu %llu", &user, &nice, &system, &idle,
                        &wait, &irq, &softirq, &steal) != 8)
            steal = 0;
        std::fclose(file);
    }
    return static_cast<double>(steal) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Without the priority the goals do not apply, and the figures say so.
std::string judged(const Punctuality& ours, bool reached) {
    return ours.status.priorityGranted ? verdict(reached) : "no real-time priority";
}

/// The peer with the priority that ours has: what is left is the timer itself.
BenchRow priorityRow(const Punctuality& ours, const Punctuality& fifo) {
    BenchRow row{
        .work = "lateness, p99 of a repeat", .peer = "the same QTimer with our priority", .unit = "us"};
    row.peerMedian = median(fifo.p99_us);
    row.oursMedian = median(ours.p99_us);
    if (!fifo.status.priorityGranted)
        row.reached = "no real-time priority";
    return row;
}

std::vector<BenchRow> rowsOf(const Punctuality& ours, const Punctuality& peer) {
    const char* timer = "QTimer, Qt::PreciseTimer";
    BenchRow p99{.work = "lateness, p99 of a repeat", .peer = timer, .unit = "us"};
    p99.peerMedian = median(peer.p99_us);
    p99.oursMedian = median(ours.p99_us);
    p99.p99 = percentile(ours.late_us, 0.99);
    p99.p999 = percentile(ours.late_us, 0.999);
    p99.agreement =
        text("%zu and %zu ticks, %llu and %llu deadlines skipped", peer.late_us.size(), ours.late_us.size(),
             static_cast<unsigned long long>(peer.skipped), static_cast<unsigned long long>(ours.skipped));
    p99.goal = "ratio ≥ 100";
    p99.reached = judged(ours, p99.ratio().value_or(0.0) >= 100.0);
    BenchRow p50{.work = "lateness, median", .peer = timer, .unit = "us"};
    p50.peerMedian = median(peer.late_us);
    p50.oursMedian = median(ours.late_us);
    BenchRow interval{.work = "interval off 1 ms by, p99 of all", .peer = timer, .unit = "us"};
    interval.peerMedian = percentile(peer.interval_us, 0.99);
    interval.oursMedian = percentile(ours.interval_us, 0.99);
    BenchRow late{.work = "ticks more than 100 us late", .peer = timer, .unit = "%"};
    late.peerMedian = 100.0 * peer.lateShare();
    late.oursMedian = 100.0 * ours.lateShare();
    late.goal = "≤ 0.3";
    late.reached = judged(ours, *late.oursMedian <= 0.3);
    BenchRow cpu{.work = "CPU time of the thread", .peer = timer, .unit = "% of a core"};
    cpu.peerMedian = 100.0 * peer.cpuShare();
    cpu.oursMedian = 100.0 * ours.cpuShare();
    cpu.goal = "≤ 12";
    cpu.reached = judged(ours, *cpu.oursMedian <= 12.0);
    BenchRow tick{
        .work = "whole tick at 1 kHz, disturbed", .peer = "the same tick from QTimer", .unit = "us"};
    tick.peerMedian = median(peer.duration_us);
    tick.oursMedian = median(ours.duration_us);
    tick.p99 = percentile(ours.duration_us, 0.99);
    tick.p999 = percentile(ours.duration_us, 0.999);
    return {p99, p50, interval, late, cpu, tick};
}
} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv); // an event loop needs one
    printHeading("Lateness of the 1 kHz loop under two busy processes and an fsync writer");
    const Disturbers disturbers(2, argc > 1 ? argv[1] : ".");
    Punctuality ours, peer, fifo;
    const double before_s = stolenSeconds(), wall_s = seconds(CLOCK_MONOTONIC);
    for (int r = 0; r < kRepeats; ++r) {
        runTimer(peer, false);
        runPeriodic(ours);
        runTimer(fifo, true);
    }
    std::vector<BenchRow> rows = rowsOf(ours, peer);
    rows.push_back(priorityRow(ours, fifo));
    printTable(rows);
    const double wall = seconds(CLOCK_MONOTONIC) - wall_s;
    std::printf("The host took %.2f %% of the processors' time away (steal).\n",
                100.0 * (stolenSeconds() - before_s) / (wall * std::thread::hardware_concurrency()));
    std::printf("%d repeats of %.1f s each, alternating. PeriodicRunner: %s; %s.\n", kRepeats,
                1e-3 * static_cast<double>(kTicks), ours.status.priorityDetail.c_str(),
                ours.status.memoryDetail.c_str());
    return 0;
}
