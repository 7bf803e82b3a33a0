// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "palpation_driver.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::ReportField;
using core::TrialPhase;
namespace bits = core::event_bits;
namespace q = palpation_quantity;

/// What a palpation does from trial to trial, and what it says.
class TestPalpationScene : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void trialsFollowOneAnother();
    void timeEndsIt();
    void aMarkIsAFindingAndEndsNothing();
    void commandMarksWhereItIsPressedHardest();
    void reportsFindOneAnother();
    void whatMeansNothingIsNotTold();
    void waitingReportsAreTakenAtTheLimit();
    void pausedNothingIsReported();
    void coverageIsOfTheTrial();
    void fingersTouchEachForThemselves();
    void notANumberTouchesNothing();
    void noToolNoMark();
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

void TestPalpationScene::aMarkIsAFindingAndEndsNothing() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.at(0, 0.011, -0.007, -0.003);
    d.press(0, core::kButtonMark);
    QCOMPARE(d.told.size(), std::size_t{1});
    QCOMPARE(d.told[0].field, ReportField::found);
    QCOMPARE(d.told[0].finding, 0);
    QVERIFY((d.told[0].p_W - Vec3(0.011, -0.007, 0.0)).norm() < 1e-9); // on the surface
    QCOMPARE(d.out.phase, TrialPhase::running);
    QVERIFY(!(d.events & bits::kMarked));
    QVERIFY(d.out.cues.palpation.finding[0].present);
    QCOMPARE(d.out.cues.palpation.selected, 0);
    d.in.tools.tools[0].buttons = core::kButtonMark; // held: once
    d.ticks(100);
    QCOMPARE(d.told.size(), std::size_t{2});
}

void TestPalpationScene::commandMarksWhereItIsPressedHardest() {
    PalpationParameters p = flatPad();
    p.hands = 2;
    PalpationDriver d(p);
    d.startRunning();
    d.at(0, 0.02, 0.0, -0.001);
    d.at(1, -0.02, 0.0, -0.002);
    d.in.mark = true;
    d.tick();
    QVERIFY((d.told.at(0).p_W - Vec3(-0.02, 0.0, 0.0)).norm() < 1e-9);
    d.at(0, 0.02, 0.0, 0.004); // both in the air: the nearer one
    d.at(1, -0.02, 0.0, 0.006);
    d.ticks(10);
    d.in.mark = true;
    d.tick();
    QVERIFY((d.told.at(1).p_W - Vec3(0.02, 0.0, 0.0)).norm() < 1e-9);
    d.ticks(10);
    d.press(1, core::kButtonMark); // a button's is that finger's
    QVERIFY((d.told.at(2).p_W - Vec3(-0.02, 0.0, 0.0)).norm() < 1e-9);
}

void TestPalpationScene::reportsFindOneAnother() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.at(0, 0.01, 0.0, -0.001);
    d.in.mark = true; // all in one tick: the mark first, in the order given then
    d.command(ReportField::size, 75);
    d.command(ReportField::hardness, 4);
    d.tick();
    d.at(0, -0.01, 0.0, -0.001);
    d.press(0, core::kButtonMark);
    d.press(0, core::reportButtons(core::reportWord(ReportField::confidence, 2)));
    d.press(0, core::reportButtons(core::reportWord(ReportField::select, 0)));
    d.press(0, core::reportButtons(core::reportWord(ReportField::confidence, 5)));
    d.settle();
    QCOMPARE(d.told.size(), std::size_t{7});
    const auto& found = d.scene.findings().list();
    QCOMPARE(found[0].radius_m, 0.0075);
    QCOMPARE(int(found[0].hardness), 4);
    QCOMPARE(int(found[0].confidence), 5);
    QCOMPARE(int(found[1].confidence), 2);
    QVERIFY(std::abs(found[1].p_W[0] + 0.01) < 1e-9);
    // Who reads the recording has the same book.
    core::FindingsBook read;
    for (const ToldReport& report : d.told) {
        if (report.field == ReportField::found)
            read.place(report.finding, {report.p_W.x(), report.p_W.y(), report.p_W.z()});
        else if (report.field != ReportField::select)
            QVERIFY(read.rate(report.finding, report.field, report.value) == report.finding);
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        QCOMPARE(read.list()[i].present, found[i].present);
        QCOMPARE(read.list()[i].p_W, found[i].p_W);
        QCOMPARE(read.list()[i].radius_m, found[i].radius_m);
        QCOMPARE(read.list()[i].hardness, found[i].hardness);
        QCOMPARE(read.list()[i].confidence, found[i].confidence);
    }
    d.command(ReportField::remove, 0);
    d.settle();
    QCOMPARE(d.told.back().field, ReportField::remove);
    QCOMPARE(d.told.back().finding, 0);
    QVERIFY(std::abs(d.told.back().p_W.x() - 0.01) < 1e-9); // where it was
    QVERIFY(!d.scene.findings().has(0) && d.scene.findings().has(1));
}

void TestPalpationScene::whatMeansNothingIsNotTold() {
    PalpationDriver d(flatPad());
    d.startRunning();
    for (const std::uint16_t word : {core::reportWord(ReportField::size, 50), core::reportWord(ReportField::remove, 3),
                                     core::reportWord(ReportField::select, 0), core::reportWord(ReportField::found, 0),
                                     std::uint16_t{0xffff}, std::uint16_t{0x7000}}) {
        d.in.report[0] = word;
        d.in.reports = 1;
        d.ticks(20);
    }
    QCOMPARE(d.told.size(), std::size_t{0});
    for (int i = 0; i < 12; ++i) { // more marks than findings
        d.in.mark = true;
        d.ticks(20);
    }
    QCOMPARE(d.told.size(), core::kMaxFindings);
    d.command(ReportField::hardness, 6);
    d.ticks(20);
    QCOMPARE(d.told.size(), core::kMaxFindings);
    d.in.reports = 1000; // whoever says so many: no more than there are
    d.ticks(20);
    QCOMPARE(d.out.phase, TrialPhase::running);
}

void TestPalpationScene::waitingReportsAreTakenAtTheLimit() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.ticks(4998); // the next tick is the last
    d.in.mark = true;
    d.command(ReportField::size, 60);
    d.tick();
    QVERIFY(!(d.events & bits::kTimedOut));
    d.in.mark = true; // too late
    d.ticks(static_cast<int>(PalpationScene::kReportTicks));
    QCOMPARE(d.told.size(), std::size_t{2});
    QCOMPARE(d.told[1].value, 60U);
    // A device of 125 Hz has a sample of the last one too: its quantities stand for kReportTicks before the trial is over.
    d.ticks(static_cast<int>(PalpationScene::kReportTicks) - 1);
    QVERIFY(!(d.events & bits::kTimedOut));
    d.tick();
    QVERIFY(d.events & bits::kTimedOut);
    QCOMPARE(d.told.size(), std::size_t{2});
    QCOMPARE(d.out.quantities[palpation_quantity::kReportValue], 60.0);
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::between);
}

void TestPalpationScene::pausedNothingIsReported() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.at(0, 0.0, 0.0, -0.002);
    d.in.paused = true;
    d.in.mark = true;
    d.command(ReportField::done, 0);
    d.in.tools.tools[0].buttons = core::kButtonMark;
    d.ticks(50);
    QVERIFY(d.force().z() > 0.5); // contact answers
    QCOMPARE(d.out.quantities[q::kCoverage], 0.0);
    d.in.paused = false;
    d.ticks(50); // pressed during the pause: no edge now
    QCOMPARE(d.told.size(), std::size_t{0});
    QVERIFY(d.out.quantities[q::kCoverage] > 0.0);
    QVERIFY(!(d.events & bits::kCompleted));
    QVERIFY(std::abs(d.out.cues.timeLeft_s - 4.949) < 1e-9);
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
    QCOMPARE(d.out.cues.palpation.coverage, d.out.quantities[q::kCoverage]);
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
        QVERIFY(std::abs(d.out.quantities[q::kDepth + i] - (i % 2 == 0 ? 0.001 * (static_cast<double>(i) + 1.0) : 0.0)) < 1e-9);
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

void TestPalpationScene::noToolNoMark() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.in.tools.count = 0;
    d.in.mark = true;
    d.ticks(20);
    QCOMPARE(d.told.size(), std::size_t{0});
    d.in.tools.count = 99;
    d.tick();
    QCOMPARE(d.out.tissue.count, core::kMaxTools);
    d.in.tools.count = -3;
    d.tick();
    QCOMPARE(d.out.tissue.count, 0);
}

void TestPalpationScene::cuesAreTheLevels() {
    PalpationParameters p = flatPad();
    p.asksSize = true;
    PalpationDriver shown(p);
    shown.startRunning();
    const core::PalpationCues& all = shown.out.cues.palpation;
    QVERIFY(all.present && all.asksSize && !all.asksHardness && all.asksConfidence);
    QCOMPARE(all.lumps, 1);
    const Lump& lump = shown.trial().lump[0];
    QVERIFY((Vec3(all.lump[0].p_W[0], all.lump[0].p_W[1], all.lump[0].p_W[2]) - Vec3(lump.place_m.x(), lump.place_m.y(), -lump.depth_m)).norm() < 1e-9);
    QCOMPARE(all.lump[0].radius_m, lump.radius_m);
    QVERIFY(all.bandShown && all.coverageShown);
    QCOMPARE(all.bandHigh_N, p.bandHigh_N);
    p.cues = {"tool"};
    PalpationDriver hidden(p);
    hidden.startRunning();
    hidden.at(0, 0.0, 0.0, -0.003);
    hidden.tick();
    const core::PalpationCues& none = hidden.out.cues.palpation;
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
    QCOMPARE(d.out.cues.palpation.lumps, 0);
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
