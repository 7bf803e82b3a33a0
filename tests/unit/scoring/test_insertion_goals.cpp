// SPDX-License-Identifier: GPL-3.0-or-later
// What an insertion came to: torques, landmarks, the tip's travel while they were visited, and how deep it
// went.
#include "insertion_traces.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::scoring;
using traces::CanalSample;
using traces::canalSession;
using traces::canalTrial;
using traces::metricOf;
using traces::ProcedureStage;
using traces::straightIn;
using traces::valueOf;
using traces::Vec3;

namespace {

constexpr double kPi = 3.14159265358979323846;

bool isNear(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

} // namespace

class TestInsertionGoals : public QObject {
    Q_OBJECT
private slots:
    void torques();
    void landmarks();
    void procedureCompleted();
    void inspectionTravel();
    void depthStopsAtTheGoal();
    void depthIsInTheCanal();
};

void TestInsertionGoals::torques() {
    auto trial = straightIn();
    trial.tools[0].tissueTorque_Nm.assign(trial.tools[0].t_s.size(), Vec3(0.003, 0.004, 0.0));
    trial.tools[0].tissueTorque_Nm[500] = Vec3(0.0, -0.060, 0.080);
    const auto n = static_cast<double>(trial.tools[0].t_s.size());
    const auto trace = canalSession(trial);
    QVERIFY(isNear(valueOf(trace, "torque_max"), 100.0, 1e-9));
    QVERIFY(isNear(valueOf(trace, "torque_rms"), std::sqrt((25.0 * (n - 1.0) + 10000.0) / n), 1e-9));
    QCOMPARE(metricOf(canalSession(straightIn()), "torque_max").reason,
             std::string("the trace has no torques"));
    QCOMPARE(metricOf(canalSession(straightIn()), "torque_rms").reason,
             std::string("the trace has no torques"));
    auto paused = trial;
    paused.tools[0].paused[500] = 1;
    QVERIFY(isNear(valueOf(canalSession(paused), "torque_max"), 5.0, 1e-9));
}

void TestInsertionGoals::procedureCompleted() {
    auto trial = straightIn();
    trial.completed = true;
    QCOMPARE(valueOf(canalSession(trial), "procedure_completed"), 100.0);
    auto timedOut = straightIn();
    timedOut.timedOut = true;
    QCOMPARE(valueOf(canalSession(timedOut), "procedure_completed"), 0.0);
    QCOMPARE(valueOf(canalSession({trial, timedOut}), "procedure_completed"), 50.0);
}

void TestInsertionGoals::landmarks() {
    constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
    auto trial = straightIn();
    QCOMPARE(metricOf(canalSession(trial), "landmarks_seen").reason,
             std::string("the level has no landmarks"));
    insertionIn(trial).landmarkSeen_s = {kNever, kNever};
    QCOMPARE(valueOf(canalSession(trial), "landmarks_seen"), 0.0);
    insertionIn(trial).landmarkSeen_s = {8.0, kNever, 9.5};
    QVERIFY(isNear(valueOf(canalSession(trial), "landmarks_seen"), 200.0 / 3.0, 1e-12));
    auto other = straightIn();
    insertionIn(other).landmarkSeen_s = {7.0};
    QVERIFY(isNear(valueOf(canalSession({trial, other}), "landmarks_seen"), 75.0, 1e-12)); // three of four
    insertionIn(trial).landmarkSeen_s = {10.5}; // after the trial's last sample: not in it
    QCOMPARE(valueOf(canalSession(trial), "landmarks_seen"), 0.0);
}

void TestInsertionGoals::inspectionTravel() {
    // 2 s in, 4 s round a circle of 5 mm once, 2 s out; still at both ends of the circle, so that no filter
    // moves it.
    auto trial = canalTrial(8.0, 0.001, [](double t) {
        CanalSample sample;
        sample.s_m = 0.115;
        sample.stage = t < 2.0   ? ProcedureStage::insertion
                       : t < 6.0 ? ProcedureStage::inspection
                                 : ProcedureStage::withdrawal;
        return sample;
    });
    insertionIn(trial).landmarkSeen_s = {5.0};
    const auto place = [](double t) {
        const double u = std::min(1.0, std::max(0.0, (t - 2.5) / 3.0));
        const double turn = 2.0 * kPi * u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
        const double way = t < 2.0 ? t - 2.0 : t > 6.0 ? 6.0 - t : 0.0;
        return Vec3(0.005 * std::cos(turn), 0.005 * std::sin(turn), 0.02 * way);
    };
    for (std::size_t i = 0; i < trial.tools[0].t_s.size(); ++i)
        trial.tools[0].p_WT_m[i] = place(trial.tools[0].t_s[i]);
    const double circle_mm = 2.0 * kPi * 5.0;
    // The 20 Hz filter rounds the corners at 2 s and 6 s: at most 0.3 mm of each reaches into the stage.
    QVERIFY(isNear(valueOf(canalSession(trial), "inspection_travel"), circle_mm, 0.6));
    QVERIFY(isNear(valueOf(canalSession(trial), "path_length"), circle_mm + 80.0, 0.6));
    auto noise = trial;
    for (std::size_t i = 0; i < noise.tools[0].t_s.size();
         ++i) // one count of 25 µm up and down each ms is no travel
        noise.tools[0].p_WT_m[i].y() += i % 2 == 0 ? 25e-6 : 0.0;
    QVERIFY(isNear(valueOf(canalSession(noise), "inspection_travel"), circle_mm, 1.0));
}

void TestInsertionGoals::depthStopsAtTheGoal() {
    auto trial = canalTrial(1.0, 0.001, [](double t) { return CanalSample{0.1 * t}; });
    QCOMPARE(valueOf(canalSession(trial), "insertion_depth"), 80.0);
    insertionIn(trial).goal_m = 0.0353; // exactly the goal, so that a gate there holds
    QCOMPARE(valueOf(canalSession(trial), "insertion_depth"), 35.3);
    const auto shallow =
        canalTrial(1.0, 0.001, [](double t) { return CanalSample{0.06 * std::sin(kPi * t)}; });
    QCOMPARE(valueOf(canalSession(shallow), "insertion_depth"), 60.0); // the deepest place, not the last
    const auto outside = canalTrial(1.0, 0.001, [](double t) { return CanalSample{-0.02 * t}; });
    QCOMPARE(valueOf(canalSession(outside), "insertion_depth"), 0.0);
    QCOMPARE(valueOf(canalSession({shallow, outside}), "insertion_depth"), 30.0);
}

// In to 30 mm on the line, then on to 70 mm beside it: 10 mm aside is still in the canal, more is not.
void TestInsertionGoals::depthIsInTheCanal() {
    const auto beside = [](double offset_m) {
        return canalTrial(1.0, 0.001, [offset_m](double t) {
            return CanalSample{0.07 * t, t > 0.4286 ? offset_m : 0.0};
        });
    };
    QCOMPARE(valueOf(canalSession(beside(0.010)), "insertion_depth"), 70.0);
    QVERIFY(isNear(valueOf(canalSession(beside(0.0101)), "insertion_depth"), 30.0, 0.08));
}

QTEST_APPLESS_MAIN(TestInsertionGoals)
#include "test_insertion_goals.moc"
