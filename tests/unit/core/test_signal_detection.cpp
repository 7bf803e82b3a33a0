// SPDX-License-Identifier: GPL-3.0-or-later
// The normal distribution and the measures of detection, against published and hand-worked numbers.
#include "core/normal_distribution.h"
#include "core/random.h"
#include "core/signal_detection.h"

#include <QtTest>
#include <cmath>

using namespace chiron::core;

namespace {
bool isNear(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}
} // namespace

class TestSignalDetection : public QObject {
    Q_OBJECT
private slots:
    void quantilesOfTables();
    void quantileInvertsTheCumulative();
    void quantileAtItsEnds();
    void publishedExamples();
    void peersOfOtherDesigns();
    void logLinearCorrection();
    void whoFeelsNothingHasNone();
    void standardErrorByHand();
    void intervalCoversTheTruth();
};

/// Percentage points of the normal distribution, to 15 digits (tables: Abramowitz & Stegun 26.5; the two far
/// ones from the asymptotic series, checked in 50-digit arithmetic).
void TestSignalDetection::quantilesOfTables() {
    QVERIFY(isNear(normalQuantile(0.5), 0.0, 1e-15));
    QVERIFY(isNear(normalQuantile(0.75), 0.674489750196082, 1e-13));
    QVERIFY(isNear(normalQuantile(0.95), 1.644853626951473, 1e-13));
    QVERIFY(isNear(normalQuantile(0.975), 1.959963984540054, 1e-13));
    QVERIFY(isNear(normalQuantile(0.99), 2.326347874040841, 1e-13));
    QVERIFY(isNear(normalQuantile(0.999), 3.090232306167813, 1e-12));
    QVERIFY(isNear(normalQuantile(1e-10), -6.361340902404056, 1e-12));
    QVERIFY(isNear(normalQuantile(1e-300), -37.0471, 1e-4));
}

void TestSignalDetection::quantileInvertsTheCumulative() {
    for (double x = -8.0; x <= 5.0; x += 0.01) // beyond, 1 − Φ(x) has too few digits to come back
        QVERIFY2(isNear(normalQuantile(normalCumulative(x)), x, 1e-9), qPrintable(QString::number(x)));
    double before = normalQuantile(1e-6);
    for (double p = 2e-6; p < 1.0; p += 1e-4) {
        const double z = normalQuantile(p);
        QVERIFY(z > before);
        QVERIFY(isNear(normalQuantile(1.0 - p), -z, 1e-9));
        before = z;
    }
}

void TestSignalDetection::quantileAtItsEnds() {
    QCOMPARE(normalQuantile(0.0), -HUGE_VAL);
    QCOMPARE(normalQuantile(1.0), HUGE_VAL);
    QVERIFY(std::isnan(normalQuantile(-0.1)) && std::isnan(normalQuantile(1.1)) &&
            std::isnan(normalQuantile(std::nan(""))));
}

/// Macmillan & Creelman (2005), ch. 1–2: face recognition, 20 of 25 old and 10 of 25 new faces called old: z
/// = 0.842 and −0.253, d′ = 1.095, c = −0.294. Elliott's table of d′ (Swets 1964) has 1.99 for 0.84 and 0.16.
void TestSignalDetection::publishedExamples() {
    QVERIFY(isNear(dPrime(0.8, 0.4), 1.095, 5e-4));
    QVERIFY(isNear(criterion(0.8, 0.4), -0.294, 5e-4));
    QVERIFY(isNear(dPrime(0.84, 0.16), 1.99, 5e-3));
    QVERIFY(isNear(criterion(0.84, 0.16), 0.0, 1e-12));
    QCOMPARE(dPrime(0.3, 0.3), 0.0); // chance
}

/// psyphy's help (reference data: published_small_checks.json) gives d′ of same–different and ABX tasks for
/// an observer that decides on each interval by itself. Both go back to yes–no's z(H) − z(F) (Macmillan &
/// Creelman 2005, ch. 9): p = Φ((z(H) − z(F))/2).
void TestSignalDetection::peersOfOtherDesigns() {
    const double p = normalCumulative(0.5 * dPrime(0.75, 0.3));
    QVERIFY(isNear(2.0 * normalQuantile(0.5 * (1.0 + std::sqrt(2.0 * p - 1.0))), 1.954916,
                   1e-6)); // same–different
    const double abx = 1.660967;
    const double root = abx / std::sqrt(2.0);
    QVERIFY(isNear(normalCumulative(root) * normalCumulative(0.5 * abx) +
                       normalCumulative(-root) * normalCumulative(-0.5 * abx),
                   p, 1e-5)); // psyphy's root is good to R's uniroot(), 1e-4 in d′
}

void TestSignalDetection::logLinearCorrection() {
    QCOMPARE(correctedRate(20, 20), 20.5 / 21.0);
    QCOMPARE(correctedRate(0, 0), 0.5);
    const double z = normalQuantile(20.5 / 21.0);
    QVERIFY(isNear(dPrime(DetectionCounts{20, 20, 0, 20}), 2.0 * z, 1e-12));  // all right: finite
    QVERIFY(isNear(dPrime(DetectionCounts{0, 20, 20, 20}), -2.0 * z, 1e-12)); // all wrong
    QVERIFY(isNear(criterion(DetectionCounts{20, 20, 0, 20}), 0.0, 1e-12));
    QCOMPARE(dPrime(DetectionCounts{10, 20, 10, 20}), 0.0);                 // chance
    QVERIFY(isNear(criterion(DetectionCounts{0, 20, 0, 20}), z, 1e-12));    // always no
    QVERIFY(isNear(criterion(DetectionCounts{20, 20, 20, 20}), -z, 1e-12)); // always yes
    QVERIFY(isUsable({0, 20, 0, 20}) && !isUsable({0, 19, 0, 200}) && !isUsable({0, 200, 0, 19}));
    DetectionCounts sum{1, 2, 3, 4};
    sum += {10, 20, 30, 40};
    QVERIFY((sum == DetectionCounts{11, 22, 33, 44}));
}

/// Always no, always yes: d′ = 0 at every base rate; with equal numbers the weighted correction is the plain
/// one; mirrored answers, mirrored d′.
void TestSignalDetection::whoFeelsNothingHasNone() {
    for (const int ofSignal : {1, 20, 60, 500})
        for (const int ofNoise : {1, 20, 160, 3000}) {
            QVERIFY(isNear(weightedDPrime({0, ofSignal, 0, ofNoise}), 0.0, 1e-12));
            QVERIFY(isNear(weightedDPrime({ofSignal, ofSignal, ofNoise, ofNoise}), 0.0, 1e-12));
            const DetectionCounts best{ofSignal, ofSignal, 0, ofNoise}, worst{0, ofSignal, ofNoise, ofNoise};
            QVERIFY(weightedDPrime(best) > 0.0 &&
                    isNear(weightedDPrime(best), -weightedDPrime(worst), 1e-12));
            const auto interval = weightedDPrimeInterval({0, ofSignal, 0, ofNoise});
            QVERIFY(interval.low < 0.0 && interval.high > 0.0);
        }
    for (int hits = 0; hits <= 20; ++hits) {
        const DetectionCounts equal{hits, 20, 7, 20};
        QVERIFY(isNear(weightedDPrime(equal), dPrime(equal), 1e-12));
        QVERIFY(isNear(weightedCriterion(equal), criterion(equal), 1e-12));
        QVERIFY(isNear(weightedDPrimeInterval(equal).low, dPrimeInterval(equal).low, 1e-12));
    }
    QCOMPARE(weightedDPrime(DetectionCounts{}), 0.0);
    QVERIFY(std::isnan(rateOf(0, 0, RateCorrection::none)));
    QCOMPARE(weightedRates({0, 0, 3, 10}).hit, 0.5); // of what nobody was asked
    QCOMPARE(weightedRates({3, 10, 0, 0}).falseAlarm, 0.5);
}

/// By hand with H = 20.5/26 and F = 10.5/26: φ(z(H)) = 0.289438, φ(z(F)) = 0.387298; var =
/// H(1−H)/(25·0.083774) + F(1−F)/(25·0.150000).
void TestSignalDetection::standardErrorByHand() {
    const DetectionCounts faces{20, 25, 10, 25};
    const double h = 20.5 / 26.0;
    const double f = 10.5 / 26.0;
    const auto density = [](double x) { return std::exp(-0.5 * x * x) / std::sqrt(2.0 * M_PI); };
    const double expected = std::sqrt(h * (1.0 - h) / (25.0 * std::pow(density(0.80109), 2)) +
                                      f * (1.0 - f) / (25.0 * std::pow(density(0.24340), 2)));
    QVERIFY(isNear(normalCumulative(0.80109), h, 5e-5) &&
            isNear(normalCumulative(-0.24340), f, 5e-5)); // the two z used
    QVERIFY(isNear(dPrimeStandardError(faces), expected, 1e-4));
    const auto interval = dPrimeInterval(faces);
    QVERIFY(isNear(0.5 * (interval.low + interval.high), dPrime(faces), 1e-12));
    QVERIFY(isNear(interval.high - interval.low, 2.0 * 1.959964 * dPrimeStandardError(faces), 1e-6));
    for (const RateCorrection correction : {RateCorrection::logLinear, RateCorrection::none}) {
        QVERIFY(std::isinf(dPrimeStandardError({0, 0, 1, 20}, correction))); // nothing of one kind was asked
        QVERIFY(std::isinf(dPrimeStandardError({1, 20, 0, 0}, correction)));
    }
    QVERIFY(std::isfinite(dPrimeStandardError({0, 1, 1, 20}))); // one is not nothing
    QVERIFY(std::isnan(dPrimeStandardError({0, 20, 1, 20}, RateCorrection::none)));
}

/// 2,000 made-up observers of d′ = 1 with 60 signals and 60 noises: the 95 % interval holds the truth in
/// about 95 % (± 4 standard errors of a share: 1.9 %).
void TestSignalDetection::intervalCoversTheTruth() {
    Random random(7);
    int holds = 0;
    constexpr int kObservers = 2000;
    for (int i = 0; i < kObservers; ++i) {
        DetectionCounts n{0, 60, 0, 60};
        for (int k = 0; k < 60; ++k) {
            n.hits += random.normal() + 1.0 > 0.5 ? 1 : 0;
            n.falseAlarms += random.normal() > 0.5 ? 1 : 0;
        }
        const auto interval = dPrimeInterval(n);
        holds += interval.low <= 1.0 && 1.0 <= interval.high ? 1 : 0;
    }
    QVERIFY2(std::abs(holds / double(kObservers) - 0.95) < 0.02, qPrintable(QString::number(holds)));
}

QTEST_APPLESS_MAIN(TestSignalDetection)
#include "test_signal_detection.moc"
