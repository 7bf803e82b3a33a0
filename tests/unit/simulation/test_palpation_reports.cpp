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

/// What is marked and reported during a trial of palpation.
class TestPalpationReports : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void aMarkIsAFindingAndEndsNothing();
    void commandMarksWhereItIsPressedHardest();
    void reportsFindOneAnother();
    void whatMeansNothingIsNotTold();
    void waitingReportsAreTakenAtTheLimit();
    void pausedNothingIsReported();
    void noToolNoMark();
};

void TestPalpationReports::aMarkIsAFindingAndEndsNothing() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.at(0, 0.011, -0.007, -0.003);
    d.press(0, core::kButtonMark);
    QCOMPARE(d.told.size(), std::size_t{1});
    QCOMPARE(d.told[0].field, ReportField::found);
    QCOMPARE(d.told[0].finding, 0);
    QCOMPARE(d.told[0].value, 0U);
    QVERIFY((d.told[0].p_W - Vec3(0.011, -0.007, 0.0)).norm() < 1e-9); // on the surface
    QCOMPARE(d.out.phase, TrialPhase::running);
    QVERIFY(!(d.events & bits::kMarked));
    QVERIFY(d.out.cues.exercise.of<simulation::PalpationCues>().finding[0].present);
    QCOMPARE(d.out.cues.exercise.of<simulation::PalpationCues>().selected, 0);
    d.in.tools.tools[0].buttons = core::kButtonMark; // held: once
    d.ticks(100);
    QCOMPARE(d.told.size(), std::size_t{2});
}

void TestPalpationReports::commandMarksWhereItIsPressedHardest() {
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

void TestPalpationReports::reportsFindOneAnother() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.at(0, 0.01, 0.0, -0.001);
    d.in.mark = true; // all in one tick: the mark first, in the order given then
    d.command(ReportField::size, 75);
    d.command(ReportField::hardness, 4);
    d.tick();
    d.at(0, -0.01, 0.0, -0.001);
    d.press(0, core::kButtonMark);
    d.press(0, core::reportButtons(simulation::reportWord(ReportField::confidence, 2)));
    d.press(0, core::reportButtons(simulation::reportWord(ReportField::select, 0)));
    d.press(0, core::reportButtons(simulation::reportWord(ReportField::confidence, 5)));
    d.settle();
    QCOMPARE(d.told.size(), std::size_t{7});
    const auto& found = d.scene.findings().list();
    QCOMPARE(found[0].radius_m, 0.0075);
    QCOMPARE(int(found[0].hardness), 4);
    QCOMPARE(int(found[0].confidence), 5);
    QCOMPARE(int(found[1].confidence), 2);
    QVERIFY(std::abs(found[1].p_W[0] + 0.01) < 1e-9);
    // Who reads the recording has the same book.
    simulation::FindingsBook read;
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

void TestPalpationReports::whatMeansNothingIsNotTold() {
    PalpationDriver d(flatPad());
    d.startRunning();
    for (const std::uint16_t word :
         {simulation::reportWord(ReportField::size, 50), simulation::reportWord(ReportField::remove, 3),
          simulation::reportWord(ReportField::select, 0), simulation::reportWord(ReportField::found, 0),
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
    QCOMPARE(d.told.size(), simulation::kMaxFindings);
    d.command(ReportField::hardness, 6);
    d.ticks(20);
    QCOMPARE(d.told.size(), simulation::kMaxFindings);
    d.in.reports = 1000; // whoever says so many: no more than there are
    d.ticks(20);
    QCOMPARE(d.out.phase, TrialPhase::running);
}

void TestPalpationReports::waitingReportsAreTakenAtTheLimit() {
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
    // A device of 125 Hz has a sample of the last one too: its quantities stand for kReportTicks before the
    // trial is over.
    d.ticks(static_cast<int>(PalpationScene::kReportTicks) - 1);
    QVERIFY(!(d.events & bits::kTimedOut));
    d.tick();
    QVERIFY(d.events & bits::kTimedOut);
    QCOMPARE(d.told.size(), std::size_t{2});
    QCOMPARE(d.out.quantities[palpation_quantity::kReportValue], 60.0);
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::between);
}

void TestPalpationReports::pausedNothingIsReported() {
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

void TestPalpationReports::noToolNoMark() {
    PalpationDriver d(flatPad());
    d.startRunning();
    d.in.tools.count = 0;
    d.in.mark = true;
    d.ticks(20);
    QCOMPARE(d.told.size(), std::size_t{0});
    d.in.tools.count = 1; // nor does a tool report that is not there, whatever stands in its place
    d.in.mark = true;
    d.settle();
    QCOMPARE(d.told.size(), std::size_t{1});
    d.press(1, core::reportButtons(simulation::reportWord(ReportField::confidence, 2)));
    d.settle();
    QCOMPARE(d.told.size(), std::size_t{1});
    d.in.tools.count = 2;
    d.press(1, core::reportButtons(simulation::reportWord(ReportField::confidence, 2)));
    d.settle();
    QCOMPARE(d.told.size(), std::size_t{2});
    d.in.tools.count = 99;
    d.tick();
    QCOMPARE(d.out.tissue.count, core::kMaxTools);
    d.in.tools.count = -3;
    d.tick();
    QCOMPARE(d.out.tissue.count, 0);
}

QTEST_APPLESS_MAIN(TestPalpationReports)
#include "test_palpation_reports.moc"
