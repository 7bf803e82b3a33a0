// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "simulation/attributes/deformation.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;

namespace {

bool near(double a, double b, double relative) {
    return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

constexpr Deformation::Parameters kSoft{{400.0, 0.0}, 200.0, 0.25};

} // namespace

class TestDeformation : public QObject {
    Q_OBJECT
private slots:
    void pressIsAStandardLinearSolid();
    void steadyForceIsProportionalToDepth();
    void surfaceRecovers();
    void quickPressMeetsMore();
    void deformationIsPassive_data();
    void deformationIsPassive();
    void deformationNeverPulls();
    void withoutTimeItIsElastic();
    void freeSurfaceOfAStiffeningSolid();
};

// A step of depth and its relaxation, to the last bit of the exponential.
void TestDeformation::pressIsAStandardLinearSolid() {
    Deformation dent;
    const double d = 0.004;
    const double k = kSoft.elastic.stiffness_N_per_m;
    const double k1 = kSoft.extraStiffness_N_per_m;
    double force = dent.press(kSoft, d, 0.001).force_N;
    QVERIFY(near(force, (k + k1) * d, 1e-14));
    for (int n = 1; n <= 2000; ++n) {
        const auto now = dent.press(kSoft, d, 0.001);
        QVERIFY(near(now.force_N, k * d + k1 * d * std::exp(-n * 0.001 / kSoft.recoveryTime_s), 1e-12));
        QVERIFY(now.force_N < force);
        force = now.force_N;
    }
    // the step's size does not matter: half a second at once is half a second in ticks
    Deformation once;
    once.press(kSoft, d, 0.001);
    Deformation ticks;
    for (int n = 0; n <= 500; ++n)
        ticks.press(kSoft, d, 0.001);
    QVERIFY(near(once.press(kSoft, d, 0.5).force_N, ticks.press(kSoft, d, 0.0).force_N, 1e-12));
}

// P2: "normal to the surface and proportional to the distance from the original surface position".
void TestDeformation::steadyForceIsProportionalToDepth() {
    for (const double d : {0.001, 0.002, 0.005}) {
        Deformation dent;
        double force = 0.0;
        for (int n = 0; n < 5000; ++n)
            force = dent.press(kSoft, d, 0.001).force_N;
        QVERIFY(near(force, 400.0 * d, 1e-8));
    }
}

void TestDeformation::surfaceRecovers() {
    Deformation dent;
    for (int n = 0; n < 5000; ++n)
        dent.press(kSoft, 0.005, 0.001);
    const double left = dent.press(kSoft, -0.01, 0.001).surface_m;
    QVERIFY(near(left, 200.0 * 0.005 / 600.0, 1e-8));
    for (int n = 1; n <= 1000; ++n) {
        const auto now = dent.press(kSoft, -0.01, 0.001);
        QCOMPARE(now.force_N, 0.0);
        QVERIFY(near(now.surface_m, left * std::exp(-n * 0.001 / 0.25), 1e-9)); // with τ
    }
    // touched again before that, there is nothing down to where the surface now lies, and something below
    const double surface = dent.press(kSoft, -0.01, 0.0).surface_m;
    Deformation above = dent;
    QCOMPARE(above.press(kSoft, 0.99 * surface, 0.0).force_N, 0.0);
    QVERIFY(dent.press(kSoft, 1.01 * surface, 0.0).force_N > 0.0);
    dent.reset();
    QCOMPARE(dent.press(kSoft, 0.0, 0.001).surface_m, 0.0);
}

void TestDeformation::quickPressMeetsMore() {
    const auto atDepth = [](int ticks) {
        Deformation dent;
        double force = 0.0;
        for (int n = 1; n <= ticks; ++n)
            force = dent.press(kSoft, 0.005 * n / ticks, 0.001).force_N;
        return force;
    };
    QVERIFY(near(atDepth(1), 600.0 * 0.005, 1e-12));
    QVERIFY(atDepth(20) > atDepth(200) && atDepth(200) > atDepth(2000));
    // a ramp of speed s is felt as k d + k₁ s τ (1 − e^{−t/τ}), up to the one tick that q lags
    const double s = 0.005 / 0.5;
    const double ramp = 400.0 * 0.005 + 200.0 * s * 0.25 * (1.0 - std::exp(-0.5 / 0.25));
    QVERIFY2(std::abs(atDepth(500) - ramp) < 200.0 * s * 0.001,
             qPrintable(QString::number(atDepth(500) - ramp)));
}

void TestDeformation::deformationIsPassive_data() {
    QTest::addColumn<double>("stiffening");
    QTest::addColumn<bool>("wild");
    QTest::newRow("linear, smooth") << 0.0 << false;
    QTest::newRow("linear, wild") << 0.0 << true;
    QTest::newRow("stiffening, smooth") << 100.0 << false;
    QTest::newRow("stiffening, wild") << 100.0 << true;
}

// Over any history, tick by tick, the press costs at least what is stored more: f (d − d₋) ≥ E − E₋.
void TestDeformation::deformationIsPassive() {
    QFETCH(double, stiffening);
    QFETCH(bool, wild);
    core::Random random(6);
    double least = 0.0;
    double lost = 0.0;
    for (int run = 0; run < 200; ++run) {
        const double k = random.uniform(50.0, 800.0);
        const Deformation::Parameters law{
            {k, stiffening}, random.uniform(0.0, 2.0) * k, random.uniform(0.005, 1.0)};
        Deformation dent;
        double d = 0.0;
        double speed = 0.0;
        double energy = dent.press(law, 0.0, 0.001).energy_J;
        double work = 0.0;
        for (int n = 0; n < 3000; ++n) {
            speed = wild ? random.uniform(-3.0, 3.0) : 0.99 * speed + random.uniform(-0.004, 0.004);
            const double next = std::clamp(d + 0.001 * speed, -0.003, 0.008);
            const auto now = dent.press(law, next, 0.001);
            // outside the surface (d < 0) nothing is pressed
            const double moved = std::max(0.0, next) - std::max(0.0, d);
            work += now.force_N * moved;
            least = std::min(least, now.force_N * moved - (now.energy_J - energy));
            energy = now.energy_J;
            d = next;
        }
        QVERIFY(work >= energy - 1e-12);
        lost += work - energy;
    }
    QVERIFY2(least >= -1e-15, qPrintable(QString::number(least)));
    QVERIFY(lost > 0.01); // and it is lossy: the test moved it
}

void TestDeformation::deformationNeverPulls() {
    core::Random random(7);
    Deformation dent;
    for (int n = 0; n < 100000; ++n) {
        const auto now = dent.press(kSoft, random.uniform(-0.005, 0.01), 0.001);
        QVERIFY(now.force_N >= 0.0 && now.energy_J >= 0.0 && now.surface_m >= 0.0);
    }
}

void TestDeformation::withoutTimeItIsElastic() {
    core::Random random(8);
    for (const Deformation::Parameters& law : {Deformation::Parameters{{300.0, 0.0}, 0.0, 0.5},
                                               Deformation::Parameters{{300.0, 40.0}, 150.0, 0.0}}) {
        Deformation dent;
        for (int n = 0; n < 1000; ++n) {
            const double d = random.uniform(0.0, 0.01);
            const auto now = dent.press(law, d, 0.001);
            QCOMPARE(now.force_N, law.elastic.tension(d));
            QCOMPARE(now.energy_J, law.elastic.energy(d));
            QCOMPARE(now.stiffness_N_per_m, law.elastic.slope(d));
        }
        QCOMPARE(dent.press(law, -0.001, 0.001).surface_m, 0.0);
    }
}

// Where nothing presses the two springs balance, also when one of them stiffens.
void TestDeformation::freeSurfaceOfAStiffeningSolid() {
    core::Random random(9);
    for (int n = 0; n < 1000; ++n) {
        const double k = random.uniform(50.0, 800.0);
        const Deformation::Parameters law{{k, random.uniform(1.0, 400.0)}, random.uniform(0.1, 3.0) * k, 0.2};
        Deformation dent;
        const double d = random.uniform(0.001, 0.012);
        for (int i = 0; i < 500; ++i)
            dent.press(law, d, 0.01);
        const auto left = dent.press(law, 0.0, 0.0);
        const double pull = law.extraStiffness_N_per_m * (dent.stretch_m() - left.surface_m);
        QVERIFY2(near(law.elastic.tension(left.surface_m), pull, 1e-9),
                 qPrintable(QString("%1 %2").arg(law.elastic.tension(left.surface_m)).arg(pull)));
    }
}

QTEST_APPLESS_MAIN(TestDeformation)
#include "test_deformation.moc"
