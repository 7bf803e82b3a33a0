// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;
using simulation::ProcedureStage;

namespace {

/// A straight canal along z: s is z, the bladder begins at 50 mm, one landmark 60 mm straight ahead of the
/// neck.
ProcedurePlan straightPlan(std::size_t landmarks = 1) {
    ProcedurePlan plan;
    plan.beak_m = 0.010;
    plan.goal_m = 0.060;
    plan.neck_m = 0.050;
    plan.landmarks = landmarks;
    plan.landmark_A[0] = {0.0, 0.0, 0.110};
    plan.landmark_A[1] = {0.030, 0.0, 0.090};
    plan.cosHalfAngle = std::cos(core::radFromDeg(15.0));
    plan.distance_m = 0.080;
    plan.speed_m_per_s = 0.005;
    plan.hold_us = 500000;
    return plan;
}

ProcedureSample at(double z_m, const Vec3& axis = Vec3::UnitZ(), double x_m = 0.0) {
    return {z_m, Vec3(x_m, 0.0, z_m), axis, std::abs(x_m)};
}

/// Holds a pose for so many milliseconds; what became seen.
std::uint32_t hold(ProcedureTracker& tracker, const ProcedureSample& sample, int ms) {
    std::uint32_t seen = 0;
    for (int i = 0; i < ms; ++i)
        seen |= tracker.advance(sample, 1000).seenNow;
    return seen;
}

} // namespace

class TestProcedureTracker : public QObject {
    Q_OBJECT
private slots:
    void stagesFollowOneAnother();
    void stagesOnlyGoForward();
    void withoutLandmarksInsertionIsFollowedByWithdrawal();
    void withoutWithdrawalTheGoalEndsIt();
    void startingInsideRunsThroughTheStages();
    void besideTheCanalIsNotInIt();
    void landmarkNeedsItsWholeTime();
    void aBreakBeginsAnew();
    void everyConditionCounts_data();
    void everyConditionCounts();
    void eitherOrderAndBothAtOnce();
    void tremorIsNoMovement();
    void speedIsMeasuredOverItsWindow();
    void coarserSamplesSeeTheSame();
    void notANumberIsPassedOver();
    void planPutsLandmarksOnTheWall();
};

void TestProcedureTracker::stagesFollowOneAnother() {
    ProcedureTracker tracker(straightPlan());
    QVERIFY(!tracker.advance(at(-0.0101), 1000).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::outside);
    QVERIFY(tracker.advance(at(-0.0099), 1000).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::insertion);
    QVERIFY(!tracker.advance(at(0.0599), 1000).stageChanged);
    QVERIFY(tracker.advance(at(0.060), 1000).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::inspection);
    QCOMPARE(tracker.nextLandmark(), 0);
    QCOMPARE(hold(tracker, at(0.060), 1000), 1u);
    QCOMPARE(tracker.stage(), ProcedureStage::withdrawal);
    QCOMPARE(tracker.nextLandmark(), -1);
    tracker.advance(at(-0.0099), 1000);
    QCOMPARE(tracker.stage(), ProcedureStage::withdrawal);
    QVERIFY(tracker.advance(at(-0.0101), 1000).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::completed);
    QVERIFY(!tracker.advance(at(0.060), 1000).stageChanged); // done is done
}

void TestProcedureTracker::stagesOnlyGoForward() {
    ProcedureTracker tracker(straightPlan());
    tracker.advance(at(0.0), 1000);
    tracker.advance(at(-0.030), 1000); // out again on the way in: still the way in
    QCOMPARE(tracker.stage(), ProcedureStage::insertion);
    tracker.advance(at(0.061), 1000);
    tracker.advance(at(0.010), 1000);
    QCOMPARE(tracker.stage(), ProcedureStage::inspection);
}

void TestProcedureTracker::withoutLandmarksInsertionIsFollowedByWithdrawal() {
    ProcedureTracker tracker(straightPlan(0));
    tracker.advance(at(0.0), 1000);
    tracker.advance(at(0.060), 1000);
    QCOMPARE(tracker.stage(), ProcedureStage::withdrawal);
}

void TestProcedureTracker::withoutWithdrawalTheGoalEndsIt() {
    ProcedurePlan plan = straightPlan(0);
    plan.withdraws = false;
    ProcedureTracker tracker(plan);
    tracker.advance(at(0.0), 1000);
    tracker.advance(at(0.060), 1000);
    QCOMPARE(tracker.stage(), ProcedureStage::completed);
}

void TestProcedureTracker::startingInsideRunsThroughTheStages() {
    ProcedureTracker tracker(straightPlan());
    QVERIFY(tracker.advance(at(0.065), 0).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::inspection);
}

// A tip pushed along 30 mm beside the canal is neither inserted nor at the goal, however far it goes; out is
// out anywhere.
void TestProcedureTracker::besideTheCanalIsNotInIt() {
    ProcedureTracker tracker(straightPlan(0));
    for (const double x : {0.030, 0.0101}) {
        for (const double z : {-0.005, 0.020, 0.060, 0.080})
            QVERIFY(!tracker.advance(at(z, Vec3::UnitZ(), x), 1000).stageChanged);
        QCOMPARE(tracker.stage(), ProcedureStage::outside);
    }
    QVERIFY(tracker.advance(at(0.0, Vec3::UnitZ(), 0.0099), 1000).stageChanged);
    QVERIFY(!tracker.advance(at(0.065, Vec3::UnitZ(), 0.0101), 1000).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::insertion);
    QVERIFY(tracker.advance(at(0.065, Vec3::UnitZ(), 0.0099), 1000).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::withdrawal);
    QVERIFY(tracker.advance(at(-0.0101, Vec3::UnitZ(), 0.030), 1000).stageChanged);
    QCOMPARE(tracker.stage(), ProcedureStage::completed);
}

void TestProcedureTracker::landmarkNeedsItsWholeTime() {
    ProcedureTracker tracker(straightPlan());
    tracker.advance(at(0.060), 1000); // the first sample has no time
    QCOMPARE(hold(tracker, at(0.060), 499), 0u);
    QVERIFY(std::abs(tracker.dwell() - 0.998) < 1e-9);
    QCOMPARE(hold(tracker, at(0.060), 1), 1u);
    QCOMPARE(tracker.seen(), 1u);
}

void TestProcedureTracker::aBreakBeginsAnew() {
    ProcedureTracker tracker(straightPlan());
    tracker.advance(at(0.060), 1000);
    hold(tracker, at(0.060), 400);
    hold(tracker, at(0.060, Vec3::UnitX()), 1); // looked away for one sample
    QCOMPARE(tracker.dwell(), 0.0);
    QCOMPARE(hold(tracker, at(0.060), 499), 0u);
    QCOMPARE(hold(tracker, at(0.060), 1), 1u);
}

void TestProcedureTracker::everyConditionCounts_data() {
    QTest::addColumn<double>("z");
    QTest::addColumn<double>("angle_deg");
    QTest::addColumn<bool>("seen");
    QTest::newRow("straight ahead") << 0.060 << 0.0 << true;
    QTest::newRow("within the angle") << 0.060 << 14.9 << true;
    QTest::newRow("beyond the angle") << 0.060 << 15.1 << false;
    QTest::newRow("behind the tip") << 0.060 << 180.0 << false;
    QTest::newRow("beyond the neck") << 0.0501 << 0.0 << true;
    QTest::newRow("before the neck") << 0.0499 << 0.0 << false;
    QTest::newRow("too far") << 0.029 << 0.0 << false;
}

void TestProcedureTracker::everyConditionCounts() {
    QFETCH(double, z);
    QFETCH(double, angle_deg);
    QFETCH(bool, seen);
    ProcedureTracker tracker(straightPlan());
    tracker.advance(at(0.061), 1000);
    const double angle = core::radFromDeg(angle_deg);
    QCOMPARE(hold(tracker, at(z, Vec3(std::sin(angle), 0.0, std::cos(angle))), 800) != 0, seen);
    ProcedurePlan far = straightPlan();
    far.distance_m = 0.049; // the same place, 50 mm away
    ProcedureTracker distant(far);
    distant.advance(at(0.060), 1000);
    QCOMPARE(hold(distant, at(0.060), 800), 0u);
}

void TestProcedureTracker::eitherOrderAndBothAtOnce() {
    ProcedureTracker tracker(straightPlan(2));
    tracker.advance(at(0.060), 1000);
    const Vec3 toSecond = Vec3(0.030, 0.0, 0.030).normalized();
    QCOMPARE(hold(tracker, at(0.060, toSecond), 600), 2u);
    QCOMPARE(tracker.nextLandmark(), 0);
    QCOMPARE(tracker.stage(), ProcedureStage::inspection);
    QCOMPARE(hold(tracker, at(0.060), 600), 1u);
    QCOMPARE(tracker.stage(), ProcedureStage::withdrawal);
    ProcedurePlan wide = straightPlan(2);
    wide.cosHalfAngle = std::cos(core::radFromDeg(50.0));
    ProcedureTracker both(wide);
    both.advance(at(0.060), 1000);
    QCOMPARE(hold(both, at(0.060), 600), 3u);
}

// A held hand trembles with 0.1 mm at 8 to 12 Hz (models.md §4): 6 mm/s from tick to tick, and still no
// movement.
void TestProcedureTracker::tremorIsNoMovement() {
    for (const double frequency_Hz : {8.0, 10.0, 12.0}) {
        ProcedureTracker tracker(straightPlan());
        std::uint32_t seen = 0;
        tracker.advance(at(0.061), 1000);
        for (int ms = 0; ms < 1500; ++ms) {
            const double x = 0.1e-3 * std::sqrt(2.0) * std::sin(2.0 * core::kPi * frequency_Hz * ms * 1e-3);
            seen |= tracker.advance(at(0.061, Vec3::UnitZ(), x), 1000).seenNow;
        }
        QCOMPARE(seen, 1u);
    }
    ProcedureTracker drifting(straightPlan()); // 6 mm/s on purpose is one
    std::uint32_t seen = 0;
    for (int ms = 0; ms < 1500; ++ms)
        seen |= drifting.advance(at(0.061, Vec3::UnitZ(), 6e-6 * ms), 1000).seenNow;
    QCOMPARE(seen, 0u);
}

void TestProcedureTracker::speedIsMeasuredOverItsWindow() {
    ProcedureTracker tracker(straightPlan());
    hold(tracker, at(0.0), 300);
    QCOMPARE(tracker.speed_m_per_s(), 0.0);
    for (int ms = 1; ms <= 50; ++ms)
        tracker.advance(at(20e-6 * ms), 1000); // 20 mm/s for half a window
    QVERIFY(std::abs(tracker.speed_m_per_s() - 0.010) < 1e-9);
    for (int ms = 51; ms <= 400; ++ms)
        tracker.advance(at(20e-6 * ms), 1000);
    QVERIFY(std::abs(tracker.speed_m_per_s() - 0.020) < 1e-9);
    hold(tracker, at(20e-6 * 400), 101);
    QVERIFY(tracker.speed_m_per_s() < 1e-12);
}

// A device that reports every 4 ms, or every 0.25 ms, inspects the same landmark at the same time.
void TestProcedureTracker::coarserSamplesSeeTheSame() {
    for (const int step_us : {250, 1000, 4000}) {
        ProcedureTracker tracker(straightPlan());
        int seen_us = -1;
        for (int t_us = 0; t_us <= 3000000 && seen_us < 0; t_us += step_us) {
            const double z = std::min(0.061, 0.030e-6 * t_us); // 30 mm/s, then still from 2.033 s on
            if (tracker.advance(at(z), static_cast<std::uint64_t>(step_us)).seenNow != 0)
                seen_us = t_us;
        }
        // 61 mm are reached at 2.0333 s, the mean speed over 0.1 s falls below 5 mm/s at 2.117 s, and it is
        // held for 0.5 s.
        QVERIFY2(std::abs(seen_us - 2617000) <= 2 * step_us + 1000, qPrintable(QString::number(seen_us)));
    }
}

void TestProcedureTracker::notANumberIsPassedOver() {
    ProcedureTracker tracker(straightPlan());
    tracker.advance(at(0.060), 1000);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ProcedureStep step = tracker.advance({nan, Vec3(nan, 0.0, 0.0), Vec3::UnitZ()}, 1000);
    QVERIFY(!step.stageChanged && step.seenNow == 0);
    QCOMPARE(hold(tracker, at(0.060), 600), 1u);
}

void TestProcedureTracker::planPutsLandmarksOnTheWall() {
    UrethraInsertionParameters p;
    p.landmarks = {{"ahead", 0.0, 0.0}, {"right", 1.0, 0.0}, {"front", 1.0, core::radFromDeg(90.0)}};
    const ProcedurePlan plan = procedurePlan(p);
    const UrethraCentreline line(p.anatomy);
    QCOMPARE(plan.landmarks, std::size_t{3});
    QVERIFY(std::abs(plan.goal_m - (line.length_m() + 0.010)) < 1e-12);
    const Vec3 centre = bladderCentre_A(p.anatomy, line);
    const Vec3 neck(0.0, 13.0 * 0.0877 * 0.0877, 0.0877);
    QVERIFY(std::abs((centre - neck).norm() - 0.035) < 1e-9);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 landmark(plan.landmark_A[i][0], plan.landmark_A[i][1], plan.landmark_A[i][2]);
        QVERIFY(std::abs((landmark - centre).norm() - 0.035) < 1e-9);
    }
    QVERIFY(
        std::abs((Vec3(plan.landmark_A[0][0], plan.landmark_A[0][1], plan.landmark_A[0][2]) - neck).norm() -
                 0.070) < 1e-9);
    QVERIFY(plan.landmark_A[1][0] > 0.029); // +x̂ is the patient's right
    const Vec3 front = Vec3(plan.landmark_A[2][0], plan.landmark_A[2][1], plan.landmark_A[2][2]) - neck;
    QVERIFY(front.dot(line.atZ(p.anatomy.zEnd_m).n_A) > 0.029); // n̂ points to the front of the patient
    p.goalDepth_m = 0.035;
    QCOMPARE(procedurePlan(p).goal_m, 0.035);
}

QTEST_APPLESS_MAIN(TestProcedureTracker)
#include "test_procedure_tracker.moc"
