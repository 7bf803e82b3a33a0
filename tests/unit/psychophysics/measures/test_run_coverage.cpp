// SPDX-License-Identifier: GPL-3.0-or-later
// Coverage of 95 % intervals and bias, seeds 1..2000, Thurstone observers with 2 % lapses.
#include "tests/unit/psychophysics/measures/thurstone_runs.h"

#include <QtTest>

using namespace thurstone_runs;

class TestRunCoverage : public QObject {
    Q_OBJECT
private slots:
    void coverage_data();
    void coverage();
    void adaptive_data();
    void adaptive();
};

void TestRunCoverage::coverage_data() {
    QTest::addColumn<int>("task");
    QTest::addColumn<int>("trials");
    QTest::newRow("rank3 40") << static_cast<int>(Task::rank3) << 40;
    QTest::newRow("rank3 80") << static_cast<int>(Task::rank3) << 80;
    QTest::newRow("2afc 160") << static_cast<int>(Task::twoAfc) << 160;
    QTest::newRow("3afc 120") << static_cast<int>(Task::threeAfc) << 120;
    QTest::newRow("oddity 160") << static_cast<int>(Task::oddity) << 160;
    QTest::newRow("same_different 240") << static_cast<int>(Task::sameDifferent) << 240;
    QTest::newRow("yes_no 240") << static_cast<int>(Task::yesNo) << 240;
}

void TestRunCoverage::coverage() {
    QFETCH(int, task);
    QFETCH(int, trials);
    const Coverage seen = coverageOf(static_cast<Task>(task), trials, 0.05, 0.02, 2000);
    qInfo("%s: covered %.4f, bias %+.4f log10, sd %.4f", QTest::currentDataTag(), seen.covered, seen.bias,
          seen.sd);
    QVERIFY(seen.covered >= 0.92);
    QVERIFY(std::abs(seen.bias) < 0.02);
}

void TestRunCoverage::adaptive_data() {
    QTest::addColumn<int>("trials");
    QTest::addColumn<double>("sd"); // psychophysics.md §5.7
    QTest::newRow("20") << 20 << 0.110;
    QTest::newRow("40") << 40 << 0.080;
    QTest::newRow("60") << 60 << 0.062;
}

/// Trials placed by rank-3 QUEST+, as studies do.
void TestRunCoverage::adaptive() {
    QFETCH(int, trials);
    QFETCH(double, sd);
    const Coverage seen = adaptiveCoverage(2000, trials);
    qInfo("rank-3 QUEST+, %d trials: covered %.4f, bias %+.4f log10, sd %.4f (%.3f in the design)", trials,
          seen.covered, seen.bias, seen.sd, sd);
    QVERIFY(seen.covered >= 0.92);
    QVERIFY(std::abs(seen.bias) < 0.02);
}

QTEST_APPLESS_MAIN(TestRunCoverage)
#include "test_run_coverage.moc"
