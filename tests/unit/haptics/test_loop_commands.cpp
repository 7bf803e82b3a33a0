// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/haptic_bench.h"

#include <QtTest>
#include <thread>

using namespace chiron;
using namespace chiron::tests;
using core::CommandKind;
using core::TrialPhase;

namespace {

/// A loop on one bench device, ticked one millisecond at a time.
struct Bench {
    explicit Bench(BenchDevice::Path path = highPath, bool rendersForce = true,
                   const simulation::SphereApexParameters& exercise = benchExercise())
        : device(path, rendersForce), bench({{device, {}}}, inputs, store, apexScene(exercise)) {}
    bool tick() { return bench.loop->tick(ticks.next(now_ns())); }
    std::int64_t now_ns() const { return static_cast<std::int64_t>(ticks.executed()) * 1'000'000; }
    void run(int count) {
        for (int n = 0; n < count; ++n)
            tick();
    }
    const core::TickHeader& header() const { return store.frames.back().header; }

    BenchDevice device;
    haptics::LiveInputs inputs;
    FrameStore store;
    LoopBench bench;
    realtime::TickSource ticks;
};

} // namespace

class TestLoopCommands : public QObject {
    Q_OBJECT
private slots:
    void atMostTwoATickInOrderAndRecorded() {
        Bench bench;
        for (std::uint16_t n = 1; n <= 5; ++n)
            bench.inputs.post({CommandKind::rearm, n});
        bench.run(4);
        const auto argument = [&](std::size_t frame, std::size_t i) {
            return bench.store.frames[frame].header.commands[i].argument;
        };
        QCOMPARE(argument(0, 0), std::uint16_t{1});
        QCOMPARE(argument(0, 1), std::uint16_t{2});
        QCOMPARE(argument(1, 0), std::uint16_t{3});
        QCOMPARE(argument(1, 1), std::uint16_t{4});
        QCOMPARE(argument(2, 0), std::uint16_t{5});
        QVERIFY(bench.store.frames[2].header.commands[1].kind == CommandKind::none);
        QVERIFY(bench.store.frames[3].header.commands[0].kind == CommandKind::none);
    }

    void aFullCommandRingSaysSo() {
        Bench bench;
        for (std::size_t n = 0; n < haptics::LiveInputs::kCommandRing; ++n)
            QVERIFY(bench.inputs.post({CommandKind::rearm}));
        QVERIFY(!bench.inputs.post({CommandKind::stopForce}));
        bench.tick();
        QVERIFY(bench.inputs.post({CommandKind::stopForce}));
    }

    void nothingBeginsBeforeStart() {
        Bench bench;
        bench.run(100);
        QVERIFY(bench.header().phase == TrialPhase::idle);
        bench.inputs.post({CommandKind::start});
        bench.tick();
        QVERIFY(bench.header().phase == TrialPhase::ready);
        QVERIFY((bench.header().events & core::event_bits::kSceneChanged) != 0);
        bench.run(2500);
        QVERIFY(bench.header().phase == TrialPhase::running);
        QVERIFY(bench.header().force == core::ForceState::on);
    }

    void markByCommandMarksTheTrial() {
        Bench bench(highPath, false);
        bench.inputs.post({CommandKind::start});
        bench.run(20);
        QVERIFY(bench.header().phase == TrialPhase::running);
        bench.inputs.post({CommandKind::mark});
        bench.tick();
        QVERIFY((bench.header().events & core::event_bits::kMarked) != 0);
        bench.tick();
        QVERIFY(bench.header().phase == TrialPhase::between);
    }

    void pausedFramesSayItAndTheTrialsClockStands() {
        Bench bench(highPath, false, benchExercise(1, 1.0));
        bench.inputs.post({CommandKind::start});
        bench.run(100);
        bench.inputs.post({CommandKind::pause});
        bench.tick();
        QCOMPARE(bench.header().paused, std::uint8_t{1});
        const double left_s = bench.bench.loop->display().latest().timeLeft_s;
        bench.run(3000); // longer than the trial's limit
        QCOMPARE(bench.bench.loop->display().latest().timeLeft_s, left_s);
        QVERIFY(bench.header().phase == TrialPhase::running);
        bench.inputs.post({CommandKind::resume});
        bench.tick(); // input-only: force is always ready, so the clock goes on at once
        QCOMPARE(bench.header().paused, std::uint8_t{0});
        bench.tick();
        QVERIFY(bench.bench.loop->display().latest().timeLeft_s < left_s);
    }

    void afterResumeTheClockWaitsUntilForceIsBack() {
        Bench bench;
        bench.inputs.post({CommandKind::start});
        bench.run(2500);
        QVERIFY(bench.header().phase == TrialPhase::running);
        bench.inputs.post({CommandKind::pause});
        bench.run(1000);
        QVERIFY(bench.header().force == core::ForceState::paused);
        bench.inputs.post({CommandKind::resume});
        bench.run(1000); // half of the ramp
        QCOMPARE(bench.header().paused, std::uint8_t{1});
        QVERIFY(bench.header().force == core::ForceState::ramping);
        bench.run(1100);
        QCOMPARE(bench.header().paused, std::uint8_t{0});
        QVERIFY(bench.header().force == core::ForceState::on);
    }

    void stopForceIsZeroWithinTwoTicksAndStaysUntilRearmed() {
        Bench bench(circlingPath);
        bench.inputs.post({CommandKind::start});
        bench.run(6000);
        QVERIFY(bench.device.received.back().wrench_D.force.norm() > 0.5);
        bench.inputs.post({CommandKind::stopForce});
        bench.run(2);
        QVERIFY(bench.device.received.back().wrench_D.force.isZero());
        bench.run(500);
        QVERIFY(bench.header().force == core::ForceState::stopped);
        QVERIFY(bench.device.received.back().wrench_D.force.isZero());
        bench.inputs.post({CommandKind::rearm});
        bench.tick();
        QVERIFY(bench.header().force == core::ForceState::arming);
    }

    void endStopsTheLoopWithMotorsOff() {
        Bench bench(circlingPath);
        bench.inputs.post({CommandKind::start});
        bench.run(6000);
        QVERIFY(bench.device.received.back().enabled);
        bench.inputs.post({CommandKind::end});
        QVERIFY(!bench.tick());
        QVERIFY(!bench.device.received.back().enabled);
        QVERIFY(bench.device.received.back().wrench_D.force.isZero());
        QVERIFY(bench.store.frames.back().tool[0].commanded == core::Array6{});
        QVERIFY(bench.store.frames.back().tool[0].tissue != core::Array6{});
        QVERIFY(bench.bench.loop->display().latest().ended);
    }

    void theLastTrialEndsTheLoop() {
        Bench bench(highPath, false, benchExercise(1, 0.1));
        bench.inputs.post({CommandKind::start});
        int ticks = 1;
        while (bench.tick() && ticks < 1000)
            ++ticks;
        QVERIFY(ticks < 120);
        QVERIFY(bench.header().phase == TrialPhase::finished);
        QVERIFY((bench.header().events & core::event_bits::kFinished) != 0);
    }

    void withoutAWindowThereIsNoHeartbeat() {
        Bench bench;
        bench.run(3000);
        QCOMPARE(bench.header().heartbeatAge_ms, std::uint16_t{0});
        QVERIFY(bench.header().force == core::ForceState::on);
    }

    void aWindowThatFallsSilentTakesForceAway() {
        Bench bench;
        bench.inputs.beat(0);
        bench.run(1);
        for (int n = 0; n < 30; ++n) {
            bench.inputs.beat(bench.now_ns());
            bench.run(100);
            QCOMPARE(bench.header().heartbeatAge_ms, std::uint16_t{99});
        }
        QVERIFY(bench.header().force == core::ForceState::on);
        bench.run(1000);
        QCOMPARE(bench.header().heartbeatAge_ms, std::uint16_t{1099});
        QVERIFY(bench.header().force == core::ForceState::heldByHeartbeat);
        QVERIFY((bench.header().guards & core::guard_bits::kHeartbeat) != 0);
        for (int n = 0; n < 70; ++n) {
            bench.store.frames.clear();
            bench.run(1000);
        }
        QCOMPARE(bench.header().heartbeatAge_ms, UINT16_MAX); // saturated
    }

    void commandsFromAnotherThreadAllArriveInOrder() {
        Bench bench;
        constexpr std::uint16_t kCommands = 2000;
        std::thread window([&] {
            for (std::uint16_t n = 1; n <= kCommands; ++n)
                while (!bench.inputs.post({CommandKind::rearm, n}))
                    std::this_thread::yield();
        });
        std::uint16_t expected = 1;
        bool inOrder = true;
        while (expected <= kCommands) {
            bench.tick();
            for (const core::Command& command : bench.header().commands)
                if (command.kind != CommandKind::none)
                    inOrder = inOrder && command.argument == expected++;
            if (bench.store.frames.size() > 20'000)
                bench.store.frames.clear();
        }
        window.join();
        QVERIFY(inOrder);
    }
};

QTEST_APPLESS_MAIN(TestLoopCommands)
#include "test_loop_commands.moc"
