// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals hold observers three times as steep and flat as a design expects: 200 runs of each procedure and fit (times CHIRON_SOAK), seeds that can be
// changed with CHIRON_COVERAGE_SEED. Prints the table.
#include "coverage_runs.h"

#include <QtTest>

class TestCoverageTable : public QObject {
    Q_OBJECT
private slots:
    void intervalsHoldWhatTheySay();
};

void TestCoverageTable::intervalsHoldWhatTheySay() {
    bool given = false;
    const auto asked = qEnvironmentVariable("CHIRON_COVERAGE_SEED").toULongLong(&given);
    const std::uint64_t seed = given ? asked : 20261125ULL;
    const auto rows = coverage_runs::coverageTable(200 * std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK")), seed);
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    coverage_runs::print(rows);
    QVERIFY(rows.size() > 50);
    QCOMPARE(coverage_runs::fewestByChance(200), 184);
    int questAlone = 0;
    for (const coverage_runs::Row& row : rows) {
        QCOMPARE(row.runs, rows.front().runs);
        if (row.what == u"quest, its own interval") { // what the open slope is for: it takes the slope for known
            questAlone += coverage_runs::notTooFew(row) ? 0 : 1;
            continue;
        }
        // As many as chance allows 95 % intervals to miss; of runs those that say nothing: a few runs at the end of what answers can tell are warned of.
        const int fewest = coverage_runs::fewestByChance(row.runs);
        const bool enough = row.what.startsWith(u"fit, bayes") ? row.covered >= fewest : row.runs - row.missedInSilence >= fewest;
        QVERIFY2(enough, qPrintable(QStringLiteral("%1, %2, factor %3: %4 of %5 held, %6 of the others not warned of").arg(row.what, row.quantity).arg(row.factor).arg(row.covered).arg(row.runs).arg(row.missedInSilence)));
        QVERIFY2(coverage_runs::notTooFew(row) && row.covered >= 0.9 * row.runs,
                 qPrintable(QStringLiteral("%1, %2, factor %3: %4 of %5").arg(row.what, row.quantity).arg(row.factor).arg(row.covered).arg(row.runs)));
    }
    QVERIFY2(questAlone > 0, "QUEST's own interval holds all observers: nothing is left of what was to be mended");
}

QTEST_APPLESS_MAIN(TestCoverageTable)
#include "test_coverage_table.moc"
