// SPDX-License-Identifier: GPL-3.0-or-later
// Arming, stop, pause, frozen window: every threshold of models.md §5 at and just past its edge.
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
