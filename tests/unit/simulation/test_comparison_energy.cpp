// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_driver.h"
#include "contact_loops.h"

#include "core/fp_environment.h"

#include <QtTest>

#include <algorithm>
#include <vector>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
namespace q = comparison_quantity;

namespace {

bool conservative(ComparedAttribute attribute) {
    return attribute == ComparedAttribute::stiffness || attribute == ComparedAttribute::mass;
}

} // namespace

/// Objects of a study are smooth over every edge and make no energy.
class TestComparisonEnergy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void noStepOverAnyEdge_data();
    void noStepOverAnyEdge();
    void noTickMakesEnergy_data();
    void noTickMakesEnergy();
    void closedPathsBothWays();
};

void TestComparisonEnergy::noStepOverAnyEdge_data() {
    QTest::addColumn<int>("attribute");
    for (const ComparedAttribute attribute : kComparedAttributes)
        QTest::addRow("%d", static_cast<int>(attribute)) << static_cast<int>(attribute);
}

/// Taken hold of, let go, over the shoulder of a pad and off it: eight times as slowly, the largest step of
/// force is at most a quarter. A step that belongs to the law would stay.
void TestComparisonEnergy::noStepOverAnyEdge() {
    QFETCH(int, attribute);
    const auto which = static_cast<ComparedAttribute>(attribute);
    ComparisonParameters p = compared(which);
    p.exploreLimit_s = 0.0;
    const auto largestStep_N = [&](double slowness) {
        ComparisonDriver d(p);
        d.slowness = slowness;
        d.startRunning();
        for (int place = 0; place < 3; ++place)
            d.explore(place);
        if (!isHooked(which))
            for (const double height_m : {-0.0005, -0.002, -0.004}) { // slides on and off every pad
                d.moveTo(d.at(0, 0.03) - Vec3(0.030, 0.0, 0.0), 0.5);
                d.moveTo(d.at(0, height_m) - Vec3(0.030, 0.0, 0.0), 0.5);
                d.moveTo(d.at(2, height_m) + Vec3(0.030, 0.002, 0.0), 2.8);
                d.moveTo(d.at(2, 0.03) + Vec3(0.030, 0.0, 0.0), 0.5);
            }
        return d.largestStep_N;
    };
    const double quick_N = largestStep_N(1.0);
    const double slow_N = largestStep_N(8.0);
    QVERIFY2(slow_N < 0.25 * quick_N && slow_N < 0.05,
             qPrintable(QStringLiteral("%1 N, slowly %2 N").arg(quick_N).arg(slow_N)));
}

/// All but roughness: the energy of a rough surface is ObjectContact's own test (test_object_contact).
void TestComparisonEnergy::noTickMakesEnergy_data() {
    QTest::addColumn<int>("attribute");
    for (const ComparedAttribute attribute : kComparedAttributes)
        if (attribute != ComparedAttribute::roughness)
            QTest::addRow("%d", static_cast<int>(attribute)) << static_cast<int>(attribute);
}

/// Whatever is done, in no tick more is stored and given back than was put in (by more than the step's own
/// second order).
void TestComparisonEnergy::noTickMakesEnergy() {
    QFETCH(int, attribute);
    const auto which = static_cast<ComparedAttribute>(attribute);
    ComparisonDriver d(compared(which));
    d.startRunning();
    const double before_J = d.work_J;
    for (int place = 0; place < 3; ++place)
        d.explore(place);
    QVERIFY2(d.work_J - before_J > -1e-6, qPrintable(QString::number(d.work_J)));
    QVERIFY2(d.largestMade_J < 2e-5, qPrintable(QString::number(d.largestMade_J)));
}

/// Random loops through slack, stretch, lift, bed and both directions: ≥ −1 µJ.
void TestComparisonEnergy::closedPathsBothWays() {
    core::Random random(5);
    for (const ComparedAttribute attribute : kComparedAttributes) {
        if (!conservative(attribute))
            continue;
        ComparisonDriver d(lossless(attribute));
        d.startRunning();
        d.moveTo(d.at(1, d.hook_m()), 0.4);
        for (int loop = 0; loop < 100; ++loop) {
            // an object stays held over its bed: pressed deeper than kPress_N it would be let go, which test
            // "noTickMakesEnergy" does
            const double lowest_m = attribute == ComparedAttribute::mass ? 0.0 : -0.008;
            std::vector<Vec3> path =
                randomLoop(random, d.at(1, d.hook_m() + 0.004), 0.0055, 400); // never let go
            for (Vec3& corner : path)
                corner.z() = std::max(corner.z(), d.hook_m() + lowest_m);
            for (const bool reverse : {false, true}) {
                if (reverse)
                    std::reverse(path.begin(), path.end());
                d.moveTo(path.front(), 0.05);
                const double before_J = d.work_J;
                const double stored_J = d.out.storedEnergy_J;
                for (const Vec3& corner : path) {
                    d.tool().p_WT = corner;
                    d.tick();
                }
                d.tool().p_WT = path.front();
                d.tick();
                const double made_J = d.out.storedEnergy_J - stored_J - (d.work_J - before_J);
                QVERIFY2(
                    std::abs(made_J) < 1e-6,
                    qPrintable(
                        QStringLiteral("%1: %2 J in loop %3").arg(int(attribute)).arg(made_J).arg(loop)));
                QVERIFY(d.work_J - before_J > -1e-6);
            }
        }
    }
}

QTEST_APPLESS_MAIN(TestComparisonEnergy)
#include "test_comparison_energy.moc"
