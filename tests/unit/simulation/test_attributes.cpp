// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/attributes/bristle_friction.h"
#include "simulation/attributes/contact_damping.h"
#include "simulation/attributes/coulomb_friction.h"
#include "simulation/attributes/dimple.h"
#include "simulation/attributes/elasticity.h"
#include "simulation/attributes/stiffness_field.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

constexpr double kTick = 0.001;

/// One axis of the default hand on the tool (models.md §4: hand 0.3 kg, 6 N·s/m, 300 N/m; device 0.15 kg, 0.5
/// N·s/m): it pulls the tool towards `target`; friction answers once a millisecond and acts one tick later,
/// held.
struct HandOnAxis {
    double x = 0.0;
    double v = 0.0;

    void millisecond(double target, double friction) {
        const double mass = 0.45;
        const int substeps = 8;
        for (int i = 0; i < substeps; ++i) {
            const double h = kTick / substeps;
            v += h * (300.0 * (target - x) - 6.5 * v + friction) / mass;
            x += h * v;
        }
    }
};

/// Runs the hand against a friction law f(x, v); returns the applied force of every tick.
std::vector<double> rub(HandOnAxis& hand, int ticks, const std::function<double(int)>& target,
                        const std::function<double(double, double)>& law) {
    std::vector<double> forces;
    double applied = 0.0;
    for (int n = 0; n < ticks; ++n) {
        const double next = law(hand.x, hand.v);
        hand.millisecond(target(n), applied);
        applied = next;
        forces.push_back(applied);
    }
    return forces;
}

int signChanges(const std::vector<double>& forces, std::size_t from) {
    int changes = 0;
    for (std::size_t n = from + 1; n < forces.size(); ++n)
        changes += forces[n] * forces[n - 1] < 0.0 ? 1 : 0;
    return changes;
}

} // namespace

class TestAttributes : public QObject {
    Q_OBJECT
private slots:
    void elasticForceIsMinusGradient();
    void stiffnessFieldStaysInItsRange();
    void stiffnessGradientMatchesDifferences();
    void dimpleIsSmoothAndLocal();
    void dampingIsWeightedAndNeverPulls();
    void coulombHasPublishedForm();
    void regularisationVelocityIsTheLargestOfThree();
    void regularisationKeepsSampledLoopQuiet();
    void bristleIsNeverActive();
    void bristleSlidesAtMuN();
    void bristleSticksForTenSeconds();
    void bristleDoesNotCreep();
    void bristleFollowsTheSurface();
    void releaseForgets();
};

void TestAttributes::elasticForceIsMinusGradient() {
    const Vec3 f = Elasticity::force(500.0, core::Vec2(2000.0, -1000.0), 0.004, -Vec3::UnitZ());
    QVERIFY((f - Vec3(-0.016, 0.008, 2.0)).norm() < 1e-15); // k d up, −½ ∇k d² sideways
    QCOMPARE(Elasticity::energy(500.0, 0.004), 0.004);
    QCOMPARE(Elasticity::force(500.0, core::Vec2(1.0, 1.0), 0.0, -Vec3::UnitZ()).norm(), 0.0);
}

void TestAttributes::stiffnessFieldStaysInItsRange() {
    const StiffnessField field{800.0, 0.5, 0.030, core::Vec2(0.3, -1.1)};
    core::Random random(1);
    double lowest = 1e9;
    double highest = 0.0;
    for (int n = 0; n < 100000; ++n) {
        const double k = field.sample(random.uniform(-0.07, 0.07), random.uniform(-0.07, 0.07)).value_N_per_m;
        lowest = std::min(lowest, k);
        highest = std::max(highest, k);
    }
    QVERIFY(lowest >= 400.0 && lowest < 404.0);
    QVERIFY(highest <= 1200.0 && highest > 1196.0);
    const StiffnessSample uniform =
        StiffnessField{650.0, 0.0, 0.030, core::Vec2(0.3, 0.2)}.sample(0.01, 0.02);
    QCOMPARE(uniform.value_N_per_m, 650.0);
    QCOMPARE(uniform.gradient_N_per_m2.norm(), 0.0);
}

void TestAttributes::stiffnessGradientMatchesDifferences() {
    const StiffnessField field{800.0, 0.5, 0.030, core::Vec2(0.3, -1.1)};
    core::Random random(2);
    const double h = 1e-6;
    for (int n = 0; n < 1000; ++n) {
        const double x = random.uniform(-0.07, 0.07);
        const double y = random.uniform(-0.07, 0.07);
        const core::Vec2 numeric(
            (field.sample(x + h, y).value_N_per_m - field.sample(x - h, y).value_N_per_m) / (2 * h),
            (field.sample(x, y + h).value_N_per_m - field.sample(x, y - h).value_N_per_m) / (2 * h));
        // third derivative a k₀/2 κ³ times h²/6, and rounding of 800 N/m over 2 µm
        QVERIFY((numeric - field.sample(x, y).gradient_N_per_m2).norm() < 1e-3);
    }
}

void TestAttributes::dimpleIsSmoothAndLocal() {
    const Dimple dimple{0.001, 0.006, core::Vec2(0.01, 0.02)};
    QCOMPARE(dimple.sample(0.01, 0.02).height_m, -0.001);
    QCOMPARE(dimple.sample(0.01, 0.02).gradient.norm(), 0.0);
    QCOMPARE(dimple.sample(0.0161, 0.02).height_m, 0.0);
    QVERIFY(std::abs(dimple.sample(0.01 + 0.006 * std::sqrt(0.5), 0.02).height_m + 0.00025) <
            1e-15); // −D(1−½)²
    const double h = 1e-7;
    double steepest = 0.0;
    for (double s = -0.007; s < 0.007; s += 1e-5) {
        const double numeric =
            (dimple.sample(0.01 + s + h, 0.02).height_m - dimple.sample(0.01 + s - h, 0.02).height_m) /
            (2 * h);
        const double exact = dimple.sample(0.01 + s, 0.02).gradient.x();
        QVERIFY(std::abs(numeric - exact) < 1e-4); // 8D/w² · h at the edge, where the curvature steps
        steepest = std::max(steepest, std::abs(exact));
    }
    QVERIFY(std::abs(steepest - 8.0 / (3.0 * std::sqrt(3.0)) * 0.001 / 0.006) < 1e-5);
    QCOMPARE(Dimple{}.sample(0.0, 0.0).height_m, 0.0);
}

void TestAttributes::dampingIsWeightedAndNeverPulls() {
    QCOMPARE(ContactDamping::normalForce(1.0, 2.0, 0.002, 0.0), 1.0);
    QCOMPARE(ContactDamping::normalForce(1.0, 2.0, 0.002, -0.25), 1.5);
    QCOMPARE(ContactDamping::normalForce(1.0, 2.0, 0.00025, -0.25), 1.25);
    QCOMPARE(ContactDamping::normalForce(0.0, 2.0, 0.0, -0.25), 0.0);
    QCOMPARE(ContactDamping::normalForce(1.0, 2.0, 0.002, 10.0), 0.0);
}

void TestAttributes::coulombHasPublishedForm() {
    QVERIFY(std::abs(CoulombFriction::force(0.3, 2.0, 0.003, 0.004) + 0.6 * 0.6) < 1e-15); // 3-4-5
    QCOMPARE(CoulombFriction::force(0.3, 2.0, 0.0, 0.001), 0.0);
    QCOMPARE(CoulombFriction::force(0.3, 2.0, -0.01, 0.001), -CoulombFriction::force(0.3, 2.0, 0.01, 0.001));
    core::Random random(3);
    for (int n = 0; n < 10000; ++n) {
        const double v = random.uniform(-1.0, 1.0);
        const double f = CoulombFriction::force(0.3, 2.0, v, 0.001);
        QVERIFY(std::abs(f) <= 0.6);
        QVERIFY(f * v <= 0.0); // never positive work
    }
}

void TestAttributes::regularisationVelocityIsTheLargestOfThree() {
    QCOMPARE(CoulombFriction::regularisationVelocity(0.0, 0.0, 0.0), 0.001);
    QCOMPARE(CoulombFriction::regularisationVelocity(0.0, 0.0, 50e-6), 50e-6 / 0.015);
    QCOMPARE(CoulombFriction::regularisationVelocity(0.5, 4.0, 50e-6), 0.04); // 2 N / 50 N·s/m
    QCOMPARE(CoulombFriction::regularisationVelocity(0.5, 4.0, 50e-6, 1000.0), 50e-6 / 0.015);
}

// models.md §0: "1 mm/s alone chatters at ±μN in a sampled loop with one tick of delay"; with μN/b_max it
// does not.
void TestAttributes::regularisationKeepsSampledLoopQuiet() {
    const double mu = 0.5;
    const double normal = 4.0;
    const auto target = [](int n) { return n < 200 ? 0.0 : 0.0005; };
    const auto chatterWith = [&](double v0) {
        HandOnAxis hand;
        return signChanges(rub(hand, 10000, target,
                               [&](double, double v) { return CoulombFriction::force(mu, normal, v, v0); }),
                           2000);
    };
    QVERIFY2(chatterWith(0.001) > 1000, qPrintable(QString::number(chatterWith(0.001))));
    QCOMPARE(chatterWith(CoulombFriction::regularisationVelocity(mu, normal, 10e-6)), 0);
}

// Over any motion with any normal force: what was put in is at least what the bristle holds.
void TestAttributes::bristleIsNeverActive() {
    core::Random random(4);
    for (int run = 0; run < 100; ++run) {
        BristleFriction bristle;
        Vec3 p = Vec3::Zero();
        double work = 0.0;
        for (int n = 0; n < 2000; ++n) {
            const Vec3 step = random.uniform(0.0, 0.002) *
                              Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            const double normalForce = random.below(5) == 0 ? 0.0 : random.uniform(0.0, 4.0);
            const Vec3 normal = Vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1.0).normalized();
            p += step;
            const Vec3 f = bristle.update(p, normal, normalForce, 0.5, 1000.0);
            QVERIFY(f.norm() <= 0.5 * normalForce * (1.0 + 1e-12) + 1e-15);
            QVERIFY(std::abs(f.dot(normal)) < 1e-12);
            if (n > 0)
                work -= f.dot(step); // the force answered to this step; first call only grips
            QVERIFY(work >= 0.5 * 1000.0 * bristle.stretch().squaredNorm() - 1e-12);
        }
        QVERIFY(work > 0.0);
    }
}

void TestAttributes::bristleSlidesAtMuN() {
    BristleFriction bristle;
    double force = 0.0;
    for (int n = 0; n <= 100; ++n)
        force = bristle.update(Vec3(n * 1e-4, 0, 0), Vec3::UnitZ(), 2.0, 0.3, 1000.0).x();
    QVERIFY(std::abs(force + 0.6) < 1e-12);
    // before it slides it is a spring of σ₀: 0.2 mm · 1000 N/m
    BristleFriction spring;
    spring.update(Vec3::Zero(), Vec3::UnitZ(), 2.0, 0.3, 1000.0);
    QVERIFY(std::abs(spring.update(Vec3(0, 2e-4, 0), Vec3::UnitZ(), 2.0, 0.3, 1000.0).y() + 0.2) < 1e-12);
}

void TestAttributes::bristleSticksForTenSeconds() {
    HandOnAxis hand;
    BristleFriction bristle;
    // pulled with 300 N/m · 2 mm = 0.6 N against μN = 1.2 N, after a slide of 10 mm
    double rest = 0.0;
    const auto pull = [&](int n) {
        if (n < 1000)
            return 0.012 * n / 1000.0;
        if (n == 1000)
            rest = hand.x + 0.002;
        return rest;
    };
    std::vector<double> places;
    const auto forces = rub(hand, 13000, pull, [&](double x, double) {
        places.push_back(x);
        return bristle.update(Vec3(x, 0, 0), Vec3::UnitZ(), 4.0, 0.3, 1000.0).x();
    });
    const auto [low, high] = std::minmax_element(places.begin() + 3000, places.end());
    QVERIFY2(*high - *low < 1e-6, qPrintable(QString::number(*high - *low)));
    QCOMPARE(signChanges(forces, 3000), 0);
    QVERIFY(std::abs(forces.back()) > 0.3 && std::abs(forces.back()) < 1.2); // holding, not sliding
}

void TestAttributes::bristleDoesNotCreep() {
    HandOnAxis hand;
    BristleFriction bristle;
    // mean pull 0.6 N ± 0.45 N at 2 Hz, always below μN = 1.2 N: 100 cycles
    const auto target = [](int n) { return 0.0020 + 0.0015 * std::sin(2.0 * core::kPi * n / 500.0); };
    std::vector<double> places;
    rub(hand, 50000, target, [&](double x, double) {
        places.push_back(x);
        return bristle.update(Vec3(x, 0, 0), Vec3::UnitZ(), 4.0, 0.3, 1000.0).x();
    });
    QVERIFY2(std::abs(places[49999] - places[4999]) < 1e-6,
             qPrintable(QString::number(places[49999] - places[4999])));
    const auto [low, high] = std::minmax_element(places.end() - 500, places.end());
    QVERIFY(*high - *low > 1e-4); // it did move to and fro
}

void TestAttributes::bristleFollowsTheSurface() {
    BristleFriction bristle;
    bristle.update(Vec3::Zero(), Vec3::UnitZ(), 4.0, 0.3, 1000.0);
    const Vec3 flat = bristle.update(Vec3(0.0005, 0, 0), Vec3::UnitZ(), 4.0, 0.3, 1000.0);
    QVERIFY(std::abs(flat.norm() - 0.5) < 1e-12);
    const Vec3 tilted = bristle.update(Vec3(0.0005, 0, 0), Vec3(0.6, 0, 0.8), 4.0, 0.3, 1000.0);
    QVERIFY(std::abs(tilted.norm() - 0.4) < 1e-12); // projected: shrinks, never grows
    QVERIFY(std::abs(tilted.dot(Vec3(0.6, 0, 0.8))) < 1e-15);
    // moving along the normal stretches nothing
    BristleFriction pressed;
    pressed.update(Vec3::Zero(), Vec3::UnitZ(), 4.0, 0.3, 1000.0);
    QCOMPARE(pressed.update(Vec3(0, 0, -0.003), Vec3::UnitZ(), 4.0, 0.3, 1000.0).norm(), 0.0);
}

void TestAttributes::releaseForgets() {
    BristleFriction bristle;
    bristle.update(Vec3::Zero(), Vec3::UnitZ(), 4.0, 0.3, 1000.0);
    bristle.update(Vec3(0.0005, 0, 0), Vec3::UnitZ(), 4.0, 0.3, 1000.0);
    bristle.release();
    QVERIFY(!bristle.touching());
    QCOMPARE(bristle.update(Vec3(0.05, 0, 0), Vec3::UnitZ(), 4.0, 0.3, 1000.0).norm(), 0.0);
}

QTEST_APPLESS_MAIN(TestAttributes)
#include "test_attributes.moc"
