// SPDX-License-Identifier: GPL-3.0-or-later
// What handing a frame of one tool to another thread costs the haptic thread: the crash ring and SpscRing
// beside a deque under a mutex, each emptied meanwhile by a consumer that looks every 20 µs.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "bench/no_system_call.h"
#include "core/clock.h"
#include "realtime/spsc_ring.h"
#include "realtime/tick_guard.h"
#include "recording/crash_ring.h"
#include "recording/ring_drain.h"
#include "support/haptic_trace.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>
#include <unistd.h>

using namespace chiron;
using namespace chiron::bench;

namespace {
constexpr int kRepeats = 9;
constexpr std::size_t kPushes = 20'000;
constexpr std::size_t kBatch = 20;
constexpr std::int64_t kGap_ns = 500; // between pushes, so that the consumer gets its turns in between
constexpr std::uint64_t kMostWaiting = 2'000;
constexpr double kGoal_ns = 15.0;

/// The bytes of a frame that count with one tool, as the crash ring copies them.
struct OneTool {
    std::array<std::uint8_t, recording::usedFrameBytes(1)> bytes;
};

OneTool oneToolOf(const core::HapticFrame& frame) {
    OneTool one;
    std::memcpy(one.bytes.data(), &frame, one.bytes.size());
    return one;
}

/// What each way gave: batches for the median, single pushes for the tail, and what arrived.
struct Pushes {
    std::vector<double> medians;
    std::vector<double> single_ns;
    std::uint64_t allocations = 0;
    std::uint64_t arrived = 0;
    std::uint64_t refused = 0;
};

/// Waits for the gap, and for a consumer that has lost its processor: at 2 million frames a second a ring of
/// 4 s at 1 kHz lasts 2 ms.
void pause(std::int64_t until_ns, std::uint64_t pushed, const std::atomic<std::uint64_t>& arrived) {
    while (core::monotonicNow_ns() < until_ns ||
           pushed > arrived.load(std::memory_order_relaxed) + kMostWaiting) {
    }
}

/// `push(n)` on this thread, `take()` (gives how many it took) on another until all has arrived or was
/// refused.
template <class Push, class Take> void run(Pushes& result, double clock_ns, Push&& push, Take&& take) {
    std::atomic<bool> done{false};
    std::atomic<std::uint64_t> arrived{0};
    std::thread consumer([&] {
        for (bool last = false; !last;) {
            last = done.load(std::memory_order_acquire);
            arrived += take();
            if (!last)
                std::this_thread::sleep_for(std::chrono::microseconds(20));
        }
    });
    tests::resetForbiddenCounts();
    std::vector<double> batches;
    batches.reserve(kPushes / kBatch);
    result.single_ns.reserve(kRepeats * kPushes);
    std::uint64_t refused = 0;
    for (std::size_t n = 0; n < kPushes; ++n) {
        const tests::TickGuard guard;
        const std::int64_t start_ns = core::monotonicNow_ns();
        refused += push(n) ? 0 : 1;
        const std::int64_t end_ns = core::monotonicNow_ns();
        result.single_ns.push_back(std::max(0.0, static_cast<double>(end_ns - start_ns) - clock_ns));
        pause(end_ns + kGap_ns, n + 1, arrived);
    }
    for (std::size_t n = 0; n < kPushes / kBatch; ++n) {
        const tests::TickGuard guard;
        const std::int64_t start_ns = core::monotonicNow_ns();
        for (std::size_t i = 0; i < kBatch; ++i)
            refused += push(n * kBatch + i) ? 0 : 1;
        const std::int64_t end_ns = core::monotonicNow_ns();
        batches.push_back((static_cast<double>(end_ns - start_ns) - clock_ns) / kBatch);
        pause(end_ns + kGap_ns * static_cast<std::int64_t>(kBatch), kPushes + (n + 1) * kBatch, arrived);
    }
    result.allocations += tests::forbiddenCounts().of(tests::Forbidden::allocate);
    done.store(true, std::memory_order_release);
    consumer.join();
    result.medians.push_back(median(batches));
    result.arrived += arrived;
    result.refused += refused;
}

void throughMutex(Pushes& result, double clock_ns, const std::vector<OneTool>& frames) {
    std::mutex mutex;
    std::deque<OneTool> queue;
    std::deque<OneTool> taken;
    run(
        result, clock_ns,
        [&](std::size_t n) {
            const std::lock_guard lock(mutex);
            queue.push_back(frames[n % frames.size()]);
            return true;
        },
        [&] {
            taken.clear();
            const std::lock_guard lock(mutex); // the consumer's best: it swaps and frees outside
            taken.swap(queue);
            return taken.size();
        });
}

void throughSpscRing(Pushes& result, double clock_ns, const std::vector<OneTool>& frames) {
    const auto ring = std::make_unique<realtime::SpscRing<OneTool, 4096>>();
    OneTool taken;
    run(
        result, clock_ns, [&](std::size_t n) { return ring->tryPush(frames[n % frames.size()]); },
        [&] {
            std::uint64_t count = 0;
            while (ring->tryPop(taken))
                ++count;
            return count;
        });
}

void throughCrashRing(Pushes& result, double clock_ns, const std::vector<core::HapticFrame>& frames) {
    auto ring = recording::CrashRing::create({.folder = recording::defaultRingFolder(), .session = getpid()});
    if (!ring) {
        std::fprintf(stderr, "%s\n", ring.error().message.c_str());
        std::exit(1);
    }
    recording::RingDrain drain(**ring);
    std::vector<core::HapticFrame> taken(256);
    run(
        result, clock_ns, [&](std::size_t n) { return (*ring)->tryPush(frames[n % frames.size()]); },
        [&] {
            std::uint64_t count = 0;
            while (const std::size_t some = drain.read(taken))
                count += some;
            drain.commit(drain.position());
            return count;
        });
    (void)(*ring)->remove();
}

BenchRow rowOf(const char* work, const Pushes& ours, const Pushes& peer) {
    BenchRow row{.work = work, .peer = "deque under a mutex"};
    row.peerMedian = median(peer.medians);
    row.oursMedian = median(ours.medians);
    row.p99 = percentile(ours.single_ns, 0.99);
    row.p999 = percentile(ours.single_ns, 0.999);
    row.allocations = ours.allocations;
    row.agreement =
        text("%llu of %llu arrived, %llu refused", static_cast<unsigned long long>(ours.arrived),
             static_cast<unsigned long long>(peer.arrived), static_cast<unsigned long long>(ours.refused));
    return row;
}

std::optional<bool> pushesWithoutSystemCall(const std::vector<core::HapticFrame>& frames) {
    auto ring = recording::CrashRing::create({.folder = recording::defaultRingFolder(), .session = getpid()});
    if (!ring)
        return std::nullopt;
    const auto quiet = makesNoSystemCall([&] {
        for (std::size_t n = 0; n < 100'000; ++n) // fills the ring and goes on: refusing makes none either
            (*ring)->tryPush(frames[n % frames.size()]);
    });
    (void)(*ring)->remove();
    return quiet;
}
} // namespace

int main() {
    printHeading("Handing one frame of one tool to another thread");
    const auto frames = tests::HapticTrace(11).take(200);
    std::vector<OneTool> small;
    for (const core::HapticFrame& frame : frames)
        small.push_back(oneToolOf(frame));
    std::vector<double> clock;
    for (int i = 0; i < 10'000; ++i) {
        const std::int64_t start_ns = core::monotonicNow_ns();
        clock.push_back(static_cast<double>(core::monotonicNow_ns() - start_ns));
    }
    const double clock_ns = median(clock);
    Pushes locked, spsc, crash;
    for (int r = 0; r < kRepeats; ++r) {
        throughMutex(locked, clock_ns, small);
        throughSpscRing(spsc, clock_ns, small);
        throughCrashRing(crash, clock_ns, frames);
    }
    BenchRow peer = rowOf("deque under a mutex, push", locked, locked);
    peer.peer = "(the peer itself)";
    BenchRow ring = rowOf("SpscRing, push", spsc, locked);
    BenchRow recorder = rowOf("crash ring with checksum, push", crash, locked);
    const auto quiet = pushesWithoutSystemCall(frames);
    recorder.agreement +=
        quiet ? (*quiet ? ", no system call" : ", SYSTEM CALLS") : ", system calls not measured";
    recorder.goal = "≤ 15 in the haptic thread, no system call";
    recorder.reached =
        verdict(*recorder.oursMedian <= kGoal_ns && crash.allocations == 0 && quiet.value_or(false));
    printTable({peer, ring, recorder});
    std::printf("%d repeats of %zu single pushes (tails, a clock read of %.0f ns taken off) and %zu batches "
                "of %zu (medians); "
                "%zu bytes a frame.\n",
                kRepeats, kPushes, clock_ns, kPushes / kBatch, kBatch, sizeof(OneTool));
    return 0;
}
