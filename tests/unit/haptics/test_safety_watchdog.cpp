// SPDX-License-Identifier: GPL-3.0-or-later
// Watchdog and faults: every threshold of models.md §5 at and just past its edge.
#include "unit/haptics/safety_rig.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using core::CommandKind;
using core::ForceState;
using core::Vec3;
using test::SafetyRig;
using test::sixAxisDevice;
namespace guard_bits = core::guard_bits;

class TestSafetyWatchdog : public QObject {
    Q_OBJECT
private slots:
    void watchdogFollowsItsThresholds_data();
    void watchdogFollowsItsThresholds();
    void aLateSpellIsFollowedByTheArmingRamp();
    void refusedPacketsGrowOld();
    void slowDevicesRenderNothing();
    void inProcessDevicesHaveNoAge();
    void inputOnlyIsAlwaysReadyAndNeverFaults();
    void deviceFaultLatches();
    void notFiniteRequestIsZeroAndLatches();
};

void TestSafetyWatchdog::watchdogFollowsItsThresholds_data() {
    QTest::addColumn<unsigned>("period_us");
    QTest::addColumn<unsigned>("start_us");
    QTest::addColumn<unsigned>("zero_us");
    QTest::addColumn<unsigned>("fault_us");
    QTest::newRow("1 kHz") << 1000u << 5000u << 15000u << 30000u;
    QTest::newRow("500 Hz") << 2000u << 6000u << 16000u << 30000u;
    QTest::newRow("250 Hz, the slowest") << 4000u << 12000u << 22000u << 40000u;
}

void TestSafetyWatchdog::watchdogFollowsItsThresholds() {
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

void TestSafetyWatchdog::aLateSpellIsFollowedByTheArmingRamp() {
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

void TestSafetyWatchdog::refusedPacketsGrowOld() {
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

void TestSafetyWatchdog::slowDevicesRenderNothing() {
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

void TestSafetyWatchdog::inProcessDevicesHaveNoAge() {
    auto device = sixAxisDevice();
    device.inProcess = true;
    SafetyRig rig(device);
    rig.age_us = 1'000'000; // not a fact about a device that is stepped in the tick
    rig.arm();
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetyWatchdog::inputOnlyIsAlwaysReadyAndNeverFaults() {
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

void TestSafetyWatchdog::deviceFaultLatches() {
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

void TestSafetyWatchdog::notFiniteRequestIsZeroAndLatches() {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
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

QTEST_APPLESS_MAIN(TestSafetyWatchdog)
#include "test_safety_watchdog.moc"
