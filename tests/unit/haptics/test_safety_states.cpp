// SPDX-License-Identifier: GPL-3.0-or-later
// Arming, stop, pause, frozen window, watchdog, faults: every threshold of models.md §5 at and just past its edge.
#include "unit/haptics/safety_rig.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using core::CommandKind;
using core::ForceState;
using core::Vec3;
using haptics::ArmingWait;
using test::SafetyRig;
using test::sixAxisDevice;
namespace guard_bits = core::guard_bits;

class TestSafetyStates : public QObject {
    Q_OBJECT
private slots:
    void armsAfterFourQuietTicksThenRampsFor2000();
    void armingThresholdsAreStrict();
    void anInterruptedQuietSpellStartsAgain();
    void confirmationNeedsHalfASecondHeldStill();
    void deadManCountsOnlyWhileHeld();
    void sceneChangeTakesForceAwayAtOnce();
    void stopIsZeroInTheSameTickAndStays();
    void stopButtonMustBeReleasedBeforeRearm();
    void stopBeatsRearmInTheSameTick();
    void pauseRampsToZeroIn500TicksAndResumesByArming();
    void frozenWindowActsAt250ms();
    void headlessHasNoWindow();
    void watchdogFollowsItsThresholds_data();
    void watchdogFollowsItsThresholds();
    void aLateSpellIsFollowedByTheArmingRamp();
    void refusedPacketsGrowOld();
    void slowDevicesRenderNothing();
    void inProcessDevicesHaveNoAge();
    void inputOnlyIsAlwaysReadyAndNeverFaults();
    void deviceFaultLatches();
    void notFiniteRequestIsZeroAndLatches();
    void waitsForIsSaid();
};

void TestSafetyStates::armsAfterFourQuietTicksThenRampsFor2000() {
    SafetyRig rig;
    rig.ask(Vec3(0.19, 0, 0));
    QCOMPARE(rig.tick().force, ForceState::arming); // the first packet came in this tick
    rig.ticks(3);
    QCOMPARE(rig.out.force, ForceState::arming);
    QCOMPARE(rig.tick().force, ForceState::ramping);
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    rig.ask(Vec3(1, 0, 0)); // within the ramp the request may grow
    for (int k = 1; k <= 2000; ++k) {
        rig.tick();
        QVERIFY(std::abs(rig.force().x() - k / 2000.0) < 1e-12);
        QCOMPARE(rig.out.forceReady, k == 2000);
    }
    QCOMPARE(rig.out.force, ForceState::on);
    QCOMPARE(rig.out.guards, 0u);
}

void TestSafetyStates::armingThresholdsAreStrict() {
    SafetyRig force;
    force.ask(Vec3(0.2, 0, 0)); // not below 0.2 N
    force.ticks(5000);
    QCOMPARE(force.out.force, ForceState::arming);
    SafetyRig torque;
    torque.ask(Vec3::Zero(), Vec3(0, 0, 0.010)); // not below 10 mN·m
    torque.ticks(5000);
    QCOMPARE(torque.out.force, ForceState::arming);
    torque.ask(Vec3::Zero(), Vec3(0, 0, 0.0099));
    torque.ticks(4);
    QCOMPARE(torque.out.force, ForceState::ramping);
}

void TestSafetyStates::anInterruptedQuietSpellStartsAgain() {
    SafetyRig rig;
    rig.ticks(1 + 3);
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    rig.ask(Vec3::Zero());
    rig.ticks(3);
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::ramping);
}

void TestSafetyStates::confirmationNeedsHalfASecondHeldStill() {
    SafetyRig rig;
    rig.ask(Vec3(0, 0, 1.5));
    rig.states.tools[0].v_WT = Vec3(0.0049, 0, 0);
    rig.ticks(700);
    QCOMPARE(rig.out.force, ForceState::arming); // still, but nobody confirmed
    rig.tick({CommandKind::confirmHold});        // still tick 1
    QCOMPARE(rig.out.waitsFor, ArmingWait::holdStill);
    rig.ticks(300);
    rig.states.tools[0].v_WT = Vec3(0.005, 0, 0); // not slower than 5 mm/s
    rig.tick();
    rig.states.tools[0].v_WT = Vec3(0.0049, 0, 0);
    rig.ticks(499);
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::ramping);
    rig.ticks(2000);
    QVERIFY(std::abs(rig.force().z() - 1.5) < 1e-12);
}

void TestSafetyStates::deadManCountsOnlyWhileHeld() {
    SafetyRig rig;
    rig.ask(Vec3(0, 0, 1.5));
    rig.samples[0].buttons = core::kButtonDeadMan;
    rig.ticks(1 + 499);
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.samples[0].buttons = 0;
    rig.tick();
    rig.samples[0].buttons = core::kButtonDeadMan;
    rig.ticks(499);
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::ramping);
}

void TestSafetyStates::sceneChangeTakesForceAwayAtOnce() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    QCOMPARE(rig.force(), Vec3(0, 0, 1));
    rig.scene.events = core::event_bits::kSceneChanged;
    rig.tick();
    rig.scene.events = 0;
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QCOMPARE(rig.out.force, ForceState::arming);
    QVERIFY(!rig.out.tools[0].enabled);
    rig.ticks(3000);
    QCOMPARE(rig.out.force, ForceState::arming); // 1 N is not quiet
}

void TestSafetyStates::stopIsZeroInTheSameTickAndStays() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    rig.tick({CommandKind::stopForce});
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QCOMPARE(rig.out.force, ForceState::stopped);
    QVERIFY(rig.out.guards & guard_bits::kStop);
    rig.ask(Vec3::Zero());
    rig.ticks(5000);
    QCOMPARE(rig.out.force, ForceState::stopped);
    rig.tick({CommandKind::resume}); // only re-arm lifts a stop
    QCOMPARE(rig.out.force, ForceState::stopped);
    rig.tick({CommandKind::rearm});
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.ticks(5 + 2000);
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetyStates::stopButtonMustBeReleasedBeforeRearm() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.samples[0].buttons = core::kButtonStop;
    rig.tick();
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    rig.tick({CommandKind::rearm});
    QCOMPARE(rig.out.force, ForceState::stopped);
    QCOMPARE(rig.out.waitsFor, ArmingWait::stopReleased);
    rig.samples[0].buttons = 0;
    rig.tick({CommandKind::rearm});
    QCOMPARE(rig.out.force, ForceState::arming);
}

void TestSafetyStates::stopBeatsRearmInTheSameTick() {
    SafetyRig rig;
    rig.arm();
    rig.tick({CommandKind::stopForce, CommandKind::rearm});
    QCOMPARE(rig.out.force, ForceState::stopped);
    rig.tick({CommandKind::rearm, CommandKind::stopForce});
    QCOMPARE(rig.out.force, ForceState::stopped);
}

void TestSafetyStates::pauseRampsToZeroIn500TicksAndResumesByArming() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    for (int k = 1; k <= 500; ++k) {
        k == 1 ? rig.tick({CommandKind::pause}) : rig.tick();
        QVERIFY(std::abs(rig.force().z() - (1.0 - k / 500.0)) < 1e-9);
        QVERIFY(rig.out.paused);
    }
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QCOMPARE(rig.out.force, ForceState::paused);
    rig.tick({CommandKind::resume});
    QVERIFY(!rig.out.paused);
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.ticks(3000);
    QCOMPARE(rig.force(), Vec3(0, 0, 0)); // 1 N is requested: it waits
    rig.ask(Vec3::Zero());
    rig.ticks(4 + 2000);
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetyStates::frozenWindowActsAt250ms() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.heartbeatAge_ms = 249;
    rig.tick();
    QCOMPARE(rig.force(), Vec3(0, 0, 1));
    rig.heartbeatAge_ms = 250;
    for (int k = 1; k <= 500; ++k) {
        rig.tick();
        QVERIFY(std::abs(rig.force().z() - (1.0 - k / 500.0)) < 1e-9);
        QCOMPARE(rig.out.force, ForceState::heldByHeartbeat);
    }
    rig.heartbeatAge_ms = std::numeric_limits<std::uint16_t>::max();
    rig.ticks(100);
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QCOMPARE(rig.out.waitsFor, ArmingWait::window);
    rig.heartbeatAge_ms = 10;
    rig.ticks(10);
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.ask(Vec3::Zero());
    rig.ticks(4 + 2000);
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetyStates::headlessHasNoWindow() {
    haptics::SafetySettings settings;
    settings.heartbeatWatched = false;
    SafetyRig rig(sixAxisDevice(), settings);
    rig.heartbeatAge_ms = 65535;
    rig.arm();
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetyStates::watchdogFollowsItsThresholds_data() {
    QTest::addColumn<unsigned>("period_us");
    QTest::addColumn<unsigned>("start_us");
    QTest::addColumn<unsigned>("zero_us");
    QTest::addColumn<unsigned>("fault_us");
    QTest::newRow("1 kHz") << 1000u << 5000u << 15000u << 30000u;
    QTest::newRow("500 Hz") << 2000u << 6000u << 16000u << 30000u;
    QTest::newRow("250 Hz, the slowest") << 4000u << 12000u << 22000u << 40000u;
}

void TestSafetyStates::watchdogFollowsItsThresholds() {
    QFETCH(unsigned, period_us);
    QFETCH(unsigned, start_us);
    QFETCH(unsigned, zero_us);
    QFETCH(unsigned, fault_us);
    auto device = sixAxisDevice();
    device.period_us = period_us;
    const auto forceAt = [&](unsigned age_us, ForceState& state) {
        SafetyRig rig(device);
        rig.arm();
        rig.ask(Vec3(0, 0, 1));
        rig.tick();
        rig.silent = true;
        rig.age_us = age_us;
        rig.tick();
        state = rig.out.force;
        return rig.force().z();
    };
    ForceState state{};
    QCOMPARE(forceAt(start_us, state), 1.0);
    QCOMPARE(state, ForceState::on);
    QVERIFY(std::abs(forceAt(start_us + 1, state) - 0.9999) < 1e-8);
    QCOMPARE(state, ForceState::heldByWatchdog);
    QVERIFY(std::abs(forceAt(start_us + 5000, state) - 0.5) < 1e-8);
    QVERIFY(forceAt(zero_us - 1, state) > 0.0);
    QCOMPARE(forceAt(zero_us, state), 0.0);
    QCOMPARE(forceAt(fault_us - 1, state), 0.0);
    QCOMPARE(state, ForceState::heldByWatchdog);
    QCOMPARE(forceAt(fault_us, state), 0.0);
    QCOMPARE(state, ForceState::fault);
}

void TestSafetyStates::aLateSpellIsFollowedByTheArmingRamp() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    rig.silent = true;
    rig.age_us = 10000;
    rig.tick();
    QVERIFY(std::abs(rig.force().z() - 0.5) < 1e-8);
    rig.silent = false;
    rig.age_us = 0;
    rig.tick();
    QVERIFY(std::abs(rig.force().z() - 0.5005) < 1e-8);
    rig.ticks(999);
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetyStates::refusedPacketsGrowOld() {
    // Packets keep coming in time, but their numbers stand still: the newest *good* one ages by now_ns.
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    rig.samples[0].packet -= 1; // tick() adds one: the same number again, with new content
    rig.tick();
    QCOMPARE(rig.admissions[0], haptics::Admission::dropped);
    rig.silent = true; // the refused packet is read again and again
    for (int k = 0; k < 4; ++k) {
        rig.tick();
    }
    QCOMPARE(rig.force().z(), 1.0); // 5 ms old
    rig.tick();
    QVERIFY(std::abs(rig.force().z() - 0.9) < 1e-8); // 6 ms
    rig.ticks(9);
    QCOMPARE(rig.force().z(), 0.0); // 15 ms
    rig.ticks(15);
    QCOMPARE(rig.out.force, ForceState::fault); // 30 ms
}

void TestSafetyStates::slowDevicesRenderNothing() {
    auto device = sixAxisDevice();
    device.period_us = 4001;
    SafetyRig rig(device);
    QVERIFY(!rig.supervisor.rendersForce(0));
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QVERIFY(rig.out.forceReady);
}

void TestSafetyStates::inProcessDevicesHaveNoAge() {
    auto device = sixAxisDevice();
    device.inProcess = true;
    SafetyRig rig(device);
    rig.age_us = 1'000'000; // not a fact about a device that is stepped in the tick
    rig.arm();
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetyStates::inputOnlyIsAlwaysReadyAndNeverFaults() {
    auto device = sixAxisDevice();
    device.rendersForce = false;
    SafetyRig rig(device);
    rig.ask(Vec3(0, 0, 2));
    rig.heartbeatAge_ms = 60000;
    rig.tick();
    QVERIFY(rig.out.forceReady);
    rig.silent = true;
    for (const std::uint32_t age : {1'999'999u, 2'000'000u, 4'000'000'000u}) {
        rig.age_us = age;
        rig.tick();
        QCOMPARE(rig.out.tools[0].noMovement, age >= 2'000'000u);
        QVERIFY(rig.out.forceReady);
        QCOMPARE(rig.out.force, ForceState::off);
        QCOMPARE(rig.force(), Vec3(0, 0, 0));
        QCOMPARE(rig.out.guards, 0u);
    }
    rig.silent = false;
    rig.age_us = 0;
    rig.poses_D[0].p_WT.x() = std::numeric_limits<double>::quiet_NaN();
    rig.ticks(3);
    QVERIFY(rig.out.guards & guard_bits::kSampleFault); // said, but nothing latches
    rig.poses_D[0].p_WT.x() = 0.5;                      // far from where it was: taken as the new place
    rig.tick();
    QCOMPARE(rig.admissions[0], haptics::Admission::fresh);
    QVERIFY(rig.out.forceReady);
    rig.tick({CommandKind::pause});
    QVERIFY(rig.out.paused);
}

void TestSafetyStates::deviceFaultLatches() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.samples[0].status = core::sample_status::kDeviceFault;
    rig.tick();
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QVERIFY(rig.out.guards & guard_bits::kDeviceFault);
    rig.tick({CommandKind::rearm}); // the cause still holds
    QCOMPARE(rig.out.force, ForceState::fault);
    rig.samples[0].status = 0;
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::fault);
    rig.tick({CommandKind::rearm});
    QCOMPARE(rig.out.force, ForceState::arming);
}

void TestSafetyStates::notFiniteRequestIsZeroAndLatches() {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        SafetyRig rig;
        rig.arm();
        rig.ask(Vec3(0, 0, bad));
        rig.tick();
        QCOMPARE(rig.force(), Vec3(0, 0, 0));
        QCOMPARE(rig.out.force, ForceState::fault);
        QVERIFY(rig.out.guards & guard_bits::kNotFinite);
        QVERIFY(!rig.out.tools[0].enabled);
    }
}

void TestSafetyStates::waitsForIsSaid() {
    SafetyRig rig;
    rig.poses_D[0].q_WT.coeffs().setZero(); // no sane packet yet
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::off);
    QCOMPARE(rig.out.waitsFor, ArmingWait::firstPacket);
    rig.poses_D[0].q_WT = core::Quat::Identity();
    rig.ask(Vec3(0, 0, 1));
    rig.tick();
    QCOMPARE(rig.out.waitsFor, ArmingWait::smallRequest);
    rig.ask(Vec3::Zero());
    rig.ticks(4);
    QCOMPARE(rig.out.waitsFor, ArmingWait::ramp);
    rig.ticks(2000);
    QCOMPARE(rig.out.waitsFor, ArmingWait::nothing);
    rig.tick({CommandKind::pause});
    QCOMPARE(rig.out.waitsFor, ArmingWait::resume);
    rig.tick({CommandKind::stopForce});
    QCOMPARE(rig.out.waitsFor, ArmingWait::rearm);
}

QTEST_APPLESS_MAIN(TestSafetyStates)
#include "test_safety_states.moc"
