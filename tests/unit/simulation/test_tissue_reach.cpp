// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/random.h"
#include "simulation/yield.h"
#include "tissue_laws.h"

#include <QRandomGenerator>
#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

/// Two lobes and a furrow, as the content's prostate has them: the smallest radius of curvature is about 11
/// mm.
TissueParameters lobes() {
    TissueParameters p = quietPad();
    p.shape.planeHeight_m = -0.004;
    p.shape.bumps = {{Vec2(-0.010, 0.0), Vec2(0.020, 0.026), 0.0, 0.006},
                     {Vec2(0.010, 0.0), Vec2(0.020, 0.026), 0.0, 0.006}};
    return p;
}

std::vector<Lump> lumpsOfLobes() {
    return {{Vec2(-0.010, 0.002), 0.010, 0.004, 10.0}, {Vec2(0.012, -0.004), 0.012, 0.005, 4.0}};
}

Vec3 somewhere(core::Random& random) {
    return {random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.015)};
}

} // namespace

// Wherever a finger can be pushed, far below what content checks: bounded, continuous, and never a source of
// energy.
class TestTissueReach : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        core::setModelFloatingPointEnvironment();
        m_seed = QRandomGenerator::global()->generate64();
        qInfo("seed %llu", static_cast<unsigned long long>(m_seed));
    }
    void pressedThroughTheCentreOfCurvature();
    void pressedThroughTheLump();
    void noPathChangesForceWithoutBound_data();
    void noPathChangesForceWithoutBound();
    void reportedStiffnessBoundsEveryChange_data();
    void reportedStiffnessBoundsEveryChange();
    void noLoopMakesEnergy_data();
    void noLoopMakesEnergy();
    void tissueGivesWayOnce();

private:
    std::uint64_t m_seed = 0;
};

// Straight down on the top of a lobe: what was 3,310 N at 11.11 mm grows like a spring, and never falls.
void TestTissueReach::pressedThroughTheCentreOfCurvature() {
    const TissueContact contact = contactOf(lobes(), {});
    const double unique_m = contact.surface().deepestUnique_m();
    QVERIFY(unique_m > 0.010 && unique_m < 0.013);
    const Vec2 top(-0.010, 0.0);
    const Vec3 above = contact.surface().pointAt(top);
    TissueTouch touch;
    double before_N = 0.0;
    bool beyond = false;
    for (double d_m = 1e-5; d_m < 0.040; d_m += 1e-5) {
        const TissueResponse r = contact.respond(toolAt(above - d_m * Vec3::UnitZ()), touch);
        const double f_N = r.force.norm();
        QVERIFY2(f_N <= 1.6 * contact.normalStiffness_N_per_m() * d_m + 1e-9,
                 qPrintable(QString("%1 N at %2 mm").arg(f_N).arg(1e3 * d_m)));
        QVERIFY2(f_N >= before_N - 1e-3,
                 qPrintable(QString("%1 N after %2 N at %3 mm").arg(f_N).arg(before_N).arg(1e3 * d_m)));
        QVERIFY(r.beyondChecked || !beyond);
        beyond = r.beyondChecked;
        before_N = f_N;
    }
    QVERIFY(beyond);
}

// Down through the lump, where the law's force turned round: -3.65 N at 56 mm.
void TestTissueReach::pressedThroughTheLump() {
    const TissueContact contact = contactOf(quietPad(), {{Vec2(0.0, 0.0), 0.012, 0.0075, 10.0}});
    double before_N = 0.0;
    for (double d_m = 1e-5; d_m < 0.060; d_m += 1e-5) {
        const TissueResponse r = pressAt(contact, Vec3(0.0, 0.0, -d_m));
        QVERIFY2(r.force.z() > before_N,
                 qPrintable(QString("%1 N at %2 mm").arg(r.force.z()).arg(1e3 * d_m)));
        QCOMPARE(r.beyondChecked, d_m > 0.009); // λ d ≤ (h − R)/2
        QVERIFY(r.force.z() < 2.2 * contact.normalStiffness_N_per_m() * d_m);
        before_N = r.force.z();
    }
}

void TestTissueReach::noPathChangesForceWithoutBound_data() {
    QTest::addColumn<bool>("curved");
    QTest::newRow("pad") << false;
    QTest::newRow("lobes") << true;
}

// The bound: along the normal at most twice the tissue's stiffness, across a lump ½ k g² χ'' with g ≤ 18 mm
// and χ'' ≤ 3·10⁴ m⁻², which is 5 k; for a curved surface what the change of potentials adds over its 2 mm.
void TestTissueReach::noPathChangesForceWithoutBound() {
    QFETCH(bool, curved);
    const TissueContact contact = curved ? contactOf(lobes(), lumpsOfLobes()) : contactOf(quietPad());
    const double k = contact.normalStiffness_N_per_m();
    core::Random random = core::Random::stream(m_seed, curved ? "lobes" : "pad");
    double worst = 0.0;
    for (int path = 0; path < 200; ++path) {
        TissueTouch touch;
        Vec3 from = somewhere(random);
        Vec3 before = contact.respond(toolAt(from), touch).force;
        for (int leg = 0; leg < 3; ++leg) {
            const Vec3 to = somewhere(random);
            const int steps = static_cast<int>((to - from).norm() / 1e-4) + 1; // 0.1 mm: 0.1 m/s
            for (int i = 1; i <= steps; ++i) {
                const Vec3 p = from + (to - from) * (static_cast<double>(i) / steps);
                const TissueResponse r = contact.respond(toolAt(p), touch);
                QVERIFY(r.force.allFinite());
                if (r.force.norm() < 13.5) // content yields here at the latest
                    worst = std::max(worst, ((r.force - before).norm() - 0.1) / ((to - from).norm() / steps));
                before = r.force;
            }
            from = to;
        }
    }
    qInfo("worst slope %.0f N/m, k = %.0f N/m", worst, k);
    QVERIFY2(worst <= (curved ? 12.0 : 7.0) * k, qPrintable(QString::number(worst)));
}

void TestTissueReach::reportedStiffnessBoundsEveryChange_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("pad with lumps") << 0;
    QTest::newRow("lobes with lumps") << 1;
    QTest::newRow("dome with a harder region") << 2; // 1,700 N/m sideways where 380 were reported
}

// What the passivity controller credits, and the sweep allows, is what the contact reports: no direction is
// steeper.
void TestTissueReach::reportedStiffnessBoundsEveryChange() {
    QFETCH(int, kind);
    TissueParameters dome = quietDome();
    dome.regions = {harderRegion()};
    const TissueContact contact = kind == 0   ? contactOf(quietPad())
                                  : kind == 1 ? contactOf(lobes(), lumpsOfLobes())
                                              : contactOf(dome, {});
    core::Random random = core::Random::stream(m_seed, "stiffness " + std::to_string(kind));
    constexpr double kStep_m = 1e-6;
    double worst = 0.0;
    int touched = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.025, 0.010));
        const Vec3 way = Vec3(random.normal(), random.normal(), random.normal()).normalized() * kStep_m;
        const TissueResponse a = pressAt(contact, p), b = pressAt(contact, p + way);
        if (!a.inContact || !b.inContact || a.force.norm() > 13.5) // content yields here at the latest
            continue;
        ++touched;
        worst = std::max(worst, (b.force - a.force).norm() / kStep_m /
                                    std::max(a.stiffness_N_per_m, b.stiffness_N_per_m));
    }
    qInfo("steepest change over the reported stiffness: %.3f", worst);
    QVERIFY(touched > 2000);
    QVERIFY2(worst <= 1.0 + 1e-6, qPrintable(QString::number(worst)));
}

void TestTissueReach::noLoopMakesEnergy_data() {
    noPathChangesForceWithoutBound_data();
}

// Out, down anywhere, across, and out again, each loop both ways: at least -1 µJ.
void TestTissueReach::noLoopMakesEnergy() {
    QFETCH(bool, curved);
    const TissueContact contact = curved ? contactOf(lobes(), lumpsOfLobes()) : contactOf(quietPad());
    core::Random random = core::Random::stream(m_seed, curved ? "loops on lobes" : "loops on a pad");
    double worst_J = 0.0;
    for (int loop = 0; loop < 20; ++loop) {
        std::vector<Vec3> places{Vec3(0.03, 0.0, 0.02)};
        for (int i = 0; i < 3; ++i)
            places.push_back(somewhere(random));
        places.push_back(places.front());
        for (int way = 0; way < 2; ++way) {
            TissueTouch touch;
            double work_J = 0.0;
            Vec3 before = Vec3::Zero();
            for (std::size_t leg = 1; leg < places.size(); ++leg) {
                const Vec3 from = places[leg - 1];
                const Vec3 to = places[leg];
                const int steps = static_cast<int>((to - from).norm() / 1e-5) + 1;
                for (int i = 1; i <= steps; ++i) {
                    const Vec3 force =
                        contact.respond(toolAt(from + (to - from) * (static_cast<double>(i) / steps)), touch)
                            .force;
                    work_J -= 0.5 * (force + before).dot((to - from) / steps);
                    before = force;
                }
            }
            worst_J = std::min(worst_J, work_J);
            std::reverse(places.begin(), places.end());
        }
    }
    qInfo("least work %.3f µJ", 1e6 * worst_J);
    QVERIFY2(worst_J >= -1e-6, qPrintable(QString::number(1e6 * worst_J)));
}

// models.md §8: the force never passes the yield force, falls over the stated time by the stated curve, and
// is back only after the tool was outside.
void TestTissueReach::tissueGivesWayOnce() {
    TissueYield tissue(YieldLaw{6.0, 0.020});
    QCOMPARE(tissue.step(6.0, false, 1e-3), 1.0);
    QVERIFY(!tissue.yielded());
    double before_N = 6.0;
    for (int ms = 0; ms <= 20; ++ms) {
        const double wanted_N = 6.5 + 3.0 * ms; // pressed on
        const double left_N = wanted_N * tissue.step(wanted_N, false, 1e-3);
        const double x = ms / 20.0;
        QVERIFY(std::abs(left_N - 6.0 * (1.0 - x * x * (3.0 - 2.0 * x))) < 1e-9);
        QVERIFY(left_N <= before_N + 1e-12 && before_N - left_N <= 1.5 * 6.0 / 20.0 + 1e-9);
        QCOMPARE(tissue.yielded(), ms == 0);
        QVERIFY(tissue.through());
        before_N = left_N;
    }
    QCOMPARE(tissue.step(2.0, false, 1e-3), 0.0); // still within
    QCOMPARE(tissue.step(0.0, true, 1e-3), 1.0);  // out
    QVERIFY(!tissue.through());
    QCOMPARE(tissue.step(5.0, false, 1e-3), 1.0);
    TissueYield never;
    QCOMPARE(never.step(1e6, false, 1e-3), 1.0);
}

QTEST_APPLESS_MAIN(TestTissueReach)
#include "test_tissue_reach.moc"
