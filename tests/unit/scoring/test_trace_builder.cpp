// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::scoring;

namespace {

const std::string kPlain = "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n0.001,1.5,2,3\n";

} // namespace

class TestTraceBuilder : public QObject {
    Q_OBJECT
private slots:
    void marksFromButtons();
    void marksFromButtonsEndATrialWhereTheyAnswerIt();
    void trialsAndPhases();
    void changingTargetIsRefused();
    void noRunningRowIsRefused();
};

void TestTraceBuilder::marksFromButtons() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,buttons,fx_N,fy_N,fz_N\n"
                             "0,0,0,0,1,0,0,0\n" // held from before: no mark
                             "1,1,0,0,0,0,0,0\n"
                             "2,2,0,0,2,0,0,0\n" // another button
                             "3,3,0,0,3,0,0,0.5\n"
                             "4,4,0,0,1,0,0,0\n";
    const auto trace =
        buildSessionTrace(*readTraceCsv(text, "m.csv"), "sphere_apex", 4.0, MarkMeaning::endsTheTrial);
    QVERIFY(trace.has_value());
    const TrialTrace& trial = trace->trials.at(0);
    QVERIFY(trial.marked && trial.markInContact);
    QCOMPARE(trial.p_WMark_m.x(), 0.003);
    QCOMPARE(trial.tools.at(0).t_s.size(), std::size_t{4}); // up to and with the mark
    QVERIFY(!trial.target.has_value());
}

void TestTraceBuilder::marksFromButtonsEndATrialWhereTheyAnswerIt() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,buttons\n0,0,0,0,0\n1,1,0,0,1\n2,2,0,0,0\n";
    const auto rows = readTraceCsv(text, "m.csv");
    QCOMPARE(buildSessionTrace(*rows, "a")->trials[0].tools[0].t_s.size(), std::size_t{3});
    QCOMPARE(buildSessionTrace(*rows, "a", 4.0, MarkMeaning::endsTheTrial)->trials[0].tools[0].t_s.size(),
             std::size_t{2});
    const auto unmarked =
        buildSessionTrace(*readTraceCsv(kPlain, "p.csv"), "a", 4.0, MarkMeaning::endsTheTrial);
    QVERIFY(!unmarked->trials[0].marked && !unmarked->trials[0].timedOut);
    QCOMPARE(unmarked->trials[0].p_WMark_m.x(), 0.0015);
    QVERIFY(unmarked->trials[0].markInContact); // no forces in the file: not judged
}

void TestTraceBuilder::trialsAndPhases() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,tool,trial,phase\n"
                             "0,0,0,0,0,1,ready\n"
                             "1,1,0,0,0,1,running\n"
                             "1,5,0,0,1,1,running\n"
                             "2,2,0,0,0,1,between\n"
                             "3,3,0,0,0,2,running\n"
                             "4,4,0,0,0,2,finished\n";
    const auto trace = buildSessionTrace(*readTraceCsv(text, "t.csv"), "sphere_apex");
    QVERIFY(trace.has_value());
    QCOMPARE(trace->trials.size(), std::size_t{2});
    QCOMPARE(trace->trials[0].tools.size(), std::size_t{2});
    QCOMPARE(trace->trials[0].tools[0].t_s.size(), std::size_t{1});
    QCOMPARE(trace->trials[0].tools[1].p_WT_m[0].x(), 0.005);
    QCOMPARE(trace->trials[1].trial, 1);
}

void TestTraceBuilder::changingTargetIsRefused() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,target_x_mm,target_y_mm,target_radius_mm\n"
                             "0,0,0,0,1,2,20\n1,0,0,0,1,2.5,20\n";
    const auto trace = buildSessionTrace(*readTraceCsv(text, "t.csv"), "sphere_apex");
    QVERIFY(!trace && trace.error().message.find("trial 1") != std::string::npos);
}

void TestTraceBuilder::noRunningRowIsRefused() {
    const auto trace =
        buildSessionTrace(*readTraceCsv("t_s,x_mm,y_mm,z_mm,phase\n0,0,0,0,idle\n", "i.csv"), "sphere_apex");
    QVERIFY(!trace && trace.error().message.starts_with("i.csv"));
    QVERIFY(!buildSessionTrace(TraceRows{}, "sphere_apex"));
}

QTEST_APPLESS_MAIN(TestTraceBuilder)
#include "test_trace_builder.moc"
