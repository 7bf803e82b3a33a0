// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/tick_guard.h"
#include "support/haptic_bench.h"
#include "support/station_bench.h"

using namespace chiron;
using namespace chiron::tests;

/// test_every_driver_guard skips a device that is not connected: here a station is, and it is unplugged on
/// the way and comes back.
class TestStationGuard : public QObject {
    Q_OBJECT
private slots:
    void itsTicks() {
        auto configuration = pressingStation();
        configuration.fault = *station::readFaultPlan("unplug:8:500");
        StationBench bench(std::move(configuration));
        auto made = toolAt(bench.address);
        QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
        devices::IDevice& device = *made->front().device;
        const auto opened = device.open();
        QVERIFY2(opened.has_value(), opened ? "" : opened.error().message.c_str());
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench loop({{device, {}}}, inputs, store, apexScene(benchExercise(2, 60.0)));
        inputs.post({core::CommandKind::start});
        realtime::TickSource ticks;
        bool felt = false;
        resetForbiddenCounts();
        for (int n = 0; n < 10'000; ++n) {
            inputs.beat(static_cast<std::int64_t>(n) * 1'000'000);
            const realtime::HapticTick now = ticks.next(static_cast<std::int64_t>(n) * 1'000'000);
            {
                const TickGuard guard;
                loop.loop->tick(now);
            }
            (void)device.awaitStep();
            const auto& commanded = store.frames.back().tool[0].commanded;
            felt = felt || std::abs(commanded[2]) > 0.5;
        }
        const ForbiddenCounts counts = forbiddenCounts();
        QCOMPARE(counts.total(), std::uint64_t(0));
        QVERIFY(felt);
        device.close();
    }
};

QTEST_APPLESS_MAIN(TestStationGuard)
#include "test_station_guard.moc"
