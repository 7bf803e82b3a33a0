// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session/insertion_series.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "support/urethra_bench.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;
using simulation::ProcedureStage;
using simulation::UrethraInsertionParameters;

namespace {

/// A trial with its samples at these arc lengths, 1 ms apart, on the centre-line and aligned.
scoring::TrialTrace along(const UrethraInsertionParameters& p, const std::vector<double>& s_m) {
    scoring::TrialTrace trial;
    trial.tools.resize(1);
    scoring::ToolTrace& tool = trial.tools[0];
    for (std::size_t i = 0; i < s_m.size(); ++i) {
        const core::ToolState pose = tests::onTheLine(p, s_m[i]);
        tool.t_s.push_back(1e-3 * static_cast<double>(i));
        tool.p_WT_m.push_back(pose.p_WT);
        tool.q_WT.push_back(pose.q_WT);
        tool.tissue_N.emplace_back(Vec3::Zero());
        tool.tissueTorque_Nm.emplace_back(Vec3::Zero());
        tool.paused.push_back(0);
    }
    return trial;
}

std::vector<double> held(double s_m, std::size_t samples) {
    return std::vector<double>(samples, s_m);
}

} // namespace

class TestInsertionSeries : public QObject {
    Q_OBJECT
private slots:
    void nothingWithoutOrientation();
    void placeAndAlignment();
    void forceIsSplitAtTheTangent();
    void frictionOnATiltedShaftLiesPartlyAcross();
    void torqueIsTakenAboutTheAxis();
    void pausedSamplesMoveNothing();
    void landmarksGetTheirTimes();
    void ticksCountNotTheDevicesClock();
    void ticksOfASlowDevice();
    void levelsNumbersGoAlong();
    void besideTheCanalNothingAdvances();
};

void TestInsertionSeries::nothingWithoutOrientation() {
    const UrethraInsertionParameters p = tests::wholeProcedure();
    scoring::TrialTrace trial = along(p, {0.01, 0.02});
    QVERIFY(session::insertionSeries(p, trial).has_value());
    trial.tools[0].q_WT.clear();
    QVERIFY(!session::insertionSeries(p, trial).has_value());
    trial.tools.clear();
    QVERIFY(!session::insertionSeries(p, trial).has_value());
}

void TestInsertionSeries::placeAndAlignment() {
    UrethraInsertionParameters p = tests::wholeProcedure();
    p.pose.p_WA = Vec3(0.03, -0.01, 0.02);
    p.pose.q_WA = core::Quat(Eigen::AngleAxisd(0.4, Vec3::UnitZ())) * p.pose.q_WA;
    scoring::TrialTrace trial = along(p, {-0.02, 0.05, 0.10});
    const simulation::UrethraCentreline line(p.anatomy);
    const simulation::CentrelinePoint at = line.at(0.10);
    const double tilt = 0.3;
    const core::ToolState aside = tests::endoscopeAt(p.pose, at.p_A + 0.003 * Vec3::UnitX() - 0.004 * at.n_A,
                                                     std::cos(tilt) * at.t_A + std::sin(tilt) * at.n_A);
    trial.tools[0].p_WT_m[2] = aside.p_WT;
    trial.tools[0].q_WT[2] = aside.q_WT;
    const auto series = *session::insertionSeries(p, trial);
    QVERIFY(std::abs(series.s_m[0] + 0.02) < 1e-9 && std::abs(series.s_m[1] - 0.05) < 1e-9 &&
            std::abs(series.s_m[2] - 0.10) < 1e-9);
    QVERIFY(series.offset_m[1] < 1e-9 && std::abs(series.offset_m[2] - 0.005) < 1e-9);
    QVERIFY(series.alignment_rad[1] < 1e-7 && std::abs(series.alignment_rad[2] - tilt) < 1e-7);
}

void TestInsertionSeries::forceIsSplitAtTheTangent() {
    const UrethraInsertionParameters p = tests::wholeProcedure();
    scoring::TrialTrace trial = along(p, {0.06, 0.06});
    const simulation::UrethraCentreline line(p.anatomy);
    const simulation::CentrelinePoint at = line.at(0.06);
    trial.tools[0].tissue_N[1] = p.pose.vectorToW(-2.0 * at.t_A + 0.3 * at.n_A + 0.4 * Vec3::UnitX());
    const auto series = *session::insertionSeries(p, trial);
    QCOMPARE(series.lateral_N[0], 0.0);
    QVERIFY(std::abs(series.lateral_N[1] - 0.5) < 1e-9);
}

// Lateral is all that lies across the canal: of friction along a shaft tilted by 0.3 rad its sine.
void TestInsertionSeries::frictionOnATiltedShaftLiesPartlyAcross() {
    const UrethraInsertionParameters p = tests::wholeProcedure();
    scoring::TrialTrace trial = along(p, {0.06});
    const simulation::UrethraCentreline line(p.anatomy);
    const simulation::CentrelinePoint at = line.at(0.06);
    const Vec3 axis_A = std::cos(0.3) * at.t_A + std::sin(0.3) * at.n_A;
    trial.tools[0].q_WT[0] = tests::endoscopeAt(p.pose, at.p_A, axis_A).q_WT;
    trial.tools[0].tissue_N[0] = p.pose.vectorToW(-0.8 * axis_A);
    QVERIFY(std::abs(session::insertionSeries(p, trial)->lateral_N[0] - 0.8 * std::sin(0.3)) < 1e-9);
}

void TestInsertionSeries::torqueIsTakenAboutTheAxis() {
    const UrethraInsertionParameters p = tests::wholeProcedure();
    scoring::TrialTrace trial = along(p, {0.06, 0.06});
    const simulation::UrethraCentreline line(p.anatomy);
    const simulation::CentrelinePoint at = line.at(0.06);
    trial.tools[0].tissueTorque_Nm[1] = p.pose.vectorToW(-0.004 * at.t_A + 0.1 * at.n_A);
    const auto series = *session::insertionSeries(p, trial);
    QCOMPARE(series.axialTorque_Nm[0], 0.0);
    QVERIFY(std::abs(series.axialTorque_Nm[1] - 0.004) < 1e-9);
}

// A pause is no time: the tip is held for a landmark before and after it, and what it did in between is
// nobody's business.
void TestInsertionSeries::pausedSamplesMoveNothing() {
    UrethraInsertionParameters p = tests::wholeProcedure();
    p.landmarks = {{"ahead", 0.0, 0.0}};
    std::vector<double> s_m = held(0.155, 200);
    const std::vector<double> away = held(-0.05, 500);
    s_m.insert(s_m.end(), away.begin(), away.end());
    const std::vector<double> back = held(0.155, 250);
    s_m.insert(s_m.end(), back.begin(), back.end());
    scoring::TrialTrace trial = along(p, s_m);
    for (std::size_t i = 200; i < 700; ++i)
        trial.tools[0].paused[i] = 1;
    const auto series = *session::insertionSeries(p, trial);
    QCOMPARE(series.stage[699], static_cast<std::uint8_t>(ProcedureStage::inspection));
    QCOMPARE(series.stage.back(), static_cast<std::uint8_t>(ProcedureStage::withdrawal));
    // 199 ms before the pause and 101 ms after it make the 0.3 s.
    QVERIFY2(std::abs(series.landmarkSeen_s[0] - 0.800) < 1e-9,
             qPrintable(QString::number(series.landmarkSeen_s[0], 'g', 12)));
}

void TestInsertionSeries::landmarksGetTheirTimes() {
    UrethraInsertionParameters p = tests::wholeProcedure();
    p.landmarks = {{"behind", 2.5, 0.0}, {"ahead", 0.0, 0.0}};
    const auto series = *session::insertionSeries(p, along(p, held(0.155, 400)));
    QVERIFY(std::isnan(series.landmarkSeen_s[0]));
    QVERIFY(std::abs(series.landmarkSeen_s[1] - 0.300) < 1e-9);
}

// Level ends at its last landmark, on a device whose clock runs 0.03 % slow: after 300 ticks it has counted
// 299.9 ms.
void TestInsertionSeries::ticksCountNotTheDevicesClock() {
    UrethraInsertionParameters p = tests::wholeProcedure();
    p.landmarks = {{"ahead", 0.0, 0.0}};
    p.withdraws = false;
    for (const double clock : {0.9997, 1.0, 1.0003, 0.5}) {
        simulation::UrethraInsertionScene scene(p); // what live says
        realtime::TickSource source;
        simulation::SceneInput in;
        simulation::SceneOutput out;
        in.tools.count = 1;
        in.tools.tools[0] = tests::onTheLine(p, 0.155);
        in.started = in.forceReady = true;
        std::size_t samples = 0;
        while ((out.events & core::event_bits::kCompleted) == 0 && samples < 2000) {
            scene.respond(source.next(0), in, out);
            samples += out.phase == core::TrialPhase::running;
        }
        QVERIFY((out.events & simulation::procedure_bits::kLandmarkSeen) != 0);
        scoring::TrialTrace trial = along(p, held(0.155, samples));
        for (double& t_s : trial.tools[0].t_s)
            t_s *= clock;
        trial.tools[0].heldTicks.assign(samples, 1);
        const auto series = *session::insertionSeries(p, trial);
        QCOMPARE(series.landmarkSeen_s[0], trial.tools[0].t_s.back());
        QCOMPARE(series.stage.back(), static_cast<std::uint8_t>(ProcedureStage::completed));
        QVERIFY(series.stage[samples - 2] != series.stage.back()); // nor a tick earlier
    }
}

// Packets of 8 ms: seen amid one, it is seen at the sample that was held; ticks without any are no time.
void TestInsertionSeries::ticksOfASlowDevice() {
    UrethraInsertionParameters p = tests::wholeProcedure();
    p.landmarks = {{"ahead", 0.0, 0.0}};
    p.withdraws = false;
    scoring::TrialTrace trial = along(p, held(0.155, 38));
    for (std::size_t i = 0; i < 38; ++i)
        trial.tools[0].t_s[i] = 0.0081 * static_cast<double>(i);
    trial.tools[0].heldTicks.assign(38, 8);
    trial.tools[0].heldTicks.back() = 5; // 1 that begins, 300 that count
    auto series = *session::insertionSeries(p, trial);
    QCOMPARE(series.landmarkSeen_s[0], trial.tools[0].t_s.back());
    trial.tools[0].heldTicks[7] = 0; // paused
    series = *session::insertionSeries(p, trial);
    QVERIFY(std::isnan(series.landmarkSeen_s[0]));
}

void TestInsertionSeries::levelsNumbersGoAlong() {
    UrethraInsertionParameters p = tests::wholeProcedure();
    p.lateralLimit_N = 1.5;
    p.goalDepth_m = 0.145;
    const auto series = *session::insertionSeries(p, along(p, {0.0}));
    const simulation::UrethraCentreline line(p.anatomy);
    QCOMPARE(series.length_m, line.length_m());
    p.anatomy.straight_m = 0.0; // content from before the straight part: the bend is where the free part ends
    QCOMPARE(session::insertionSeries(p, along(p, {0.0}))->bend_m, p.anatomy.freeLength_m);
    p.anatomy.straight_m = 0.030;
    QCOMPARE(session::insertionSeries(p, along(p, {0.0}))->bend_m, 0.030);
    QCOMPARE(series.goal_m, 0.145);
    QCOMPARE(series.lateralLimit_N, 1.5);
}

// The same movements, 30 mm to the side: the stored series says outside, as the scene does, and nothing was
// inserted.
void TestInsertionSeries::besideTheCanalNothingAdvances() {
    const UrethraInsertionParameters p = tests::wholeProcedure();
    std::vector<double> way;
    for (int mm = -20; mm <= 150; ++mm)
        way.push_back(1e-3 * mm);
    scoring::TrialTrace trial = along(p, way);
    QCOMPARE(session::insertionSeries(p, trial)->stage.back(),
             static_cast<std::uint8_t>(ProcedureStage::inspection));
    for (Vec3& place : trial.tools[0].p_WT_m)
        place += p.pose.vectorToW(0.030 * Vec3::UnitX());
    const auto series = *session::insertionSeries(p, trial);
    QVERIFY(series.s_m.back() > 0.149 && std::abs(series.offset_m.back() - 0.030) < 1e-9);
    QCOMPARE(series.stage.back(), static_cast<std::uint8_t>(ProcedureStage::outside));
}

QTEST_APPLESS_MAIN(TestInsertionSeries)
#include "test_insertion_series.moc"
