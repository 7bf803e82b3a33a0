// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "core/fp_environment.h"
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"
#include "devices/recorded_device.h"
#include "haptics/recorded_inputs.h"
#include "realtime/monotonic_clock.h"
#include "realtime/realtime_thread.h"
#include "support/haptic_bench.h"

#include <QtTest>
#include <chrono>
#include <cstring>
#include <thread>

using namespace chiron;
using namespace chiron::tests;
using core::CommandKind;

namespace {

constexpr std::size_t kTicks = 1500;

/// Ticks until enough were executed.
struct CountedTask {
    haptics::HapticLoop& loop;
    std::size_t left = kTicks;
    bool tick(const realtime::HapticTick& now) noexcept { return loop.tick(now) && --left > 0; }
    void timing(const realtime::TickTiming& t) noexcept { loop.timing(t); }
};

bool sameBits(const core::HapticFrame& a, const core::HapticFrame& b) {
    return std::memcmp(&a.header, &b.header, sizeof a.header) == 0 &&
           std::memcmp(a.tool.data(), b.tool.data(), a.tools * sizeof(core::ToolFrame)) == 0;
}

} // namespace

/// A session on real threads: the loop on its own, a window that moves the pointer, posts commands, sends
/// heartbeats and reads the screen's state. No time is asserted: only that nothing is lost, goes back or
/// differs in the replay.
class TestRealtimeSession : public QObject {
    Q_OBJECT
private slots:
    void aLiveSessionReplaysToTheSameBits() {
        const auto device = devices::KeyboardMouseDevice::create();
        haptics::LiveInputs inputs;
        FrameStore store(kTicks + 10);
        LoopBench bench({{**device, {}}}, inputs, store, apexScene());
        std::atomic<bool> stop{false};
        std::atomic<bool> done{false};
        realtime::RunReport report;
        realtime::RealtimeStatus status;
        std::thread haptic([&] {
            status = realtime::setUpRealtimeThread();
            realtime::MonotonicClock clock;
            realtime::TickSource ticks;
            CountedTask task{*bench.loop};
            report = realtime::PeriodicRunner(clock, ticks).run(task, stop);
            done.store(true);
        });
        const int backwards = playWindow(**device, inputs, *bench.loop, done);
        haptic.join();
        qInfo("%s; %s", status.priorityDetail.c_str(), status.memoryDetail.c_str());
        qInfo("lateness p50 %.1f, p99 %.1f, max %.1f us; tick p50 %.2f, p99 %.2f us; skipped %llu",
              bench.loop->statistics().lateness().percentile_us(0.5),
              bench.loop->statistics().lateness().percentile_us(0.99),
              1e-3 * static_cast<double>(bench.loop->statistics().lateness().maximum_ns()),
              bench.loop->statistics().duration().percentile_us(0.5),
              bench.loop->statistics().duration().percentile_us(0.99),
              static_cast<unsigned long long>(report.skipped));
        QCOMPARE(backwards, 0);
        QCOMPARE(report.executed, kTicks);
        QCOMPARE(store.frames.size(), kTicks);
        QCOMPARE(bench.loop->statistics().ticks(), kTicks);
        QCOMPARE(bench.loop->statistics().skippedDeadlines(), report.skipped);
        QVERIFY(store.frames.back().tool[0].counts[2] != store.frames.front().tool[0].counts[2]);
        compareWithReplay(store.frames, (*device)->descriptor());
    }

private:
    /// The window's side, until the loop is done. Returns how often the screen's state went back.
    static int playWindow(devices::KeyboardMouseDevice& device, haptics::LiveInputs& inputs,
                          haptics::HapticLoop& loop, const std::atomic<bool>& done) {
        int backwards = 0;
        std::uint64_t last = 0;
        inputs.post({CommandKind::start});
        for (int n = 0; !done.load(); ++n) {
            device.mailbox().move(1e-6 * (n % 11 - 5), 1e-6 * (n % 7 - 3), -8e-6);
            inputs.beat(core::monotonicNow_ns());
            if (n % 200 == 100)
                inputs.post({n % 400 == 100 ? CommandKind::pause : CommandKind::resume});
            haptics::DisplayState shown;
            if (loop.display().read(shown)) {
                backwards += shown.tick < last ? 1 : 0;
                last = shown.tick;
            }
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
        return backwards;
    }

    static void compareWithReplay(const std::vector<core::HapticFrame>& frames,
                                  const devices::DeviceDescriptor& descriptor) {
        const auto recorded = devices::RecordedDevice::create(descriptor);
        haptics::RecordedInputs inputs;
        FrameStore again(frames.size());
        LoopBench bench({{**recorded, {}}}, inputs, again, apexScene());
        realtime::TickSource ticks;
        core::setModelFloatingPointEnvironment();
        for (const core::HapticFrame& frame : frames) {
            inputs.setFrame(frame);
            bench.loop->tick(ticks.next(frame.header.now_ns));
        }
        int different = 0;
        for (std::size_t n = 0; n < frames.size(); ++n)
            different += sameBits(frames[n], again.frames[n]) ? 0 : 1;
        QCOMPARE(different, 0);
    }
};

QTEST_APPLESS_MAIN(TestRealtimeSession)
#include "test_realtime_session.moc"
