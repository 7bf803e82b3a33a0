// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/attributes/elasticity.h"
#include "simulation/attributes/mass.h"
#include "simulation/attributes/viscosity.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

bool near(double a, double b, double relative) {
    return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

/// The law without care for rounding, in long double.
long double tensionOf(long double k, long double b, long double x) {
    return b == 0.0L ? k * x : k / b * std::expm1(b * x);
}
long double energyOf(long double k, long double b, long double x) {
    if (std::abs(b * x) < 1e-3L) { // eight terms are beyond long double here
        long double term = 0.5L * k * x * x;
        long double sum = 0.0L;
        for (int n = 2; n < 10; ++n, term *= b * x / static_cast<long double>(n))
            sum += term;
        return sum;
    }
    return k / (b * b) * (std::expm1(b * x) - b * x);
}

} // namespace

class TestAttributeLaws : public QObject {
    Q_OBJECT
private slots:
    void springIsItsClosedForm();
    void limitOfNoStiffeningIsExact();
    void stiffeningNeverOverflows();
    void slopeAndTensionAreDerivatives();
    void tensionIsAPotential();
    void liftingCostsWeightTimesHeight();
    void inertiaOpposesAcceleration();
    void viscosityOpposesAndFadesIn();
};

void TestAttributeLaws::springIsItsClosedForm() {
    core::Random random(1);
    for (int n = 0; n < 20000; ++n) {
        const double k = random.uniform(1.0, 2000.0);
        const double b = random.uniform(0.0, 300.0);
        const double x = random.uniform(-0.05, 0.05);
        const ElasticLaw law{k, b};
        QVERIFY(near(law.tension(x), static_cast<double>(tensionOf(k, b, x)), 1e-14));
        QVERIFY2(near(law.energy(x), static_cast<double>(energyOf(k, b, x)), 2e-14),
                 qPrintable(QString("%1 %2 %3")
                                .arg(b * x)
                                .arg(law.energy(x))
                                .arg(static_cast<double>(energyOf(k, b, x)))));
        QVERIFY(near(law.slope(x), k * std::exp(b * x), 1e-14));
    }
    QCOMPARE((ElasticLaw{500.0, 0.0}.tension(0.003)), 1.5);
    QCOMPARE((ElasticLaw{500.0, 0.0}.energy(0.003)), 0.00225);
    QCOMPARE((ElasticLaw{500.0, 80.0}.tension(0.0)), 0.0);
}

void TestAttributeLaws::limitOfNoStiffeningIsExact() {
    for (const double x : {1e-9, 1e-3, 0.05})
        for (double b = 1e-300; b < 1e-3; b *= 1e10) {
            const ElasticLaw law{350.0, b};
            const double u = b * x;
            QVERIFY(near(law.tension(x), 350.0 * x * (1.0 + 0.5 * u), 1e-15));
            QVERIFY(near(law.energy(x), 175.0 * x * x * (1.0 + u / 3.0), 1e-15));
        }
    // no seam where the series ends
    const ElasticLaw law{350.0, 10.0};
    const double seam = ElasticLaw::kSeriesBelow / 10.0;
    QVERIFY(near(law.tension(seam * (1 - 1e-15)), law.tension(seam * (1 + 1e-15)), 1e-14));
    QVERIFY(near(law.energy(seam * (1 - 1e-15)), law.energy(seam * (1 + 1e-15)), 2e-14));
}

void TestAttributeLaws::stiffeningNeverOverflows() {
    const ElasticLaw law{100.0, 200.0};
    const double end = ElasticLaw::kLargestExponent / 200.0;
    for (const double x : {0.1, 1.0, 1e3, 1e9})
        QVERIFY(std::isfinite(law.tension(x)) && std::isfinite(law.energy(x)) && std::isfinite(law.slope(x)));
    // straight beyond, with force, slope and energy going on from where they are
    QVERIFY(near(law.tension(end * (1 + 1e-12)), law.tension(end), 1e-10));
    QVERIFY(near(law.energy(end * (1 + 1e-12)), law.energy(end), 1e-10));
    const double over = 0.01;
    QVERIFY(near(law.tension(end + over), law.tension(end) + law.slope(end) * over, 1e-12));
    QVERIFY(near(law.energy(end + over),
                 law.energy(end) + law.tension(end) * over + 0.5 * law.slope(end) * over * over, 1e-12));
    QCOMPARE(law.slope(end + over), law.slope(end));
    QVERIFY(std::isfinite(law.tension(-1e9)) && near(law.tension(-1e9), -0.5, 1e-12)); // −k/b
}

void TestAttributeLaws::slopeAndTensionAreDerivatives() {
    core::Random random(2);
    for (int n = 0; n < 2000; ++n) {
        const ElasticLaw law{random.uniform(10.0, 1000.0), random.uniform(0.0, 300.0)};
        const double x = random.uniform(-0.02, 0.15); // beyond the cap too
        const double e = 1e-6 * std::max(1e-3, std::abs(x));
        QVERIFY(near((law.energy(x + e) - law.energy(x - e)) / (2 * e), law.tension(x), 1e-5) ||
                std::abs(x) < 1e-4);
        QVERIFY(near((law.tension(x + e) - law.tension(x - e)) / (2 * e), law.slope(x), 1e-5));
    }
}

// 10⁴ random closed paths along the line and their reverses make nothing.
void TestAttributeLaws::tensionIsAPotential() {
    core::Random random(3);
    double least = 0.0;
    for (int n = 0; n < 10000; ++n) {
        const ElasticLaw law{random.uniform(10.0, 1000.0),
                             random.below(2) == 0 ? 0.0 : random.uniform(0.0, 60.0)};
        double amplitude[3];
        double phase[3];
        for (int h = 0; h < 3; ++h) {
            amplitude[h] = random.uniform(0.0, 0.004);
            phase[h] = random.uniform(0.0, 2.0 * core::kPi);
        }
        const auto place = [&](int i) {
            double x = 0.01;
            for (int h = 0; h < 3; ++h)
                x += amplitude[h] * std::sin(2.0 * core::kPi * (h + 1) * i / 1000.0 + phase[h]);
            return x;
        };
        double work = 0.0;
        for (int i = 0; i < 1000; ++i)
            work += 0.5 * (law.tension(place(i)) + law.tension(place((i + 1) % 1000))) *
                    (place(i + 1) - place(i));
        least = std::min({least, work, -work});
    }
    QVERIFY2(least >= -1e-6, qPrintable(QString::number(least)));
}

// models.md §2.1: lifting by Δz costs m g Δz, along any way.
void TestAttributeLaws::liftingCostsWeightTimesHeight() {
    core::Random random(4);
    for (int n = 0; n < 100; ++n) {
        const double m = random.uniform(0.001, 0.1);
        Vec3 p = Vec3::Zero();
        double work = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 step(random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3),
                            random.uniform(-1e-3, 1.2e-3));
            work -= Mass::weight(m).dot(step);
            p += step;
        }
        QVERIFY2(std::abs(work - m * 9.80665 * p.z()) < 1e-9,
                 qPrintable(QString::number(work - m * 9.80665 * p.z())));
        QVERIFY(std::abs(Mass::energy(m, p.z()) - Mass::energy(m, 0.0) - work) < 1e-9);
    }
    QCOMPARE(Mass::weight(0.010).z(), -0.0980665); // P2's ovary
    QCOMPARE(Mass::weight(0.010).head<2>().norm(), 0.0);
}

void TestAttributeLaws::inertiaOpposesAcceleration() {
    QVERIFY((Mass::inertia(0.01, Vec3(1.0, -2.0, 3.0)) - Vec3(-0.01, 0.02, -0.03)).norm() < 1e-17);
}

void TestAttributeLaws::viscosityOpposesAndFadesIn() {
    core::Random random(5);
    for (int n = 0; n < 10000; ++n) {
        const Vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const double d = random.uniform(-0.002, 0.002);
        const double b = random.uniform(0.0, 20.0);
        const Vec3 f = Viscosity::force(b, d, v);
        QVERIFY((f + b * std::clamp(d / 0.0005, 0.0, 1.0) * v).norm() < 1e-12);
        QVERIFY(f.dot(v) <= 0.0);
        QVERIFY(d > 0.0 || f.norm() == 0.0);
    }
}

QTEST_APPLESS_MAIN(TestAttributeLaws)
#include "test_attribute_laws.moc"
