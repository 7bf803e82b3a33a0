// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/guarded_run.h"
#include "unit/simulation/handling_driver.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::tests;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
namespace bits = core::event_bits;

/// Every kind of object handling, from the first grasp to the last let go: nothing is allocated, locked or
/// thrown in a tick.
class TestHandlingGuard : public QObject {
    Q_OBJECT
private slots:
    void everyTask_data() {
        QTest::addColumn<bool>("weigh");
        QTest::addColumn<bool>("organ");
        QTest::newRow("place") << false << false;
        QTest::newRow("weigh") << true << false;
        QTest::newRow("soft organ") << false << true;
    }
    void everyTask() {
        QFETCH(bool, weigh);
        QFETCH(bool, organ);
        ObjectHandlingParameters p = oneOvary();
        p.object.roughness_m = 40e-6;
        p.object.recoveryTime_s = 0.3;
        p.object.recoveryShare = 0.5;
        if (weigh) {
            p.task = HandlingTask::weigh;
            p.objects = 3;
            p.massLow_kg = 0.010;
            p.massHigh_kg = 0.020;
        }
        if (organ)
            p = onOrgan(p);
        HandlingDriver d(p);
        d.in.started = d.in.forceReady = true;
        resetForbiddenCounts();
        {
            const TickGuard guard;
            d.ticks(2);
            const Vec3 middle = d.body().p_W;
            d.moveTo(middle + Vec3(0.0, 0.0, 0.040), 0.4);
            d.moveTo(middle, 0.4);
            d.jawTo(d.openingFor(0.003), 0.3);
            d.moveBy(Vec3(0.0, 0.0, 0.040), 0.6);
            d.moveTo(d.overTarget(d.tool().p_WT.z()), 0.6);
            d.in.paused = true;
            d.ticks(100);
            d.in.paused = false;
            d.moveTo(d.overTarget(middle.z()), 0.6);
            d.jawTo(2.0 * p.radius_m + 0.006, 0.3);
            d.ticks(500);
            d.moveBy(Vec3(0.0, 0.0, 0.040), 0.4);
            d.tool().jaw_rad = 0.0;
            d.moveTo(Vec3(0.005, 0.005, -0.002), 0.5); // presses bed and what lies there
            d.moveBy(Vec3(0.010, 0.0, 0.0), 0.5);
        }
        const ForbiddenCounts counts = forbiddenCounts();
        QVERIFY2(counts.total() == 0, words(counts));
        const std::uint32_t all =
            bits::kTrialStarted | bits::kGrasped | bits::kReleased | bits::kCompleted | bits::kContactBegan;
        QCOMPARE(d.events & all, all);
        QCOMPARE((d.events & bits::kSlowApplied) != 0, organ);
    }
};

QTEST_APPLESS_MAIN(TestHandlingGuard)
#include "test_handling_guard.moc"
