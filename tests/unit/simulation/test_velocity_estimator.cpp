// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/random.h"
#include "simulation/attributes/coulomb_friction.h"
#include "simulation/velocity_estimator.h"

#include <QtTest>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

using namespace chiron;
using simulation::CoulombFriction;
using simulation::VelocityEstimator;

namespace {

/// A position (in counts, real) as an encoder shows it: rounded down to whole counts.
std::int32_t encoder(double counts) {
    return static_cast<std::int32_t>(std::floor(counts));
}

core::DeviceSample packet(std::uint32_t number, std::uint64_t time_us, std::int32_t counts) {
    core::DeviceSample sample;
    sample.packet = number;
    sample.deviceTime_us = time_us;
    sample.counts[0] = counts;
    return sample;
}

/// Feeds one packet a millisecond; `counts(ms)` is the true position.
std::vector<double> follow(VelocityEstimator& estimator, int milliseconds,
                           const std::function<double(double)>& counts) {
    std::vector<double> rates;
    for (int ms = 0; ms < milliseconds; ++ms)
        rates.push_back(
            estimator.update(packet(static_cast<std::uint32_t>(ms), 5000u + 1000u * static_cast<unsigned>(ms),
                                    encoder(counts(ms))))[0]);
    return rates;
}

/// Largest error of a least-squares slope over 16 samples a ms apart, each off by at most half a count either
/// way: ½ Σ|a − ā| / Σ(a − ā)² = ½ · 64 / 340 counts/ms.
constexpr double kSlopeBound_counts_per_s = 0.5 * 64.0 / 340.0 * 1000.0;

} // namespace

class TestVelocityEstimator : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void frictionAtSteadyThreeMillimetresASecond();
    void steadyMotionIsUnbiased_data();
    void steadyMotionIsUnbiased();
    void stillToolGivesExactlyZero();
    void ditherOfOneCountStaysSmall();
    void stepIsFollowedWithinTheWindow();
    void accelerationIsDelayedByAtMostHalfTheWindow();
    void irregularTimesAreUsed();
    void repeatsOlderAndInvalidPacketsChangeNothing();
    void gapForgetsThePast();
    void timeThatDoesNotAdvanceForgetsThePast();
    void packetCounterMayWrap();
    void unusedCoordinatesStayZero();
    void sameInputsSameBits();
};

// models.md §0: "per-tick differences turn a steady 3 mm/s into 0.58 N of friction instead of 1.84 N, with
// 600 jumps a second": 10 µm counts, V0 = 1 mm/s and 1.84 N at exactly 3 mm/s, so mu N = 1.84·sqrt(10)/3 N.
void TestVelocityEstimator::frictionAtSteadyThreeMillimetresASecond() {
    const double count_m = 10e-6;
    const double v = 0.003;
    const double muN = 1.84 * std::sqrt(10.0) / 3.0;
    VelocityEstimator estimator(1);
    std::int32_t last = 0;
    double naive = 0.0;
    double adaptive = 0.0;
    int naiveJumps = 0;
    int adaptiveJumps = 0;
    double lastNaive = 0.0;
    double lastAdaptive = 0.0;
    const int measured = 10000;
    for (int ms = 0; ms < measured + 20; ++ms) {
        const std::int32_t now = encoder(v * ms * 1e-3 / count_m + 1e-6);
        const double perTick = (now - last) * count_m * 1e3;
        const double windowed = estimator.update(packet(static_cast<std::uint32_t>(ms),
                                                        1000u * static_cast<unsigned>(ms), now))[0] *
                                count_m;
        last = now;
        const double fNaive = -CoulombFriction::force(1.0, muN, perTick, 0.001);
        const double fAdaptive = -CoulombFriction::force(1.0, muN, windowed, 0.001);
        if (ms >= 20) {
            naive += fNaive / measured;
            adaptive += fAdaptive / measured;
            naiveJumps += std::abs(fNaive - lastNaive) > 0.5 ? 1 : 0;
            adaptiveJumps += std::abs(fAdaptive - lastAdaptive) > 0.1 ? 1 : 0;
        }
        lastNaive = fNaive;
        lastAdaptive = fAdaptive;
    }
    QVERIFY2(std::abs(naive - 0.58) < 0.01, qPrintable(QString::number(naive)));
    QVERIFY2(std::abs(adaptive - 1.84) < 0.02, qPrintable(QString::number(adaptive)));
    QVERIFY2(std::abs(naiveJumps / 10 - 600) <= 6, qPrintable(QString::number(naiveJumps)));
    QCOMPARE(adaptiveJumps, 0);
}

void TestVelocityEstimator::steadyMotionIsUnbiased_data() {
    QTest::addColumn<double>("count_um");
    QTest::addColumn<double>("v_mm_per_s");
    for (const double count : {10.0, 20.0, 50.0})
        for (const double v : {-3.0, 0.7, 3.0, 17.3, 400.0})
            QTest::addRow("%g um, %g mm/s", count, v) << count << v;
}

void TestVelocityEstimator::steadyMotionIsUnbiased() {
    QFETCH(double, count_um);
    QFETCH(double, v_mm_per_s);
    const double truth = v_mm_per_s * 1000.0 / count_um; // counts/s
    VelocityEstimator estimator(1);
    const auto rates = follow(estimator, 20020, [&](double ms) { return truth * ms * 1e-3 + 0.123; });
    double mean = 0.0;
    for (std::size_t i = 20; i < rates.size(); ++i) {
        mean += rates[i] / 20000.0;
        QVERIFY(std::abs(rates[i] - truth) <= kSlopeBound_counts_per_s + 1e-9);
    }
    // Over T = 20 s the counts themselves know the mean to one count; the window smears its ends.
    QVERIFY2(std::abs(mean - truth) < 0.1, qPrintable(QString("%1 %2").arg(mean).arg(truth)));
}

void TestVelocityEstimator::stillToolGivesExactlyZero() {
    VelocityEstimator estimator(1);
    for (const double rate : follow(estimator, 100, [](double) { return 123456.0; }))
        QCOMPARE(rate, 0.0);
    // ... and again after motion, as soon as the window holds nothing else
    VelocityEstimator moved(1);
    const auto rates = follow(moved, 100, [](double ms) { return 97.3 * std::min(ms, 40.0); });
    for (std::size_t ms = 55; ms < rates.size(); ++ms)
        QCOMPARE(rates[ms], 0.0);
    QVERIFY(rates[40] != 0.0);
}

void TestVelocityEstimator::ditherOfOneCountStaysSmall() {
    VelocityEstimator estimator(1);
    const auto rates = follow(estimator, 200, [](double ms) { return std::fmod(ms, 2.0); });
    for (std::size_t ms = 15; ms < rates.size(); ++ms)
        QVERIFY(std::abs(rates[ms]) <= kSlopeBound_counts_per_s + 1e-9); // a tenth of the naive 1000 counts/s
}

void TestVelocityEstimator::stepIsFollowedWithinTheWindow() {
    const double truth = 9730.0; // counts/s: 97.3 mm/s on 10 µm
    VelocityEstimator estimator(1);
    const auto rates =
        follow(estimator, 200, [&](double ms) { return ms < 100.0 ? 0.0 : truth * (ms - 100.0) * 1e-3; });
    for (std::size_t ms = 0; ms <= 100; ++ms)
        QCOMPARE(rates[ms], 0.0);
    for (std::size_t ms = 115; ms < 200; ++ms)
        QVERIFY(std::abs(rates[ms] - truth) <= kSlopeBound_counts_per_s);
    // The window shrinks at the step, so most of it is there long before 15 ms.
    QVERIFY2(rates[103] > 0.9 * truth, qPrintable(QString::number(rates[103])));
}

void TestVelocityEstimator::accelerationIsDelayedByAtMostHalfTheWindow() {
    const double a = 20000.0; // counts/s²: 0.2 m/s² on 10 µm
    VelocityEstimator estimator(1);
    const auto rates = follow(estimator, 1000, [&](double ms) { return 0.5 * a * ms * ms * 1e-6; });
    for (std::size_t ms = 20; ms < rates.size(); ++ms) {
        const double truth = a * static_cast<double>(ms) * 1e-3;
        QVERIFY(rates[ms] <= truth + 2.0 * kSlopeBound_counts_per_s);
        QVERIFY(rates[ms] >= truth - a * 0.0075 - 2.0 * kSlopeBound_counts_per_s);
    }
}

void TestVelocityEstimator::irregularTimesAreUsed() {
    core::Random random(5);
    VelocityEstimator estimator(1);
    const double truth = 8000.0; // counts/s
    std::uint64_t time_us = 77;
    std::int32_t last = 0;
    double worstNaive = 0.0;
    for (std::uint32_t n = 0; n < 3000; ++n) {
        time_us += 400 + random.below(random.below(10) == 0 ? 6000 : 1200); // jitter and lost packets
        const std::int32_t now = encoder(truth * static_cast<double>(time_us) * 1e-6);
        const double rate = estimator.update(packet(n, time_us, now))[0];
        if (n > 40) {
            worstNaive = std::max(worstNaive, std::abs((now - last) * 1000.0 - truth));
            // every pair of samples at least 400 µs apart: with three or more samples over most of 15 ms the
            // slope is off by less than one count over half the window
            QVERIFY2(std::abs(rate - truth) < 1.0 / 0.0045, qPrintable(QString::number(rate)));
        }
        last = now;
    }
    QVERIFY(worstNaive > 10.0 / 0.0045); // assuming 1 ms a packet is worse than ten times that
}

void TestVelocityEstimator::repeatsOlderAndInvalidPacketsChangeNothing() {
    VelocityEstimator plain(1);
    VelocityEstimator disturbed(1);
    for (std::uint32_t n = 1; n < 200; ++n) {
        const auto sample = packet(n, 1000u * n, encoder(3.7 * n + 0.01 * n * n));
        const double expected = plain.update(sample)[0];
        QCOMPARE(disturbed.update(sample)[0], expected);
        QCOMPARE(disturbed.update(sample)[0], expected);                             // read again
        QCOMPARE(disturbed.update(packet(n - 1, 1000u * n + 10, 999))[0], expected); // older number
        auto invalid = packet(n + 1, 1000u * n + 20, -999);
        invalid.status = core::sample_status::kInvalid;
        QCOMPARE(disturbed.update(invalid)[0], expected);
    }
}

void TestVelocityEstimator::gapForgetsThePast() {
    VelocityEstimator estimator(1);
    for (std::uint32_t n = 0; n < 50; ++n)
        estimator.update(packet(n, 1000u * n, static_cast<std::int32_t>(10 * n)));
    QCOMPARE(estimator.rates()[0], 10000.0);
    QCOMPARE(estimator.update(packet(50, 49000 + 15001, 5000))[0], 0.0);
    QCOMPARE(estimator.update(packet(51, 49000 + 16001, 5010))[0], 10000.0); // nothing from before the gap
    VelocityEstimator shorter(1);
    for (std::uint32_t n = 0; n < 50; ++n)
        shorter.update(packet(n, 1000u * n, static_cast<std::int32_t>(10 * n)));
    QCOMPARE(shorter.update(packet(50, 49000 + 15000, 490 + 150))[0], 10000.0); // 15 ms is still inside
}

void TestVelocityEstimator::timeThatDoesNotAdvanceForgetsThePast() {
    for (const std::uint64_t time_us : {49000u, 48000u, 0u}) {
        VelocityEstimator estimator(1);
        for (std::uint32_t n = 0; n < 50; ++n)
            estimator.update(packet(n, 1000u * n, static_cast<std::int32_t>(10 * n)));
        QCOMPARE(estimator.update(packet(50, time_us, 500))[0], 0.0);
    }
}

void TestVelocityEstimator::packetCounterMayWrap() {
    VelocityEstimator estimator(1);
    std::uint32_t number = 0xfffffff0u;
    for (std::uint32_t n = 0; n < 50; ++n)
        estimator.update(packet(number++, 1000u * n, static_cast<std::int32_t>(10 * n)));
    QCOMPARE(estimator.rates()[0], 10000.0);
}

void TestVelocityEstimator::unusedCoordinatesStayZero() {
    VelocityEstimator estimator(2);
    for (std::uint32_t n = 0; n < 50; ++n) {
        auto sample = packet(n, 1000u * n, static_cast<std::int32_t>(n));
        for (std::size_t axis = 0; axis < sample.counts.size(); ++axis)
            sample.counts[axis] = static_cast<std::int32_t>(n * (axis + 1));
        estimator.update(sample);
    }
    QCOMPARE(estimator.rates()[0], 1000.0);
    QCOMPARE(estimator.rates()[1], 2000.0);
    QCOMPARE(estimator.rates()[2], 0.0);
}

void TestVelocityEstimator::sameInputsSameBits() {
    core::Random random(9);
    VelocityEstimator a;
    VelocityEstimator b;
    VelocityEstimator shifted; // only differences of counts and time may matter
    std::uint64_t time_us = 1;
    std::int32_t position = 0;
    for (std::uint32_t n = 0; n < 20000; ++n) {
        time_us += 200 + random.below(2000);
        position += static_cast<std::int32_t>(random.below(21)) - 10;
        auto sample = packet(n, time_us, position);
        const auto first = std::bit_cast<std::uint64_t>(a.update(sample)[0]);
        QCOMPARE(std::bit_cast<std::uint64_t>(b.update(sample)[0]), first);
        sample.counts[0] += 1000000;
        sample.deviceTime_us += 1ull << 50;
        QCOMPARE(std::bit_cast<std::uint64_t>(shifted.update(sample)[0]), first);
    }
}

QTEST_APPLESS_MAIN(TestVelocityEstimator)
#include "test_velocity_estimator.moc"
