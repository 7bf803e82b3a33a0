// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/scope_marks.h"
#include "core/random.h"
#include "gui/scene3d/urethra_samples.h"
#include "gui/training/posed_endoscope.h"
#include "modules/exercises/urethra_insertion/simulation/lumen_sight.h"

#include <QtTest>
#include <array>

using namespace chiron;
using namespace chiron::desktop;
using core::Vec3;
using tests::Posed;
using tests::posedAt;

namespace {

simulation::UrethraInsertionParameters rotatedScene() {
    simulation::UrethraInsertionParameters p;
    p.pose.p_WA = Vec3(0.1, -0.2, 0.05);
    p.pose.q_WA = core::Quat(0.4, -0.3, 0.7, 0.2).normalized();
    return p;
}

} // namespace

class TestInsertionValues : public QObject {
    Q_OBJECT
private slots:
    void aPerfectPoseReadsZero();
    void distanceAndAngle();
    void alongAndAcross();
    void torquesAreP1s();
    void theSceneMayStandAnywhere();
    void theRingAsksForWhatIsMeasured();
};

void TestInsertionValues::aPerfectPoseReadsZero() {
    const simulation::UrethraInsertionParameters p;
    const InsertionGauge gauge(p);
    for (const double s_m : {-0.02, 0.0, 0.02, 0.06, 0.12}) {
        const Posed posed = posedAt(p, s_m);
        const InsertionValues v = gauge.at(posed.p_W, posed.q_WT, {});
        QVERIFY(std::abs(v.depth_m - s_m) < 1e-9);
        QVERIFY(v.offset_m < 1e-9);
        QVERIFY(v.alignment_rad < 1e-7);
        QCOMPARE(v.resistance_N, 0.0);
    }
    QVERIFY(std::abs(gauge.goal_m() - gauge.length_m() - 0.010) < 1e-12);
    simulation::UrethraInsertionParameters shallow;
    shallow.goalDepth_m = 0.035;
    QCOMPARE(InsertionGauge(shallow).goal_m(), 0.035);
}

void TestInsertionValues::distanceAndAngle() {
    const simulation::UrethraInsertionParameters p;
    const simulation::CentrelinePoint at = simulation::UrethraCentreline(p.anatomy).at(0.05);
    const Posed posed = posedAt(p, 0.05, 0.002 * Vec3::UnitX() + 0.001 * at.n_A, 0.2, 0.0);
    const InsertionValues v = InsertionGauge(p).at(posed.p_W, posed.q_WT, {});
    QVERIFY(std::abs(v.offset_m - std::sqrt(5.0) * 1e-3) < 1e-9);
    QVERIFY(std::abs(v.depth_m - 0.05) < 1e-9); // beside the line, not farther along it
    QVERIFY(std::abs(v.alignment_rad - 0.2) < 1e-9);
    QVERIFY((v.tip_A_m - (at.p_A + 0.002 * Vec3::UnitX() + 0.001 * at.n_A)).norm() < 1e-12);
}

void TestInsertionValues::alongAndAcross() {
    const simulation::UrethraInsertionParameters p;
    const simulation::CentrelinePoint at = simulation::UrethraCentreline(p.anatomy).at(0.08);
    const Posed posed = posedAt(p, 0.08);
    const Vec3 force_A = -2.0 * at.t_A + 1.5 * at.n_A - 2.0 * Vec3::UnitX();
    const InsertionValues v =
        InsertionGauge(p).at(posed.p_W, posed.q_WT, {p.pose.vectorToW(force_A), Vec3::Zero()});
    QVERIFY(std::abs(v.resistance_N - 2.0) < 1e-9); // pushes out: above zero
    QVERIFY(std::abs(v.lateral_N - 2.5) < 1e-9);
    QVERIFY((v.force_A_N - force_A).norm() < 1e-12);
}

/// The torque of P1's three put together as a wrench (models.md §1.2) and taken apart again.
void TestInsertionValues::torquesAreP1s() {
    const simulation::UrethraInsertionParameters p;
    const InsertionGauge gauge(p);
    core::Random random(11);
    for (int n = 0; n < 200; ++n) {
        const double tiltY = 1.0 * (random.uniform() - 0.5);
        const Posed posed =
            posedAt(p, 0.02 + 0.1 * random.uniform(), Vec3::Zero(), random.uniform() - 0.5, tiltY);
        const Vec3 t_Nm(0.15 * (random.uniform() - 0.5), 0.15 * (random.uniform() - 0.5),
                        0.01 * (random.uniform() - 0.5));
        const Vec3 z_A = (posed.axis_A - std::sin(tiltY) * Vec3::UnitX()) / std::cos(tiltY); // z″
        const Vec3 torque_A = t_Nm.x() * Vec3::UnitX() + t_Nm.y() * posed.y_A -
                              t_Nm.x() * std::tan(tiltY) * z_A + t_Nm.z() * posed.axis_A;
        const InsertionValues v = gauge.at(posed.p_W, posed.q_WT, {Vec3::Zero(), p.pose.vectorToW(torque_A)});
        QVERIFY((v.torque_Nm - t_Nm).norm() < 1e-9);
    }
}

void TestInsertionValues::theSceneMayStandAnywhere() {
    const simulation::UrethraInsertionParameters here;
    const simulation::UrethraInsertionParameters there = rotatedScene();
    const Vec3 off(0.001, -0.002, 0.0005);
    const Vec3 force_A(0.3, -0.6, -1.1);
    const Vec3 torque_A(0.02, -0.03, 0.004);
    std::array<InsertionValues, 2> values;
    for (const auto* p : {&here, &there}) {
        const Posed posed = posedAt(*p, 0.07, off, 0.1, -0.2);
        values[p == &there] = InsertionGauge(*p).at(
            posed.p_W, posed.q_WT, {p->pose.vectorToW(force_A), p->pose.vectorToW(torque_A)});
    }
    QVERIFY((values[0].tip_A_m - values[1].tip_A_m).norm() < 1e-12);
    QVERIFY((values[0].force_A_N - values[1].force_A_N).norm() < 1e-12);
    QVERIFY((values[0].torque_Nm - values[1].torque_Nm).norm() < 1e-9);
    QVERIFY(std::abs(values[0].alignment_rad - values[1].alignment_rad) < 1e-9);
    QVERIFY(std::abs(values[0].offset_m - values[1].offset_m) < 1e-12);
}

namespace {

/// The pose as the scene hands it on, with the lumen as far ahead as it can be seen.
scene3d::SceneState seenFrom(const scene3d::SceneSetup& setup, const scene3d::samples::ScopePose& pose) {
    const auto& p = setup.parameters.as<simulation::UrethraInsertionParameters>();
    scene3d::SceneState state = scene3d::samples::urethraState(setup, pose);
    const simulation::UrethraCentreline line(p.anatomy);
    const Vec3 p_A = p.pose.pointToA(state.tool[0].p_WT);
    const Vec3 axis_A = p.pose.vectorToA(state.tool[0].q_WT * Vec3(0.0, 0.0, -1.0));
    const simulation::LumenSight::View view = simulation::LumenSight(p).look(p_A, axis_A, line.foot(p_A));
    const Vec3 to_T =
        view.open ? Vec3(state.tool[0].q_WT.conjugate() * p.pose.vectorToW((view.p_A - p_A).normalized()))
                  : Vec3(Vec3::Zero());
    state.exercise.own<simulation::EndoscopeCues>().toLumen_T = {to_T.x(), to_T.y(), to_T.z()};
    return state;
}

} // namespace

/// Along the whole canal, the bend included, on its centre-line and beside it: the ring is double where the
/// measured alignment is small, and only there; and the way from the mark to the ring is the turn that is
/// left.
void TestInsertionValues::theRingAsksForWhatIsMeasured() {
    const scene3d::SceneSetup setup = scene3d::samples::urethraSetup();
    const auto& p = setup.parameters.as<simulation::UrethraInsertionParameters>();
    const scene3d::UrethraDrawing drawing(p);
    const InsertionGauge gauge(p);
    constexpr double kDouble_deg = 2.5,
                     kSingle_deg =
                         4.0; // what lies between may be either: the picture's scale grows towards its edge
    int looked = 0;
    double mostAside = 0.0;
    for (double s_m = -0.02; s_m < gauge.length_m(); s_m += 0.0025)
        for (const double off_m : {0.0, 0.002, -0.002})
            for (const double turn_deg : {0.0, 2.0, 6.0, -6.0, 10.0, -10.0}) {
                const scene3d::SceneState state = seenFrom(setup, {.s_m = s_m,
                                                                   .ex_m = off_m,
                                                                   .en_m = 0.5 * off_m,
                                                                   .pitch_rad = core::radFromDeg(turn_deg)});
                const scene3d::ScopeMarks marks = scene3d::ScopeMarks::of(setup, drawing, state);
                if (!marks.guided || marks.beyond)
                    continue; // an arrow at the rim, or wall alone
                ++looked;
                const double alignment_deg =
                    core::degFromRad(gauge.at(state.tool[0].p_WT, state.tool[0].q_WT, {}).alignment_rad);
                const QString at = QStringLiteral("s %1 mm, %2 mm aside, turned by %3: %4")
                                       .arg(s_m * 1e3)
                                       .arg(off_m * 1e3)
                                       .arg(turn_deg)
                                       .arg(alignment_deg);
                QVERIFY2(alignment_deg > kDouble_deg || marks.aligned, qPrintable(at));
                QVERIFY2(alignment_deg < kSingle_deg || !marks.aligned, qPrintable(at));
                QVERIFY2(turn_deg == 0.0 || (marks.lumen - marks.target).y() * turn_deg < 0.0,
                         qPrintable(at)); // turned too far up: the ring lies below
                mostAside = std::max(mostAside, turn_deg == 0.0 && off_m == 0.0 ? marks.target.norm() : 0.0);
            }
    QVERIFY(looked > 500);
    QVERIFY2(mostAside > 0.2, qPrintable(QString::number(
                                  mostAside))); // in the bend an aligned endoscope does see the lumen aside
}

QTEST_APPLESS_MAIN(TestInsertionValues)
#include "test_insertion_values.moc"
