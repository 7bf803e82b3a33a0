// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/low_pass.h"
#include "scoring/smoothness.h"

#include "core/units.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace chiron;
using namespace chiron::scoring;

namespace {

/// The profile of Balasubramanian et al.'s published program: v = e^{−5t²}, t ∈ [−1, 1) at 100 Hz.
std::vector<double> gaussian(double scale = 1.0) {
    std::vector<double> v;
    for (int i = 0; i < 200; ++i) {
        const double t = -1.0 + i * 0.01;
        v.push_back(scale * std::exp(-5.0 * t * t));
    }
    return v;
}

std::vector<core::Vec3> wave(double frequency_Hz, double rate_Hz, double duration_s) {
    std::vector<core::Vec3> p;
    for (int i = 0; i < duration_s * rate_Hz; ++i)
        p.emplace_back(std::sin(2.0 * core::kPi * frequency_Hz * i / rate_Hz), 0.0, 0.0);
    return p;
}

} // namespace

class TestSmoothness : public QObject {
    Q_OBJECT
private slots:
    void sparcOfPublishedProfile();
    void ldljOfPublishedProfile();
    void smoothnessIgnoresScale();
    void ldljIgnoresTimeScale();
    void twoBumpsAreLessSmoothThanOne();
    void undefinedHasReason();
    void lowPassPassesConstantsAndRamps();
    void lowPassHalvesAtCutOffWithoutDelay();
    void lowPassFollowsSquaredButterworth_data();
    void lowPassFollowsSquaredButterworth();
    void lowPassTakesShortInput();
    void lowPassIsTimeSymmetric();
};

void TestSmoothness::sparcOfPublishedProfile() {
    const auto sparc = spectralArcLength(gaussian(), 0.01);
    QVERIFY(sparc.value.has_value());
    QVERIFY2(std::abs(*sparc.value + 1.41403) < 0.000005, qPrintable(QString::number(*sparc.value, 'f', 8)));
}

void TestSmoothness::ldljOfPublishedProfile() {
    const auto ldlj = logDimensionlessJerk(gaussian(), 0.01);
    QVERIFY(ldlj.value.has_value());
    QVERIFY2(std::abs(*ldlj.value + 5.81636) < 0.000005, qPrintable(QString::number(*ldlj.value, 'f', 8)));
}

void TestSmoothness::smoothnessIgnoresScale() {
    QVERIFY(std::abs(*spectralArcLength(gaussian(), 0.01).value -
                     *spectralArcLength(gaussian(137.0), 0.01).value) < 1e-9);
    QVERIFY(std::abs(*logDimensionlessJerk(gaussian(), 0.01).value -
                     *logDimensionlessJerk(gaussian(137.0), 0.01).value) < 1e-9);
}

// Dimensionless: the same profile twice as slow has the same value.
void TestSmoothness::ldljIgnoresTimeScale() {
    QVERIFY(std::abs(*logDimensionlessJerk(gaussian(), 0.01).value -
                     *logDimensionlessJerk(gaussian(), 0.02).value) < 1e-9);
}

void TestSmoothness::twoBumpsAreLessSmoothThanOne() {
    std::vector<double> two = gaussian();
    const std::vector<double> one = gaussian();
    two.insert(two.end(), one.begin(), one.end());
    QVERIFY(*spectralArcLength(two, 0.01).value < *spectralArcLength(one, 0.01).value);
    QVERIFY(*logDimensionlessJerk(two, 0.01).value < *logDimensionlessJerk(one, 0.01).value);
}

void TestSmoothness::undefinedHasReason() {
    const std::vector<double> none;
    const std::vector<double> still(50, 0.0);
    const std::vector<double> steady(50, 0.1);
    const std::vector<double> two(2, 0.1);
    for (const auto& m : {spectralArcLength(none, 0.01), spectralArcLength(still, 0.01),
                          logDimensionlessJerk(none, 0.01), logDimensionlessJerk(still, 0.01),
                          logDimensionlessJerk(steady, 0.01), logDimensionlessJerk(two, 0.01)}) {
        QVERIFY(!m.value.has_value());
        QVERIFY(!m.reason.empty());
    }
}

void TestSmoothness::lowPassPassesConstantsAndRamps() {
    std::vector<core::Vec3> constant(500, core::Vec3(0.1, -0.2, 0.3));
    std::vector<core::Vec3> ramp;
    for (int i = 0; i < 500; ++i)
        ramp.emplace_back(0.3 + 1e-4 * i, -2e-4 * i, 0.0);
    const auto c = lowPassZeroPhase(constant, 1000.0, 20.0);
    const auto r = lowPassZeroPhase(ramp, 1000.0, 20.0);
    for (std::size_t i = 0; i < 500; ++i) {
        QVERIFY((c[i] - constant[i]).norm() < 1e-12);
        // A pass starts in the steady state of a constant; after three periods of padding what is left of the
        // ramp's transient is e^(−3·2π·sin 45°) of a delay's worth of path, 11 samples · 0.22 mm.
        QVERIFY((r[i] - ramp[i]).norm() < 11 * 2.3e-4 * std::exp(-3.0 * 2.0 * core::kPi * std::sqrt(0.5)));
    }
}

void TestSmoothness::lowPassHalvesAtCutOffWithoutDelay() {
    const auto in = wave(20.0, 1000.0, 4.0);
    const auto out = lowPassZeroPhase(in, 1000.0, 20.0);
    for (std::size_t i = 1000; i < 3000; ++i)
        QVERIFY(std::abs(out[i].x() - 0.5 * in[i].x()) < 1e-9);
}

void TestSmoothness::lowPassFollowsSquaredButterworth_data() {
    QTest::addColumn<double>("frequency");
    for (const double f : {1.0, 5.0, 10.0, 20.0, 40.0, 100.0, 250.0})
        QTest::addRow("%g Hz", f) << f;
}

// |H|² = 1/(1 + (tan(πf/fs)/tan(πfc/fs))⁴) for one pass, so that is the gain of two.
void TestSmoothness::lowPassFollowsSquaredButterworth() {
    QFETCH(double, frequency);
    const auto in = wave(frequency, 1000.0, 6.0);
    const auto out = lowPassZeroPhase(in, 1000.0, 20.0);
    const double ratio = std::tan(core::kPi * frequency / 1000.0) / std::tan(core::kPi * 20.0 / 1000.0);
    const double gain = 1.0 / (1.0 + std::pow(ratio, 4));
    for (std::size_t i = 2000; i < 4000; ++i)
        QVERIFY(std::abs(out[i].x() - gain * in[i].x()) < 1e-9);
}

void TestSmoothness::lowPassTakesShortInput() {
    QVERIFY(lowPassZeroPhase({}, 1000.0, 20.0).empty());
    QCOMPARE(lowPassZeroPhase({core::Vec3(1, 2, 3)}, 1000.0, 20.0).size(), std::size_t{1});
    const auto two = lowPassZeroPhase({core::Vec3(0, 0, 0), core::Vec3(1, 0, 0)}, 1000.0, 20.0);
    QCOMPARE(two.size(), std::size_t{2});
    QVERIFY(two[0].allFinite() && two[1].allFinite());
    QVERIFY((two[0] - core::Vec3(0, 0, 0)).norm() > 0.0 ||
            (two[1] - core::Vec3(1, 0, 0)).norm() > 0.0); // filtered like any other
}

// Forwards-then-backwards leaves no direction of time but at the edges.
void TestSmoothness::lowPassIsTimeSymmetric() {
    auto in = wave(7.0, 1000.0, 3.0);
    for (std::size_t i = 0; i < in.size(); ++i)
        in[i].y() = 1e-6 * static_cast<double>((i * i) % 977);
    auto reversed = in;
    std::reverse(reversed.begin(), reversed.end());
    const auto a = lowPassZeroPhase(in, 1000.0, 20.0);
    auto b = lowPassZeroPhase(reversed, 1000.0, 20.0);
    std::reverse(b.begin(), b.end());
    for (std::size_t i = 500; i + 500 < a.size(); ++i)
        QVERIFY((a[i] - b[i]).norm() < 1e-12);
}

QTEST_APPLESS_MAIN(TestSmoothness)
#include "test_smoothness.moc"
