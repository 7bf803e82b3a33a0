// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "palpation_driver.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::TrialPhase;
using simulation::ReportField;
namespace bits = core::event_bits;
namespace q = palpation_quantity;

/// What a palpation does from trial to trial, and what it says.
class TestPalpationScene : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void trialsFollowOneAnother();
    void timeEndsIt();
    void coverageIsOfTheTrial();
    void fingersTouchEachForThemselves();
    void notANumberTouchesNothing();
    void cuesAreTheLevels();
    void withoutForceThereIsNothingToFeel();
    void lumpsMoveOutOfContact();
    void catchTrialsFeelAlikeEverywhere();
};

void TestPalpationScene::trialsFollowOneAnother() {
    PalpationDriver d(flatPad());
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::idle);
    d.at(0, 0.0, 0.0, -0.002);
    d.tick();
    QCOMPARE(d.force().norm(), 0.0); // no tissue before the start
    d.in.started = true;
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QVERIFY(d.out.events & bits::kSceneChanged);
    QVERIFY(d.force().z() > 0.5);
    d.in.forceReady = true;
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::running);
    QVERIFY(d.out.events & bits::kTrialStarted);
    d.command(ReportField::done, 0);
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::running); // the last tick still has the tissue
    QVERIFY((d.out.events & bits::kCompleted) && !(d.out.events & bits::kTimedOut));
    QVERIFY(d.force().z() > 0.5);
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::between);
    QCOMPARE(d.force().norm(), 0.0);
    d.ticks(20);
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QCOMPARE(int(d.out.trial), 1);
    d.tick();
    d.command(ReportField::done, 0);
    d.ticks(2);
    QCOMPARE(d.out.phase, TrialPhase::finished);
    QVERIFY(d.out.events & bits::kFinished);
    QVERIFY(!(d.events & (bits::kMarked | bits::kFailed)));
}

void TestPalpationScene::timeEndsIt() {
    PalpationDriver d(flatPad());
    d.startRunning();
    QCOMPARE(d.out.cues.timeLeft_s, 4.999);
    d.ticks(4998);
    QVERIFY(!(d.events & bits::kTimedOut));
    d.tick();
    QVERIFY((d.out.events & bits::kTimedOut) && !(d.out.events & bits::kCompleted));
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::between);
}

void TestPalpationScene::coverageIsOfTheTrial() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.at(0, 0.01, 0.01, -0.0005); // 0.33 N: less than counts
    d.ticks(10);
    QCOMPARE(d.out.quantities[q::kCoverage], 0.0);
    d.at(0, 0.01, 0.01, -0.002);
    d.ticks(10);
    const double pad = 3.14159 * 0.005 * 0.005 / (0.08 * 0.08);
    QVERIFY(std::abs(d.out.quantities[q::kCoverage] - pad) < 0.25 * pad); // whole cells
    QCOMPARE(d.out.cues.exercise.of<simulation::PalpationCues>().coverage, d.out.quantities[q::kCoverage]);
    d.at(0, 0.01, 0.01, 0.01);
    d.command(ReportField::done, 0);
    d.ticks(40);
    QCOMPARE(int(d.out.trial), 1);
    QCOMPARE(d.out.quantities[q::kCoverage], 0.0);
}

void TestPalpationScene::fingersTouchEachForThemselves() {
    PalpationParameters p = flatPad();
    p.hands = p.fingers = 2;
    PalpationDriver d(p);
    d.startRunning();
    const double apart[] = {-0.03, -0.012, 0.012, 0.03};
    for (int i = 0; i < 4; ++i)
        d.at(i, apart[i], 0.035, i % 2 == 0 ? -0.001 * (i + 1) : 0.010);
    d.events = 0;
    d.tick();
    QVERIFY((d.out.events & bits::kContactBegan) && !(d.out.events & bits::kContactEnded));
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(d.force(i).z() > 0.1, i % 2 == 0);
        QCOMPARE(d.out.display[i].normalForce_N > 0.1, i % 2 == 0);
        QVERIFY(std::abs(d.out.quantities[q::kDepth + i] -
                         (i % 2 == 0 ? 0.001 * (static_cast<double>(i) + 1.0) : 0.0)) < 1e-9);
    }
    PalpationParameters alone = flatPad();
    PalpationDriver one(alone);
    one.startRunning();
    one.at(0, apart[2], 0.035, -0.003);
    one.tick();
    QVERIFY((one.force() - d.force(2)).norm() < 1e-12); // the other fingers are not felt
    QVERIFY(d.out.storedEnergy_J > one.out.storedEnergy_J);
    QVERIFY(!d.out.energyByBody);
    QCOMPARE(d.out.body, (std::array<std::uint8_t, core::kMaxTools>{}));
    d.at(0, apart[0], 0.035, 0.01);
    d.at(1, apart[1], 0.035, -0.001);
    d.tick();
    QVERIFY((d.out.events & bits::kContactBegan) && (d.out.events & bits::kContactEnded));
}

void TestPalpationScene::notANumberTouchesNothing() {
    PalpationParameters p = flatPad();
    p.hands = 2;
    PalpationDriver d(p);
    d.startRunning();
    d.at(0, 0.0, 0.0, -0.002);
    d.at(1, 0.02, 0.0, -0.001);
    d.tick();
    d.in.tools.tools[0].p_WT.x() = std::numeric_limits<double>::quiet_NaN();
    d.in.mark = true;
    d.tick();
    QCOMPARE(d.force(0).norm(), 0.0);
    QVERIFY(d.force(1).z() > 0.3);
    QVERIFY((d.told.at(0).p_W - Vec3(0.02, 0.0, 0.0)).norm() < 1e-9);
    d.press(0, core::kButtonMark); // a finger that is nowhere marks nothing
    d.ticks(20);
    QCOMPARE(d.told.size(), std::size_t{1});
    for (const double value : d.out.quantities)
        QVERIFY(std::isfinite(value));
    d.at(0, 0.0, 0.0, -0.002);
    d.in.tools.tools[0].v_WT.y() = std::numeric_limits<double>::infinity();
    d.tick();
    QCOMPARE(d.force(0).norm(), 0.0);
    d.in.tools.tools[0].v_WT.setZero();
    d.tick();
    QVERIFY(d.force(0).z() > 0.5);
}

void TestPalpationScene::cuesAreTheLevels() {
    PalpationParameters p = flatPad();
    p.asksSize = true;
    PalpationDriver shown(p);
    shown.startRunning();
    const simulation::PalpationCues& all = shown.out.cues.exercise.of<simulation::PalpationCues>();
    QVERIFY(all.present && all.asksSize && !all.asksHardness && all.asksConfidence);
    QCOMPARE(all.lumps, 1);
    const Lump& lump = shown.trial().lump[0];
    QVERIFY((Vec3(all.lump[0].p_W[0], all.lump[0].p_W[1], all.lump[0].p_W[2]) -
             Vec3(lump.place_m.x(), lump.place_m.y(), -lump.depth_m))
                .norm() < 1e-9);
    QCOMPARE(all.lump[0].radius_m, lump.radius_m);
    QVERIFY(all.bandShown && all.coverageShown);
    QCOMPARE(all.bandHigh_N, p.bandHigh_N);
    p.cues = {"tool"};
    PalpationDriver hidden(p);
    hidden.startRunning();
    hidden.at(0, 0.0, 0.0, -0.003);
    hidden.tick();
    const simulation::PalpationCues& none = hidden.out.cues.exercise.of<simulation::PalpationCues>();
    QVERIFY(none.present && !none.bandShown && !none.coverageShown);
    QCOMPARE(none.lumps, 0);
    QCOMPARE(none.lump[0].radius_m, 0.0);
    QCOMPARE(none.depth_m[0], 0.0);
    QCOMPARE(none.coverage, 0.0);
}

void TestPalpationScene::withoutForceThereIsNothingToFeel() {
    PalpationParameters p = flatPad();
    p.control.forceOff = true;
    PalpationDriver d(p);
    d.startRunning();
    const core::Vec2 lump = d.trial().lump[0].place_m;
    for (const double x_m : {lump.x(), lump.x() + 0.01, -lump.x()}) {
        d.at(0, x_m, lump.y(), -0.004);
        d.tick();
        QCOMPARE(d.force().norm(), 0.0);
        QCOMPARE(d.out.display[0].normalForce_N, 0.0);
        QCOMPARE(d.out.display[0].pitch_rad, 0.0);
        QCOMPARE(d.out.display[0].roll_rad, 0.0);
        QCOMPARE(d.out.storedEnergy_J, 0.0);
        QCOMPARE(d.out.quantities[q::kLean], 0.0);
    }
    d.in.mark = true; // what is marked has its place all the same
    d.tick();
    QVERIFY((d.told.at(0).p_W - Vec3(-lump.x(), lump.y(), 0.0)).norm() < 1e-9);
}

void TestPalpationScene::lumpsMoveOutOfContact() {
    PalpationParameters p = flatPad();
    p.control.moveAfter_s = 1.0;
    p.control.move_m = {0.0, 0.08 / 3.0};
    PalpationDriver d(p);
    d.startRunning();
    const auto centre = [&] { return d.scene.tissue().lumpCentre_W(0); };
    const Vec3 before = centre();
    d.at(0, 0.0, 0.0, -0.002);
    d.ticks(1500); // held in contact beyond the time
    QVERIFY((centre() - before).norm() < 1e-12);
    QCOMPARE(d.out.quantities[q::kLumpsMoved], 0.0);
    d.at(0, 0.0, 0.0, 0.002);
    d.tick();
    QVERIFY((centre() - before - Vec3(0.0, 0.08 / 3.0, 0.0)).norm() < 1e-12);
    QCOMPARE(d.out.quantities[q::kLumpsMoved], 1.0);
    d.ticks(500);
    QVERIFY((centre() - before - Vec3(0.0, 0.08 / 3.0, 0.0)).norm() < 1e-12); // once
    d.command(ReportField::done, 0);
    d.ticks(40);
    QCOMPARE(int(d.out.trial), 1);
    QCOMPARE(d.out.quantities[q::kLumpsMoved], 0.0);
    QVERIFY((centre().head<2>() - d.trial().lump[0].place_m).norm() < 1e-12);
}

void TestPalpationScene::catchTrialsFeelAlikeEverywhere() {
    PalpationParameters p = flatPad();
    p.catchTrials = 1;
    std::uint64_t seed = 0; // whose first trial is the catch trial
    while (planPalpationTrials(p, seed)[0].lumps != 0)
        ++seed;
    PalpationDriver d(p, seed);
    d.startRunning();
    QCOMPARE(d.out.cues.exercise.of<simulation::PalpationCues>().lumps, 0);
    const auto pressAt = [&](double x_m, double y_m) {
        d.at(0, x_m, y_m, 0.01);
        d.tick();
        d.at(0, x_m, y_m, -0.004);
        d.tick();
        return d.force();
    };
    const Vec3 first = pressAt(0.0, 0.0);
    QVERIFY(first.z() > 1.0);
    for (int i = -3; i <= 3; ++i)
        for (int k = -3; k <= 3; ++k)
            QVERIFY((pressAt(0.01 * i, 0.01 * k) - first).norm() < 1e-9);
}

QTEST_APPLESS_MAIN(TestPalpationScene)
#include "test_palpation_scene.moc"
