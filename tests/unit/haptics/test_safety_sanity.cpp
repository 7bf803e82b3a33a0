// SPDX-License-Identifier: GPL-3.0-or-later
// Sample sanity: what is refused, at the edge and just past it.
#include "unit/haptics/safety_rig.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using core::CommandKind;
using core::ForceState;
using core::Vec3;
using haptics::Admission;
using test::SafetyRig;
using test::sixAxisDevice;
namespace guard_bits = core::guard_bits;

class TestSafetySanity : public QObject {
    Q_OBJECT
private slots:
    void quaternionNormMayBeOffByOnePercent();
    void nonFinitePosesAreDropped();
    void jumpsAreMeasuredPerPeriod();
    void lostPacketsAllowMoreOnlyIfTimePassed();
    void packetNumbersMustBeNewerAndWrap();
    void readingTheSamePacketAgainIsNoRepeat();
    void threeBadInARowFaultAndTwoDoNot();
    void aBadPacketReadAgainCountsOnce();
    void rearmTakesTheNewPlace();
    void stopButtonInARefusedPacketStops();
};

void TestSafetySanity::quaternionNormMayBeOffByOnePercent() {
    for (const auto& [norm, expected] : {std::pair{1.0099, Admission::fresh},
                                         {0.9901, Admission::fresh},
                                         {1.0101, Admission::dropped},
                                         {0.9899, Admission::dropped},
                                         {0.0, Admission::dropped}}) {
        SafetyRig rig;
        rig.poses_D[0].q_WT.coeffs() = core::Quat::Identity().coeffs() * norm;
        rig.tick();
        QCOMPARE(rig.admissions[0], expected);
        QCOMPARE((rig.out.guards & guard_bits::kBadSample) != 0, expected == Admission::dropped);
    }
}

void TestSafetySanity::nonFinitePosesAreDropped() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    SafetyRig rig;
    rig.tick();
    rig.poses_D[0].p_WT.y() = nan;
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::dropped);
    rig.poses_D[0].p_WT.y() = std::numeric_limits<double>::infinity();
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::dropped);
    rig.poses_D[0] = {};
    rig.poses_D[0].q_WT.x() = nan;
    SafetyRig other;
    other.poses_D[0].q_WT.x() = nan;
    other.tick();
    QCOMPARE(other.admissions[0], Admission::dropped);
    SafetyRig said;
    said.samples[0].status = core::sample_status::kInvalid; // the driver itself says so
    said.tick();
    QCOMPARE(said.admissions[0], Admission::dropped);
}

void TestSafetySanity::jumpsAreMeasuredPerPeriod() {
    SafetyRig rig;
    rig.tick();
    rig.poses_D[0].p_WT.x() = 0.0199999;
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::fresh);
    rig.poses_D[0].p_WT.x() = 0.0199999 + 0.0200001;
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::dropped);
    rig.tick(); // two periods since the good one: 20 mm is no jump any more
    QCOMPARE(rig.admissions[0], Admission::fresh);
    rig.poses_D[0].p_WT.x() = 1e300;
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::dropped);
}

void TestSafetySanity::lostPacketsAllowMoreOnlyIfTimePassed() {
    SafetyRig rig;
    rig.tick();
    rig.samples[0].packet += 1000; // a number far ahead in the very next tick is no licence to jump
    rig.poses_D[0].p_WT.x() = 0.1;
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::dropped);
    SafetyRig late;
    late.tick();
    late.silent = true;
    late.ticks(5);
    late.silent = false;
    late.samples[0].packet += 5;
    late.poses_D[0].p_WT.x() = 0.1;
    late.tick();
    QCOMPARE(late.admissions[0], Admission::fresh);
}

void TestSafetySanity::packetNumbersMustBeNewerAndWrap() {
    SafetyRig rig;
    rig.samples[0].packet = 0xfffffffeu;
    rig.tick(); // 0xffffffff
    QCOMPARE(rig.admissions[0], Admission::fresh);
    rig.tick(); // 0
    QCOMPARE(rig.samples[0].packet, 0u);
    QCOMPARE(rig.admissions[0], Admission::fresh);
    rig.samples[0].packet = 0xfffffff0u; // older
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::dropped);
    rig.samples[0].packet = 0xffffffffu; // becomes 0: the number of the good one, other content
    rig.samples[0].counts[0] = 17;
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::dropped);
}

void TestSafetySanity::readingTheSamePacketAgainIsNoRepeat() {
    SafetyRig rig;
    rig.arm();
    rig.silent = true;
    rig.ticks(1000);
    QCOMPARE(rig.admissions[0], Admission::repeated);
    QCOMPARE(rig.out.force, ForceState::on); // age_us is 0 here: only its age could count against it
    rig.samples[0].arrival_ns += 5;          // a replay has no arrival times: they do not make a packet new
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::repeated);
}

void TestSafetySanity::threeBadInARowFaultAndTwoDoNot() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    for (int round = 0; round < 3; ++round) {
        rig.samples[0].status = core::sample_status::kInvalid;
        rig.ticks(2);
        QCOMPARE(rig.out.force, ForceState::on);
        rig.samples[0].status = 0;
        rig.tick();
        QCOMPARE(rig.force(), Vec3(0, 0, 1));
    }
    rig.samples[0].status = core::sample_status::kInvalid;
    rig.ticks(3);
    QCOMPARE(rig.out.force, ForceState::fault);
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QVERIFY(rig.out.guards & guard_bits::kSampleFault);
    rig.samples[0].status = 0;
    rig.ticks(100);
    QCOMPARE(rig.out.force, ForceState::fault); // latched
}

void TestSafetySanity::aBadPacketReadAgainCountsOnce() {
    SafetyRig rig;
    rig.arm();
    rig.samples[0].status = core::sample_status::kInvalid;
    rig.tick();
    rig.silent = true;
    rig.ticks(4);
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetySanity::rearmTakesTheNewPlace() {
    SafetyRig rig;
    rig.arm();
    rig.poses_D[0].p_WT.x() = 0.3;
    rig.ticks(3);
    QCOMPARE(rig.out.force, ForceState::fault);
    rig.tick({CommandKind::rearm});
    QCOMPARE(rig.out.force, ForceState::arming);
    rig.tick();
    QCOMPARE(rig.admissions[0], Admission::fresh);
    rig.ticks(4 + 2000);
    QCOMPARE(rig.out.force, ForceState::on);
}

void TestSafetySanity::stopButtonInARefusedPacketStops() {
    SafetyRig rig;
    rig.arm();
    rig.samples[0].status = core::sample_status::kInvalid;
    rig.samples[0].buttons = core::kButtonStop;
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::stopped);
}

QTEST_APPLESS_MAIN(TestSafetySanity)
#include "test_safety_sanity.moc"
