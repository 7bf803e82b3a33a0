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

/// Anywhere about the pads, above, within and far below their tops.
Vec3 anywhere(core::Random& random) {
    return {random.uniform(-0.080, 0.080), random.uniform(-0.040, 0.040), random.uniform(-0.080, 0.002)};
}

/// Rough pads without damping, whose trial runs.
struct RoughPads : ComparisonDriver {
    explicit RoughPads(double slope) : ComparisonDriver(withSlope(slope)) { startRunning(); }
    static ComparisonParameters withSlope(double slope) {
        ComparisonParameters p = lossless(ComparedAttribute::roughness);
        p.padSlope = slope;
        return p;
    }
};

const SceneOutput& at(ComparisonDriver& d, const Vec3& p) {
    d.last = d.tool().p_WT = p; // without a velocity
    return d.tick();
}

/// −∇U at `p`, by central differences.
Vec3 fall(ComparisonDriver& d, const Vec3& p) {
    constexpr double kStep_m = 1e-6;
    Vec3 down;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Vec3 step = kStep_m * Vec3::Unit(axis);
        const double over_J = at(d, p + step).storedEnergy_J;
        down[axis] = -(over_J - at(d, p - step).storedEnergy_J) / (2.0 * kStep_m);
    }
    return down;
}

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
    void aBoundedPadIsAPotentialToItsEdges_data();
    void aBoundedPadIsAPotentialToItsEdges();
    void aPadIsNoSteeperThanStated();
    void theLoadFollowsFromTheEnergy();
    void theLoadOfATouchedPadStays();
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

void TestComparisonEnergy::aBoundedPadIsAPotentialToItsEdges_data() {
    QTest::addColumn<double>("slope");
    QTest::addColumn<bool>("potential");
    QTest::newRow("bounded") << 0.75 << true;
    QTest::newRow("steeper") << 2.0 << true;
    QTest::newRow("as in earlier versions") << 0.0 << false;
}

/// What is felt of roughness is −∇U wherever a hand can go. Without a bound it is not on the slopes of the
/// edges: there, 32 mJ were made in one contact.
void TestComparisonEnergy::aBoundedPadIsAPotentialToItsEdges() {
    QFETCH(double, slope);
    QFETCH(bool, potential);
    RoughPads d(slope);
    core::Random random(17);
    double worst_N = 0.0, most_N = 0.0;
    for (int n = 0; n < 2000; ++n) {
        const Vec3 p = anywhere(random);
        const Vec3 down = fall(d, p), force = at(d, p).tissue.tools[0].force;
        worst_N = std::max(worst_N, (force - down).norm());
        most_N = std::max(most_N, force.norm());
    }
    QVERIFY(most_N > 20.0);
    // The differences themselves err by a sixth of the step squared times U''', about 1e-5 N.
    QVERIFY2((worst_N < 1e-4) == potential, qPrintable(QString::number(worst_N)));
}

/// A smooth pad exerts at most √(1 + s²) times the force of its depth, and falls off without a corner.
void TestComparisonEnergy::aPadIsNoSteeperThanStated() {
    constexpr double kSlope = 0.75;
    ComparisonParameters p = lossless(ComparedAttribute::viscosity);
    p.padSlope = kSlope;
    ComparisonDriver d(p);
    d.startRunning();
    double steepest = 0.0;
    for (double out_m = 0.0; out_m < 0.030; out_m += 1e-5) { // beyond the last pad, where it is alone
        const SceneOutput& felt = at(d, d.at(2, -0.002) + Vec3(out_m, 0.0, 0.0));
        const double depth_m = felt.quantities[q::kDepth];
        if (!(depth_m > 1e-6))
            break;
        const double slant = felt.tissue.tools[0].force.norm() / (p.object.stiffness_N_per_m * depth_m);
        QVERIFY(slant >= steepest - 1e-9); // ever steeper, until the cone
        steepest = slant;
        const double outward = felt.tissue.tools[0].force.x() / felt.tissue.tools[0].force.z();
        QVERIFY(std::abs(outward - std::clamp((out_m - p.padRadius_m) / p.padEdge_m, 0.0, kSlope)) < 1e-9);
    }
    QVERIFY(steepest > 1.05 && steepest <= std::hypot(1.0, kSlope) + 1e-9);
}

/// A cap on this load is one on the energy, and so makes none: beyond twice the cap it is the same multiple
/// of √U everywhere, and no force is larger. Up to 1.25 times the cap it changes nothing that is felt.
void TestComparisonEnergy::theLoadFollowsFromTheEnergy() {
    RoughPads d(0.75);
    const double cap_N = d.parameters.maximumForce_N;
    core::Random random(18);
    double multiple = 0.0;
    int shallow = 0, deep = 0;
    for (int n = 0; n < 4000; ++n) {
        const SceneOutput& felt = at(d, anywhere(random));
        const double smooth_N = std::sqrt(2.0 * d.parameters.object.stiffness_N_per_m * felt.storedEnergy_J);
        const double times = smooth_N > 0.0 ? felt.load_N[0] / smooth_N : 1.0;
        if (smooth_N < 1.25 * cap_N) {
            ++shallow;
            QVERIFY(std::abs(times - 1.0) < 1e-9);
        } else if (smooth_N > 2.0 * cap_N) {
            ++deep;
            QVERIFY(multiple == 0.0 || std::abs(times - multiple) < 1e-9 * multiple);
            multiple = times;
            QVERIFY(felt.tissue.tools[0].force.norm() <= felt.load_N[0]);
        }
    }
    QVERIFY(shallow > 500 && deep > 500);
    RoughPads before(0.0); // in sessions of earlier versions there is none
    QCOMPARE(at(before, before.at(1, -0.003)).load_N[0], 0.0);
}

/// In an adjustment another pad gets rougher while this one is pressed: what is felt of it must not jump.
void TestComparisonEnergy::theLoadOfATouchedPadStays() {
    ComparisonParameters p = lossless(ComparedAttribute::roughness);
    p.padSlope = 0.75;
    p.adjusts = true;
    const double value = p.values[0][0];
    p.values.push_back({value, 8.0 * value, 9.0 * value});
    ComparisonDriver d(p);
    d.startRunning();
    const Vec3 pressed = d.at(0, -0.025); // 10 N: more than twice the cap
    const double load_N = at(d, pressed).load_N[0];
    QVERIFY(load_N > 2.0 * p.maximumForce_N);
    d.present(2, 0);
    QCOMPARE(at(d, pressed).load_N[0], load_N);
    at(d, d.at(0, 0.05)); // let go of, so that the new pads are there
    at(d, d.at(0, 0.05));
    QVERIFY(at(d, pressed).load_N[0] > 1.2 * load_N);
}

QTEST_APPLESS_MAIN(TestComparisonEnergy)
#include "test_comparison_energy.moc"
