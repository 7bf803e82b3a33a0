// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals hold observers three times as steep and flat as a design expects: 200 runs of each procedure and
// fit (times CHIRON_SOAK), seeds that can be changed with CHIRON_COVERAGE_SEED. Prints the table.
//
// The rule, which knows nothing of any table: intervals of 95 % hold the truth in 95 % of runs or more. A row
// fails where that is refuted (exact binomial, 5 % over all rows together) or fewer than 90 % are held;
// misses with a warning are misses. Rows of one factor are also judged together, which finds what is a little
// too narrow everywhere. With 200 runs a single row shows 90 % and less, with CHIRON_SOAK=10 also 93 %.
#include "coverage_runs.h"

#include <QtTest>
#include <algorithm>
#include <array>

using coverage_runs::Row;

class TestCoverageTable : public QObject {
    Q_OBJECT
private slots:
    void theRuleByHand();
    void intervalsHoldWhatTheySay();
};

/// P(X <= 184 of 200) = 0.044 and P(X <= 185) = 0.078 at 95 %.
void TestCoverageTable::theRuleByHand() {
    QCOMPARE(coverage_runs::fewestHeld(200, 1), 185);
    QCOMPARE(coverage_runs::fewestHeld(200, 20), 180);
    QCOMPARE(coverage_runs::fewestHeld(2000, 81), 1867);
    QCOMPARE(coverage_runs::fewestHeld(2, 1), 1); // 0.0025 and 0.0975
}

void TestCoverageTable::intervalsHoldWhatTheySay() {
    bool given = false;
    const auto asked = qEnvironmentVariable("CHIRON_COVERAGE_SEED").toULongLong(&given);
    const std::uint64_t seed = given ? asked : 19470623ULL;
    const int runs = 200 * std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK"));
    const auto rows = coverage_runs::coverageTable(runs, seed);
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    coverage_runs::print(rows);
    QCOMPARE(
        rows.size(),
        78U); // 6 fits of threshold and width, QUEST's two intervals and 12 procedures, by three observers
    const std::array<double, 3> factors{1.0 / 3.0, 1.0, 3.0};
    const int tests = static_cast<int>(rows.size() + factors.size());
    const int fewest = std::max(coverage_runs::fewestHeld(runs, tests), (9 * runs + 9) / 10);
    std::array<int, 3> together{}, of{};
    QStringList faults;
    bool questAloneFails = false;
    for (const Row& row : rows) {
        QCOMPARE(row.runs, runs);
        if (row.what ==
            u"quest, its own interval") { // what the open slope is for: it takes the slope for known
            questAloneFails |= row.covered < fewest;
            continue;
        }
        if (row.covered < fewest)
            faults << QStringLiteral("%1, %2, factor %3: %4 of %5 held, %6 of the others not warned of; "
                                     "expected at least %7")
                          .arg(row.what, row.quantity)
                          .arg(row.factor)
                          .arg(row.covered)
                          .arg(row.runs)
                          .arg(row.missedInSilence)
                          .arg(fewest);
        if (row.quantity == u"sigma") // of runs with random numbers of their own
            for (std::size_t i = 0; i < factors.size(); ++i)
                if (row.factor == factors[i]) {
                    together[i] += row.covered;
                    of[i] += row.runs;
                }
    }
    for (std::size_t i = 0; i < factors.size(); ++i) {
        qInfo("procedures at factor %.2f: %d of %d held", factors[i], together[i], of[i]);
        QCOMPARE(of[i], 12 * runs);
        if (together[i] < coverage_runs::fewestHeld(of[i], tests))
            faults << QStringLiteral("all procedures, factor %1: %2 of %3 held")
                          .arg(factors[i])
                          .arg(together[i])
                          .arg(of[i]);
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    QVERIFY2(questAloneFails,
             "QUEST's own interval holds all observers: nothing is left of what was to be mended");
}

QTEST_APPLESS_MAIN(TestCoverageTable)
#include "test_coverage_table.moc"
