// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/guarded_run.h"
#include "support/palpation_bench.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;

/// A whole trial of scripted palpators, from the first press to the last word: nothing is allocated, locked
/// or thrown in a tick.
class TestPalpationOperatorGuard : public QObject {
    Q_OBJECT
private slots:
    void aWholeTrial_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("hands");
        for (const std::string_view name : operators::palpationOperatorNames())
            QTest::newRow(name.data()) << QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()))
                                       << (name == "expert" ? 2 : 1);
    }
    void aWholeTrial() {
        QFETCH(QString, name);
        QFETCH(int, hands);
        simulation::PalpationParameters p;
        p.hands = hands;
        p.asksSize = p.asksHardness = true;
        p.tissue.shape.bumps = {{core::Vec2::Zero(), {0.060, 0.060}, 0.0, 0.015}};
        support::PalpationBench bench(p, *operators::palpationOperatorSettings(name.toStdString()), 3);
        const support::BenchTrial trial{{{{0.0, 0.0}, 0.012, 0.009, 10.0}}, {}};
        support::BenchOutcome outcome;
        resetForbiddenCounts();
        {
            const TickGuard guard;
            outcome = bench.run(trial);
        }
        const ForbiddenCounts counts = forbiddenCounts();
        QVERIFY2(counts.total() == 0, words(counts));
        QVERIFY(outcome.done && outcome.marks() > 0 && outcome.pressing_s > 5.0);
    }
};

QTEST_APPLESS_MAIN(TestPalpationOperatorGuard)
#include "test_palpation_operator_guard.moc"
