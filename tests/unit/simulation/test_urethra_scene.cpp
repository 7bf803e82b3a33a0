// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/units.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "urethra_driver.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using chiron::tests::endoscopeAt;
using chiron::tests::IdealProcedure;
using chiron::tests::wholeProcedure;
using core::TrialPhase;
using core::Vec3;
using simulation::ProcedureStage;
using Driver = UrethraDriver;
namespace bits = core::event_bits;

class TestUrethraScene : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void waitsForStartAndForce();
    void idealPathWalksThroughTheStages();
    void timesOutAtItsTick();
    void completionAtTheLastTickWins();
    void pauseStopsClockAndProcedure();
    void nothingIsTouchedAfterTheEnd();
    void contactBeginsWithTheBeak();
    void theGateIsPassedThroughTheMeatus();
    void aPoseSeenFirstIsInWithinReach();
    void withoutAMeatusEverythingIsCanal();
    void besideTheCanalNothingIsFelt();
    void entersAndLeavesThroughTheMeatus();
    void rotatedSceneIsTheSame();
    void mirroredSceneIsMirrored();
    void poseThatIsNoNumberIsPassedOver();
    void otherToolsTouchNothing();
    void sameInputsSameOutputs();
};

void TestUrethraScene::waitsForStartAndForce() {
    Driver d(wholeProcedure());
    d.in.forceReady = true;
    d.at(0.060, 50);
    QCOMPARE(d.out.phase, TrialPhase::idle);
    QCOMPARE(norm(d.out.tissue.tools[0]), 0.0); // no patient before the start
    QVERIFY(d.out.cues.exercise.of<simulation::EndoscopeCues>().present &&
            !d.out.cues.exercise.of<simulation::EndoscopeCues>().pictureShown);
    d.in.started = true;
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QCOMPARE(d.out.events, bits::kSceneChanged | bits::kContactBegan);
    d.in.forceReady = false;
    d.at(0.060, 5000); // waiting costs nothing
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QCOMPARE(d.out.cues.timeLeft_s, 120.0);
    QVERIFY(d.out.storedEnergy_J > 0.0); // the canal is squeezed: the supervisor sees it
    QCOMPARE(d.out.cues.exercise.of<simulation::EndoscopeCues>().stage, ProcedureStage::outside);
    d.in.forceReady = true;
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::running);
    QCOMPARE(d.out.events, bits::kTrialStarted | bits::kStageChanged);
}

void TestUrethraScene::idealPathWalksThroughTheStages() {
    Driver d(wholeProcedure());
    d.startRunning();
    IdealProcedure hand(d.p);
    std::vector<ProcedureStage> stages{d.out.cues.exercise.of<simulation::EndoscopeCues>().stage};
    int seen = 0;
    int changed = 0;
    double deepest_m = 0.0;
    while ((d.out.events & (bits::kCompleted | bits::kTimedOut)) == 0) {
        QVERIFY(d.source.executed() < 60'000);
        d.tool() = hand.next(d.out.cues.exercise.of<simulation::EndoscopeCues>().stage,
                             d.scene.procedure().nextLandmark());
        d.tick();
        if ((d.out.events & bits::kStageChanged) != 0) {
            ++changed;
            stages.push_back(d.out.cues.exercise.of<simulation::EndoscopeCues>().stage);
        }
        seen += (d.out.events & simulation::procedure_bits::kLandmarkSeen) != 0;
        deepest_m = std::max(deepest_m, d.out.cues.exercise.of<simulation::EndoscopeCues>().depth_m);
        QCOMPARE(d.out.phase, TrialPhase::running);
    }
    QVERIFY((d.out.events & bits::kCompleted) != 0);
    QCOMPARE(changed, 4);
    QVERIFY(
        (stages == std::vector{ProcedureStage::outside, ProcedureStage::insertion, ProcedureStage::inspection,
                               ProcedureStage::withdrawal, ProcedureStage::completed}));
    QCOMPARE(seen, 2);
    QCOMPARE(d.out.cues.exercise.of<simulation::EndoscopeCues>().landmarksSeen, 3u);
    QVERIFY(std::abs(deepest_m - procedurePlan(d.p).goal_m) < 1e-4);
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::finished);
    QCOMPARE(d.out.events & bits::kFinished, bits::kFinished);
}

void TestUrethraScene::timesOutAtItsTick() {
    UrethraInsertionParameters p = wholeProcedure();
    p.trialLimit_s = 0.050;
    Driver d(p);
    d.startRunning(); // the first running tick is done
    for (int n = 2; n < 50; ++n) {
        d.tick();
        QCOMPARE(d.out.events, 0u);
        QVERIFY(std::abs(d.out.cues.timeLeft_s - (50 - n) * 0.001) < 1e-12);
    }
    d.tick();
    QCOMPARE(d.out.events, bits::kTimedOut);
    QCOMPARE(d.out.phase, TrialPhase::running);
    d.tick();
    QCOMPARE(d.out.events, bits::kFinished);
}

void TestUrethraScene::completionAtTheLastTickWins() {
    UrethraInsertionParameters p = wholeProcedure();
    p.landmarks.clear();
    p.withdraws = false;
    p.goalDepth_m = 0.030;
    p.trialLimit_s = 0.050;
    Driver d(p);
    d.startRunning();
    d.ticks(48);
    d.at(0.031);
    QCOMPARE(d.out.events & (bits::kCompleted | bits::kTimedOut), bits::kCompleted);
}

void TestUrethraScene::pauseStopsClockAndProcedure() {
    UrethraInsertionParameters p = wholeProcedure();
    p.trialLimit_s = 0.500;
    Driver d(p);
    d.startRunning();
    d.at(0.060, 98); // 99 ticks of the trial
    d.in.paused = true;
    d.at(0.155, 1000);
    QCOMPARE(d.out.cues.exercise.of<simulation::EndoscopeCues>().stage,
             ProcedureStage::insertion); // moved while paused: no progress
    QVERIFY(std::abs(d.out.cues.timeLeft_s - 0.401) < 1e-12);
    QVERIFY(d.out.storedEnergy_J > 0.0); // contact answers; the supervisor ramps
    QCOMPARE(d.out.events, 0u);
    d.in.paused = false;
    d.at(0.060, 400);
    QCOMPARE(d.out.events, 0u);
    d.tick();
    QCOMPARE(d.out.events, bits::kTimedOut);
}

void TestUrethraScene::nothingIsTouchedAfterTheEnd() {
    UrethraInsertionParameters p = wholeProcedure();
    p.trialLimit_s = 0.050;
    Driver d(p);
    d.startRunning();
    d.at(0.060, 49);
    QCOMPARE(d.out.events & bits::kTimedOut, bits::kTimedOut);
    QVERIFY(d.out.storedEnergy_J > 0.0); // the last tick belongs to the trial
    d.tick();
    QCOMPARE(d.out.events, bits::kFinished | bits::kContactEnded);
    QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
    QCOMPARE(d.out.storedEnergy_J, 0.0);
    QVERIFY(!d.out.cues.exercise.of<simulation::EndoscopeCues>().pictureShown);
}

void TestUrethraScene::contactBeginsWithTheBeak() {
    Driver d(wholeProcedure());
    d.startRunning();
    QCOMPARE(norm(d.at(-0.0101).tissue.tools[0]), 0.0);
    QCOMPARE(d.out.events, 0u);
    d.at(-0.0099);
    QCOMPARE(d.out.events, bits::kContactBegan | bits::kStageChanged);
    d.at(-0.0101);
    QCOMPARE(d.out.events, bits::kContactEnded);
}

void TestUrethraScene::theGateIsPassedThroughTheMeatus() {
    constexpr double radius_m = 0.005, beak_m = 0.010;
    MeatusGate gate(radius_m, beak_m);
    QVERIFY(!gate.step(-0.030, 0.0));
    QVERIFY(!gate.step(-beak_m, 0.0));
    QVERIFY(gate.step(-0.0099, 0.0049));
    QVERIFY(gate.step(0.050, 0.020)); // however far off: it came in and has not left
    QVERIFY(gate.inside());
    QVERIFY(!gate.step(-beak_m, 0.0051)); // out
    QVERIFY(!gate.step(-0.0099, 0.0051));
    QVERIFY(!gate.step(0.050, 0.0)); // beside the canal, and not in by the way across
    QVERIFY(!gate.step(-0.0099, 0.0));
    // Where it passed is between two positions.
    QVERIFY(!gate.step(-0.012, 0.003));
    QVERIFY(gate.step(-0.008, 0.0069)); // at 4.95 mm
    QVERIFY(!gate.step(-0.012, 0.003));
    QVERIFY(!gate.step(-0.008, 0.0071)); // at 5.05 mm
}

void TestUrethraScene::aPoseSeenFirstIsInWithinReach() {
    MeatusGate gate(0.005, 0.010);
    QVERIFY(gate.step(0.050, kCanalReach_m));
    gate.forget();
    QVERIFY(!gate.step(0.050, 1.01 * kCanalReach_m));
    QVERIFY(!gate.step(0.050, 0.0)); // no longer the first
    gate.forget();
    QVERIFY(!gate.step(-0.010, 0.0));
}

void TestUrethraScene::withoutAMeatusEverythingIsCanal() {
    MeatusGate gate(0.0, 0.010);
    QVERIFY(gate.step(-0.030, 1.0));
    QVERIFY(gate.step(0.050, 1.0));
}

void TestUrethraScene::besideTheCanalNothingIsFelt() {
    UrethraInsertionParameters p = wholeProcedure();
    p.meatus_m = 0.005;
    Driver d(p);
    UrethraInsertionParameters open = p;
    open.meatus_m = 0.0;
    Driver all(open);
    d.startRunning();
    all.startRunning();
    const UrethraCentreline line(p.anatomy);
    double most = 0.0;
    for (int n = 0; n <= 240; ++n) { // 30 mm before the entrance to 90 mm behind it
        const CentrelinePoint at = line.at(-0.030 + 0.0005 * n);
        for (Driver* each : {&d, &all}) {
            each->tool() = endoscopeAt(p.pose, at.p_A + 0.007 * Vec3::UnitX(), at.t_A);
            each->tick();
        }
        QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
        QCOMPARE(d.out.storedEnergy_J, 0.0);
        QCOMPARE(int(d.out.contact[0]), 0);
        QCOMPARE(d.out.events & bits::kContactBegan, 0u);
        most = std::max(most, norm(all.out.tissue.tools[0]));
    }
    QVERIFY(most > 1.0); // the wall is there
    // Nor once it is moved across, onto the centre-line.
    d.at(0.060, 5);
    all.at(0.060, 5);
    QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
    QCOMPARE(d.out.storedEnergy_J, 0.0);
    QVERIFY(all.out.storedEnergy_J > 0.0);
}

void TestUrethraScene::entersAndLeavesThroughTheMeatus() {
    UrethraInsertionParameters p = wholeProcedure();
    p.meatus_m = 0.005;
    Driver d(p);
    d.startRunning();
    const UrethraCentreline line(p.anatomy);
    const auto to = [&](double s_m, double offset_m) {
        const CentrelinePoint at = line.at(s_m);
        d.tool() = endoscopeAt(p.pose, at.p_A + offset_m * Vec3::UnitX(), at.t_A);
        d.tick();
    };
    for (int again = 0; again < 2; ++again) {
        to(-0.030, 0.004);
        to(-0.0101, 0.004);
        QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
        to(-0.0099, 0.004);
        QVERIFY((d.out.events & bits::kContactBegan) != 0);
        to(0.060, 0.004);
        QVERIFY(norm(d.out.tissue.tools[0]) > 0.1 && d.out.storedEnergy_J > 0.0);
        to(0.060, 0.007); // as far off as beside it
        QVERIFY(norm(d.out.tissue.tools[0]) > 0.1);
        to(-0.0101, 0.0);
        QCOMPARE(d.out.events & bits::kContactEnded, bits::kContactEnded);
        QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
        to(-0.0101, 0.007);
        to(0.060, 0.007);
        QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
    }
}

// Rotating and moving the whole scene changes nothing but the frame.
void TestUrethraScene::rotatedSceneIsTheSame() {
    const UrethraInsertionParameters p = wholeProcedure();
    UrethraInsertionParameters turned = p;
    turned.pose.q_WA = core::Quat(Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized())) * p.pose.q_WA;
    turned.pose.p_WA = Vec3(0.02, 0.03, -0.04);
    Driver a(p);
    Driver b(turned);
    a.startRunning();
    b.startRunning();
    int otherChoice = 0;
    for (int n = 0; n < 2000; ++n) {
        const double s = -0.015 + 0.0001 * n;
        const UrethraCentreline line(p.anatomy);
        const CentrelinePoint at = line.at(s);
        const Vec3 p_A =
            at.p_A + 0.002 * std::sin(0.01 * n) * Vec3::UnitX() + 0.0015 * std::cos(0.013 * n) * at.n_A;
        const Vec3 axis_A =
            at.t_A + 0.2 * std::sin(0.007 * n) * Vec3::UnitX() + 0.1 * std::cos(0.009 * n) * at.n_A;
        for (Driver* d : {&a, &b}) {
            d->tool() = endoscopeAt(d->p.pose, p_A, axis_A);
            d->tool().v_WT = d->p.pose.vectorToW(Vec3(0.002, -0.001, 0.03));
            d->tool().w_WT = d->p.pose.vectorToW(Vec3(0.1, 0.2, 0.5));
            d->tick();
        }
        const Vec3 f_A = a.p.pose.vectorToA(a.out.tissue.tools[0].force);
        const Vec3 f_B = b.p.pose.vectorToA(b.out.tissue.tools[0].force);
        const Vec3 t_A = a.p.pose.vectorToA(a.out.tissue.tools[0].torque);
        const Vec3 t_B = b.p.pose.vectorToA(b.out.tissue.tools[0].torque);
        QVERIFY((f_A - f_B).norm() < 1e-9 && (t_A - t_B).norm() < 1e-11);
        QCOMPARE(a.out.events, b.out.events);
        // Which point of the lumen is the farthest is a choice between points: now and then rounding makes
        // another one.
        otherChoice += (vectorOf(a.out.cues.exercise.of<simulation::EndoscopeCues>().toLumen_T) -
                        vectorOf(b.out.cues.exercise.of<simulation::EndoscopeCues>().toLumen_T))
                           .norm() > 1e-9;
    }
    QVERIFY2(otherChoice < 40, qPrintable(QString::number(otherChoice)));
    QVERIFY(a.out.cues.exercise.of<simulation::EndoscopeCues>().depth_m > 0.15);
}

// Left and right are alike: a pose mirrored in the plane of symmetry gives the mirrored wrench.
void TestUrethraScene::mirroredSceneIsMirrored() {
    const UrethraInsertionParameters p = wholeProcedure();
    Driver left(p);
    Driver right(p);
    left.startRunning();
    right.startRunning();
    const UrethraCentreline line(p.anatomy);
    const Vec3 mirror(-1.0, 1.0, 1.0);
    double largest_N = 0.0;
    for (int n = 0; n < 1500; ++n) {
        const CentrelinePoint at = line.at(-0.010 + 0.0001 * n);
        const Vec3 p_A = at.p_A + 0.002 * Vec3::UnitX() + 0.001 * at.n_A;
        const Vec3 axis_A = at.t_A + 0.2 * Vec3::UnitX() - 0.1 * at.n_A;
        left.tool() = endoscopeAt(p.pose, p_A, axis_A);
        right.tool() = endoscopeAt(p.pose, p_A.cwiseProduct(mirror), axis_A.cwiseProduct(mirror));
        left.tool().v_WT = p.pose.vectorToW(Vec3(0.003, 0.002, 0.02));
        right.tool().v_WT = p.pose.vectorToW(Vec3(-0.003, 0.002, 0.02));
        left.tick();
        right.tick();
        const Vec3 f = p.pose.vectorToA(left.out.tissue.tools[0].force);
        const Vec3 t = p.pose.vectorToA(left.out.tissue.tools[0].torque);
        QVERIFY((f.cwiseProduct(mirror) - p.pose.vectorToA(right.out.tissue.tools[0].force)).norm() < 1e-9);
        QVERIFY((-t.cwiseProduct(mirror) - p.pose.vectorToA(right.out.tissue.tools[0].torque)).norm() <
                1e-11); // an axial vector
        largest_N = std::max(largest_N, std::abs(f.x()));
    }
    QVERIFY(largest_N > 0.1);
}

void TestUrethraScene::poseThatIsNoNumberIsPassedOver() {
    Driver d(wholeProcedure());
    d.startRunning();
    d.at(0.060, 5);
    const double before = d.out.storedEnergy_J;
    d.tool().p_WT.x() = std::numeric_limits<double>::quiet_NaN();
    d.tick();
    QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
    d.at(0.060, 1);
    QCOMPARE(d.out.storedEnergy_J, before);
    d.tool().q_WT.coeffs().setZero();
    d.tick();
    QCOMPARE(norm(d.out.tissue.tools[0]), 0.0);
    d.in.tools.count = 0;
    d.tick();
    QCOMPARE(d.out.tissue.count, 0);
}

void TestUrethraScene::otherToolsTouchNothing() {
    Driver d(wholeProcedure());
    d.in.tools.count = 2;
    d.in.tools.tools[1] = endoscopeAt(d.p.pose, Vec3(0.003, 0.02, 0.04), Vec3::UnitZ());
    d.startRunning();
    d.at(0.060, 3);
    QCOMPARE(norm(d.out.tissue.tools[1]), 0.0);
    QCOMPARE(d.out.p_WProxy[1], d.in.tools.tools[1].p_WT);
    QCOMPARE(d.out.tissue.count, 2);
}

void TestUrethraScene::sameInputsSameOutputs() {
    Driver a(wholeProcedure());
    Driver b(wholeProcedure());
    a.startRunning();
    b.startRunning();
    IdealProcedure first(a.p, 0.050);
    IdealProcedure second(b.p, 0.050);
    for (int n = 0; n < 9000; ++n) {
        a.tool() = first.next(a.out.cues.exercise.of<simulation::EndoscopeCues>().stage,
                              a.scene.procedure().nextLandmark());
        b.tool() = second.next(b.out.cues.exercise.of<simulation::EndoscopeCues>().stage,
                               b.scene.procedure().nextLandmark());
        a.tick();
        b.tick();
        QCOMPARE(a.out.events, b.out.events);
        QVERIFY(a.out.tissue.tools[0].force == b.out.tissue.tools[0].force);
        QVERIFY(a.out.tissue.tools[0].torque == b.out.tissue.tools[0].torque);
        QVERIFY(a.out.cues.exercise.of<simulation::EndoscopeCues>().toLumen_T ==
                b.out.cues.exercise.of<simulation::EndoscopeCues>().toLumen_T);
    }
}

QTEST_APPLESS_MAIN(TestUrethraScene)
#include "test_urethra_scene.moc"
