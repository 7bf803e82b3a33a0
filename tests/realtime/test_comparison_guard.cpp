// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/guarded_run.h"
#include "unit/simulation/comparison_driver.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
namespace bits = core::event_bits;

/// A sitting with every attribute: presented, felt at every place, adjusted meanwhile, paused, answered,
/// spoiled and ended. Nothing is allocated, locked or thrown in a tick, though objects are made in it.
class TestComparisonGuard : public QObject {
    Q_OBJECT
private slots:
    void everyAttribute_data() {
        QTest::addColumn<int>("attribute");
        for (const ComparedAttribute attribute : kComparedAttributes)
            QTest::addRow("%d", static_cast<int>(attribute)) << static_cast<int>(attribute);
    }
    void everyAttribute() {
        QFETCH(int, attribute);
        ComparisonParameters p = compared(static_cast<ComparedAttribute>(attribute));
        p.adjusts = true;
        p.buttonAnswers = true;
        ComparisonDriver d(p);
        resetForbiddenCounts();
        {
            const TickGuard guard;
            d.startRunning(0, 0);
            d.explore(0);
            d.explore(1);
            d.in.paused = true;
            d.ticks(50);
            d.in.paused = false;
            d.present(1, 0); // another level
            d.explore(2);
            d.answer(3);
            d.ticks(50);
            d.startRunning(1, 1);
            d.explore(1);
            d.answer(kAnswerSpoiled);
            d.ticks(50);
            d.answer(kAnswerFinish);
            d.ticks(10);
        }
        const ForbiddenCounts counts = forbiddenCounts();
        QVERIFY2(counts.total() == 0, words(counts));
        const std::uint32_t all =
            bits::kTrialStarted | bits::kContactBegan | bits::kCompleted | bits::kFailed | bits::kFinished;
        QCOMPARE(d.events & all, all);
    }
};

QTEST_APPLESS_MAIN(TestComparisonGuard)
#include "test_comparison_guard.moc"
