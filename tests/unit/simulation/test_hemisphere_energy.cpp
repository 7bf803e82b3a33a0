// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_laws.h"
#include "core/fp_environment.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::Vec3;

namespace {

constexpr double kLoopTolerance_J = 1e-6; // models.md §0: every loop and its reverse ≥ −1 µJ

} // namespace

class TestHemisphereEnergy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void forceIsMinusGradientOfEnergy();
    void loopsMakeNoEnergy_data();
    void loopsMakeNoEnergy();
    void cappedByItsLoadItMakesNoEnergy();
    void stiffLumpMakesNoEnergy();
    void frictionAndDampingAlwaysAbsorb();
};

void TestHemisphereEnergy::forceIsMinusGradientOfEnergy() {
    auto law = everything();
    law.damping_Ns_per_m = 0.0;
    const HemisphereContact contact(law);
    core::Random random(5);
    const double h = 1e-6;
    const double slope = forceSlopeBound(law, 0.010);
    for (int n = 0; n < 50000; ++n) {
        const Vec3 p = randomSurfacePoint(random, law.surface) + randomVector(random, 0.004);
        const auto here = contact.respond(p, Vec3::Zero());
        Vec3 force;
        for (int axis = 0; axis < 3; ++axis)
            force[axis] = -(contact.respond(p + h * Vec3::Unit(axis), Vec3::Zero()).energy_J -
                            contact.respond(p - h * Vec3::Unit(axis), Vec3::Zero()).energy_J) /
                          (2 * h);
        QVERIFY((force - here.force).norm() <=
                slope * h * std::sqrt(3.0) + 1e-8); // mean value theorem, an axis each
    }
}

void TestHemisphereEnergy::loopsMakeNoEnergy_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("plain") << 0;
    QTest::newRow("varied stiffness") << 1;
    QTest::newRow("dimple") << 2;
    QTest::newRow("both") << 3;
}

void TestHemisphereEnergy::loopsMakeNoEnergy() {
    QFETCH(int, which);
    const auto law = which == 0   ? plainParameters()
                     : which == 1 ? variedParameters()
                     : which == 2 ? dimpledParameters()
                                  : everything();
    const Force force = elasticForce(law);
    core::Random random(6);
    double exchanged = 0.0;
    double normalOnly = 0.0; // the same without its lateral parts, to show that the loops can tell
    const auto withoutLateral = [&](const Vec3& p) -> Vec3 {
        const auto r = HemisphereContact(law).respond(p, Vec3::Zero());
        return r.stiffness_N_per_m * r.depth_m * law.surface.distance(p).normal;
    };
    for (int n = 0; n < 60; ++n) {
        auto loop = randomLoop(random, randomSurfacePoint(random, law.surface), 0.005, 8000);
        const double forward = workIn(loop, force);
        QVERIFY2(forward >= -kLoopTolerance_J, qPrintable(QString::number(forward)));
        normalOnly = std::min(normalOnly, workIn(loop, withoutLateral));
        for (const Vec3& p : loop)
            exchanged = std::max(exchanged, HemisphereContact(law).respond(p, Vec3::Zero()).energy_J);
        std::reverse(loop.begin(), loop.end());
        const double backward = workIn(loop, force);
        QVERIFY2(backward >= -kLoopTolerance_J, qPrintable(QString::number(backward)));
        normalOnly = std::min(normalOnly, workIn(loop, withoutLateral));
    }
    QVERIFY2(exchanged > 1e-3, qPrintable(QString::number(exchanged)));
    if (which > 0)
        QVERIFY2(normalOnly < -10.0 * kLoopTolerance_J, qPrintable(QString::number(normalOnly)));
}

// A force that is capped along its own direction is a potential's only where the cap follows from the energy:
// over the decoy's dimple a cap on ‖f‖ makes energy, a cap on what the contact says its load is does not.
void TestHemisphereEnergy::cappedByItsLoadItMakesNoEnergy() {
    auto law = plainParameters();
    law.dimple = {0.002, 0.006, law.surface.centre_m + core::Vec2(0.010, 0.0)}; // as sphere_apex level 4
    law.damping_Ns_per_m = 0.0;
    const HemisphereContact contact(law);
    constexpr double kCap_N = 1.0;
    const Force byLoad = [&](const Vec3& p) -> Vec3 {
        const auto r = contact.respond(p, Vec3::Zero());
        return std::min(1.0, kCap_N / std::max({1e-12, r.load_N, r.force.norm()})) * r.force;
    };
    const Force byForce = [&](const Vec3& p) -> Vec3 {
        const Vec3 f = contact.respond(p, Vec3::Zero()).force;
        return std::min(1.0, kCap_N / std::max(1e-12, f.norm())) * f;
    };
    core::Random random(8);
    double made = 0.0;
    for (int n = 0; n < 40; ++n) {
        const core::Vec2 at =
            law.dimple.centre_m + core::Vec2(random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004));
        const core::Vec2 off = at - law.surface.centre_m;
        const Vec3 top(at.x(), at.y(),
                       std::sqrt(law.surface.radius_m * law.surface.radius_m - off.squaredNorm()) - 0.002);
        auto loop = randomLoop(random, top, 0.0025, 8000);
        for (int direction = 0; direction < 2; ++direction) {
            const double work = workIn(loop, byLoad);
            QVERIFY2(work >= -kLoopTolerance_J, qPrintable(QString::number(work)));
            made = std::min(made, workIn(loop, byForce));
            std::reverse(loop.begin(), loop.end());
        }
        for (const Vec3& p : loop) {
            const auto r = contact.respond(p, Vec3::Zero());
            QVERIFY(r.force.norm() <= r.load_N * (1.0 + 1e-9));
        }
    }
    QVERIFY2(made < -20.0 * kLoopTolerance_J, qPrintable(QString::number(made)));
    QCOMPARE(HemisphereContact(plainParameters())
                 .respond(law.surface.radius_m * 0.9 * Vec3::UnitZ(), Vec3::Zero())
                 .load_N,
             0.0);
}

void TestHemisphereEnergy::stiffLumpMakesNoEnergy() {
    auto law = plainParameters();
    law.stiffness = {800.0, 0.5, 0.040, core::Vec2::Zero()};
    const HemisphereContact contact(law);
    // sin = −1 at −λ/4 and +1 at +λ/4, seen where the plane is flat: one wavelength further out
    const Vec3 soft(0.050 - 0.020, 0.050 - 0.020, 0.0);
    const Vec3 stiff(0.050, 0.050, 0.0);
    const Vec3 down(0, 0, -0.004);
    auto loop = polygon({soft, soft + down, stiff + down, stiff, soft}, 4000);
    QVERIFY(std::abs(contact.respond(soft + down, Vec3::Zero()).stiffness_N_per_m - 400.0) < 1e-9);
    QVERIFY(std::abs(contact.respond(stiff + down, Vec3::Zero()).stiffness_N_per_m - 1200.0) < 1e-9);
    const Force normalOnly = [&](const Vec3& p) -> Vec3 {
        const auto r = contact.respond(p, Vec3::Zero());
        return r.stiffness_N_per_m * r.depth_m * Vec3::UnitZ();
    };
    const double made = -workIn(loop, normalOnly);
    QVERIFY2(std::abs(made - 0.0064) < 1e-5, qPrintable(QString::number(made)));
    const double ours = workIn(loop, elasticForce(law));
    QVERIFY2(std::abs(ours) < kLoopTolerance_J, qPrintable(QString::number(ours)));
    std::reverse(loop.begin(), loop.end());
    QVERIFY(std::abs(workIn(loop, elasticForce(law))) < kLoopTolerance_J);
}

void TestHemisphereEnergy::frictionAndDampingAlwaysAbsorb() {
    const auto law = everything();
    const HemisphereContact contact(law);
    core::Random random(7);
    int costly = 0;
    for (int n = 0; n < 40; ++n) {
        auto loop = randomLoop(random, randomSurfacePoint(random, law.surface), 0.004, 8000);
        for (int direction = 0; direction < 2; ++direction) {
            BristleFriction bristle;
            auto before = contact.respond(loop.front(), Vec3::Zero(), bristle);
            const double held = before.energy_J;
            double work = 0.0;
            for (std::size_t i = 1; i < loop.size(); ++i) {
                const Vec3 moved = loop[i] - loop[i - 1];
                const auto now = contact.respond(loop[i], moved / 0.00025, bristle); // 2 s a loop
                work -= 0.5 * (before.force + now.force).dot(moved);
                QVERIFY2(work >= now.energy_J - held - kLoopTolerance_J, qPrintable(QString::number(work)));
                before = now;
            }
            costly += work > 1e-4 ? 1 : 0;
            std::reverse(loop.begin(), loop.end());
        }
    }
    QVERIFY2(costly > 30, qPrintable(QString::number(costly)));
}

QTEST_APPLESS_MAIN(TestHemisphereEnergy)
#include "test_hemisphere_energy.moc"
