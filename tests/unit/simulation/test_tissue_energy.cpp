// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "tissue_laws.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {
constexpr double kLoopTolerance_J = 1e-6; // models.md §0: every loop and its reverse ≥ −1 µJ
constexpr double kDepth = 0.004;

TissueParameters potential(int which) {
    TissueParameters p = which % 2 == 0 ? quietPad() : quietDome();
    p.regions = {harderRegion()};
    if (which / 2 == 1)
        p.lumps = LumpLaw::secondSurface;
    return p;
}

void potentials() {
    QTest::addColumn<int>("which");
    QTest::newRow("inclusion, flat") << 0;
    QTest::newRow("inclusion, furrowed dome") << 1;
    QTest::newRow("second surface, flat") << 2;
    QTest::newRow("second surface, furrowed dome") << 3;
}

/// Press beside a lump, slide over it, lift; `back`: the other way round.
std::vector<Vec3> pressSlideLift(const TissueContact& contact, double depth_m, bool back, int steps) {
    const Vec2 from(-0.020, 0.003), to(0.001, -0.001);
    std::vector<Vec3> path;
    const auto piece = [&](const auto& place) {
        for (int i = 0; i < steps; ++i)
            path.push_back(place(static_cast<double>(i) / steps));
    };
    const auto at = [&](double s) { return Vec2(from + s * (to - from)); };
    piece([&](double s) { return under(contact, from, s * (depth_m + 0.001) - 0.001); });
    piece([&](double s) { return under(contact, at(s), depth_m); });
    piece([&](double s) { return under(contact, to, depth_m - s * (depth_m + 0.001)); });
    piece([&](double s) { return under(contact, at(1.0 - s), -0.001); });
    path.push_back(path.front());
    if (back)
        std::reverse(path.begin(), path.end());
    return path;
}
} // namespace

class TestTissueEnergy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void forceIsMinusGradientOfEnergy_data() { potentials(); }
    void forceIsMinusGradientOfEnergy();
    void forceIsMinusGradientBeyondTheLumpsLaw();
    void pressSlideLiftMakesNothing_data() { potentials(); }
    void pressSlideLiftMakesNothing();
    void randomLoopsMakeNothing_data() { potentials(); }
    void randomLoopsMakeNothing();
    void frictionAndDampingOnlyTake_data() { potentials(); }
    void frictionAndDampingOnlyTake();
    void bristleKeepsItsBooksOnTheDome();
    void publishedVariantsMakeEnergy();
};

void TestTissueEnergy::forceIsMinusGradientOfEnergy() {
    QFETCH(int, which);
    const TissueContact contact = contactOf(potential(which));
    core::Random random(2);
    double worst = 0.0;
    constexpr double h = 2e-7;
    for (int n = 0; n < 4000; ++n) {
        const Vec3 p = randomUnder(random, contact, 0.030, 0.006);
        const TissueResponse here = pressAt(contact, p);
        if (here.depth_m < 1e-6)
            continue;
        Vec3 slope;
        for (int axis = 0; axis < 3; ++axis)
            slope[axis] = (pressAt(contact, p + h * Vec3::Unit(axis)).energy_J -
                           pressAt(contact, p - h * Vec3::Unit(axis)).energy_J) /
                          (2 * h);
        worst = std::max(worst, (here.force + slope).norm());
    }
    // Central differences: a sixth of the third derivative times h² is far below the rounding of U, 1e-18 J /
    // h.
    QVERIFY2(worst < (which < 2 ? 1e-7 : 1e-4), qPrintable(QString::number(worst)));
}

// From 9 mm on these lumps' law changes, since the finger sinks no farther towards them (λ d ≤ (h − R)/2).
// The force is still minus the gradient of the energy.
void TestTissueEnergy::forceIsMinusGradientBeyondTheLumpsLaw() {
    const TissueContact contact = contactOf(quietPad());
    core::Random random(8);
    double worst = 0.0;
    constexpr double h = 2e-7;
    for (int n = 0; n < 4000; ++n) {
        const Vec3 p(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03),
                     -random.uniform(0.0095, 0.030));
        const TissueResponse here = pressAt(contact, p);
        QVERIFY(here.beyondChecked);
        Vec3 slope;
        for (int axis = 0; axis < 3; ++axis)
            slope[axis] = (pressAt(contact, p + h * Vec3::Unit(axis)).energy_J -
                           pressAt(contact, p - h * Vec3::Unit(axis)).energy_J) /
                          (2 * h);
        worst = std::max(worst, (here.force + slope).norm());
    }
    QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
}

void TestTissueEnergy::pressSlideLiftMakesNothing() {
    QFETCH(int, which);
    const TissueContact contact = contactOf(potential(which));
    for (const bool back : {false, true}) {
        const PathBooks books = walk(contact, pressSlideLift(contact, kDepth, back, 20000));
        QVERIFY2(std::abs(books.work_J) < kLoopTolerance_J, qPrintable(QString::number(books.work_J)));
        QVERIFY(books.mostHeld_J > 1e-3);
    }
}

void TestTissueEnergy::randomLoopsMakeNothing() {
    QFETCH(int, which);
    const TissueContact contact = contactOf(potential(which));
    core::Random random(6);
    double most = 0.0;
    for (int n = 0; n < 60; ++n) {
        auto loop = randomLoop(random, randomUnder(random, contact, 0.02, 0.003), 0.006, 8000);
        for (int direction = 0; direction < 2; ++direction) {
            const PathBooks books = walk(contact, loop);
            QVERIFY2(std::abs(books.work_J) < kLoopTolerance_J, qPrintable(QString::number(books.work_J)));
            most = std::max(most, books.mostHeld_J);
            std::reverse(loop.begin(), loop.end());
        }
    }
    QVERIFY(most > 2e-3);
}

void TestTissueEnergy::frictionAndDampingOnlyTake() {
    QFETCH(int, which);
    TissueParameters p = potential(which);
    p.friction = 0.3;
    p.damping_Ns_per_m = Vec3(2.0, 2.0, 2.0);
    const TissueContact contact = contactOf(p);
    core::Random random(7);
    int costly = 0;
    for (int n = 0; n < 40; ++n) {
        auto loop = n == 0 ? pressSlideLift(contact, kDepth, false, 4000)
                           : randomLoop(random, randomUnder(random, contact, 0.02, 0.003), 0.005, 8000);
        for (int direction = 0; direction < 2; ++direction) {
            const PathBooks books = walk(contact, loop, 0.00025);
            QVERIFY2(books.lead_J >= -kLoopTolerance_J, qPrintable(QString::number(books.lead_J)));
            costly += books.work_J > 1e-4 ? 1 : 0;
            std::reverse(loop.begin(), loop.end());
        }
    }
    QVERIFY2(costly > 30, qPrintable(QString::number(costly)));
}

// The frame turns while the finger goes round the dome: a bristle kept in W would be cut by every projection,
// one kept in the frame gives back what it took.
void TestTissueEnergy::bristleKeepsItsBooksOnTheDome() {
    TissueParameters p = quietDome();
    p.friction = 50.0; // never slips
    const TissueContact contact = contactOf(p, {});
    std::vector<Vec3> path;
    for (int i = 0; i <= 40000; ++i) {
        const double s = 2.0 * core::kPi * i / 40000;
        path.push_back(under(contact, Vec2(0.006 * std::sin(s), 0.004 * std::sin(2.0 * s)), 0.003));
    }
    const PathBooks books = walk(contact, path);
    QVERIFY2(books.lead_J >= -kLoopTolerance_J, qPrintable(QString::number(books.lead_J)));
    QVERIFY(books.mostHeld_J > 1e-2);
}

void TestTissueEnergy::publishedVariantsMakeEnergy() {
    // 400 → 1200 N/m at 4 mm as stiffness × depth: ½ · 800 N/m · (4 mm)² = 6.4 mJ a loop (models.md §0); with
    // its potential nothing.
    TissueParameters p = quietPad();
    p.stiffness_N_per_m = 400.0;
    p.regions = {{"lump", Vec2(0, 0), Vec2(0.015, 0.015), 0.0, 2.0}};
    const Vec3 soft(-0.03, 0, 0), stiff(0, 0, 0), down(0, 0, -kDepth);
    const auto loop = polygon({soft, soft + down, stiff + down, stiff, soft}, 4000);
    auto reverse = loop;
    std::reverse(reverse.begin(), reverse.end());
    QVERIFY(std::abs(walk(contactOf(p, {}), loop).work_J) < kLoopTolerance_J);
    p.lumps = LumpLaw::stiffnessTimesDepth;
    QVERIFY(std::abs(walk(contactOf(p, {}), loop).work_J + 0.0064) < 1e-5);
    QVERIFY(std::abs(walk(contactOf(p, {}), reverse).work_J - 0.0064) <
            1e-5); // the other way it takes as much

    // A ray 30° off the normal, re-cast each tick: 800 N/m · 4 mm · tan 30° over 15 mm = 27.7 mJ.
    TissueParameters q = quietPad();
    q.contact = TissueContactLaw::p3Recast;
    const TissueContact recast = contactOf(q, {});
    double work = 0.0;
    const auto slide =
        polygon({Vec3(0, 0, 0), down, down + Vec3(0.015, 0, 0), Vec3(0.015, 0, 0), Vec3(0, 0, 0)}, 4000);
    TissueTouch touch;
    Vec3 before = Vec3::Zero();
    for (std::size_t i = 0; i < slide.size(); ++i) {
        core::ToolState tool = toolAt(slide[i]);
        tool.q_WT = core::Quat(Eigen::AngleAxisd(core::kPi / 6.0, Vec3::UnitY()));
        const Vec3 now = recast.respond(tool, touch).force;
        if (i > 0)
            work -= 0.5 * (before + now).dot(slide[i] - slide[i - 1]);
        before = now;
    }
    QVERIFY2(std::abs(work + 0.0277) < 1e-4, qPrintable(QString::number(work)));
}

QTEST_APPLESS_MAIN(TestTissueEnergy)
#include "test_tissue_energy.moc"
