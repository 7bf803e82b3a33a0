// SPDX-License-Identifier: GPL-3.0-or-later
// d' of every task against published numbers, its inverse, its standard error and interval.
#include "psychophysics/measures/dprime.h"

#include "core/normal_distribution.h"
#include "core/random.h"
#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/observers/thurstone.h"
#include "tests/unit/psychophysics/measures/published_line.h"

#include <array>

using namespace chiron::psychophysics;

namespace {

constexpr DiscriminationTask kTwoAfc{Discrimination::mAfc, 2};
constexpr DiscriminationTask kTetrad{Discrimination::tetrad, 2};
constexpr DiscriminationTask kTriangle{Discrimination::oddityDifferencing, 3};
constexpr DiscriminationTask kOddity{Discrimination::oddityIndependent, 3};
constexpr DiscriminationTask kAbx{Discrimination::abxDifferencing, 2};
constexpr DiscriminationTask kAbxIndependent{Discrimination::abxIndependent, 2};
constexpr DiscriminationTask kSameDifferent{Discrimination::sameDifferentIndependent, 2};
constexpr std::array<DiscriminationTask, 9> kAll{{kTwoAfc,
                                                  {Discrimination::mAfc, 3},
                                                  {Discrimination::mAfc, 12},
                                                  kTetrad,
                                                  kTriangle,
                                                  kOddity,
                                                  kAbx,
                                                  kAbxIndependent,
                                                  kSameDifferent}};

} // namespace

class TestDPrime : public QObject {
    Q_OBJECT
private slots:
    void sensR();
    void psyphy();
    void oddityRulesApart();
    void closedForms();
    void inverses();
    void simulatedObservers();
    void sameDifferentByDifferencing();
    void errorFallsWithTheTrials();
    void intervalsCover();
    void degenerate();
    void tails();
    void orderTable();
    void ratesAtTheirLimitsAreSaid();
    void impossibleCountsAreRefused();
};

/// sensR, tests/discrim.Rout.save (published_small_checks.json, sensR_tests): last printed digit.
void TestDPrime::sensR() {
    PublishedLine line("published_small_checks.json sensR_tests");
    const DPrimeEstimate score = dPrimeOfCounts(kTetrad, 10, 15, ProportionLimits::score);
    for (const ProportionInterval& nothing : {wilsonInterval(0, 0), wilsonInterval(0, 0, 0.95, true),
                                              exactInterval(0, 0)}) // of no trials, everything is possible
        QVERIFY(nothing.low == 0.0 && nothing.high == 1.0);
    const ProportionInterval share = wilsonInterval(10, 15, 0.95, true);
    line.compare(score.proportion, 0.6667, 5e-5);
    line.compare(share.low, 0.3869, 5e-5);
    line.compare(share.high, 0.8701, 5e-5);
    line.compare(score.dPrime, 1.5878, 5e-5);
    line.compare(score.standardError, 0.4193, 5e-5);
    line.compare(score.low, 0.5511, 5e-5);
    line.compare(score.high, 2.4433, 5e-5);
    line.compare(score.scoreChiSquare, 7.5, 1e-9);
    line.compare(score.scoreP, 0.003085, 5e-7);
    line.compare(discriminationPower(kTetrad, 1.0, 50), 0.731897, 5e-7);
    line.compare(trialsForPower(kTetrad, 1.0, 0.9), 82, 0.0);
    line.compare(proportionCorrect(kTetrad, 2.0), 0.7776671, 1e-6); // 0.77766707 by quadrature
    line.compare(dPrimeAt(kTetrad, 0.8), 2.0946, 5e-5);
    QVERIFY(line.holds());
}

/// psyphy's help (published_small_checks.json, psyphy_help). Its roots are R's uniroot and optimize at their
/// default tolerance, 1.2e-4.
void TestDPrime::psyphy() {
    PublishedLine line("published_small_checks.json psyphy_help");
    line.compare(dPrimeAt({Discrimination::mAfc, 4}, 0.8), 1.893143, 5e-5);
    line.compare(dPrimeAt(kTriangle, 0.8), 3.128594, 1e-4);
    line.compare(dPrimeOfRates(kAbx, 0.75, 0.3), 1.8687, 5e-5);
    line.compare(dPrimeOfRates(kAbxIndependent, 0.75, 0.3), 1.660967, 5e-5);
    line.compare(sameDifferentDPrime(0.642, 0.3), 1.950605, 1e-4);
    line.compare(dPrimeOfRates(kSameDifferent, 0.75, 0.3), 1.954916, 5e-5);
    QVERIFY(line.holds());
}

/// Versfeld, Dai & Green (1996): at d' = 1 differencing is right 0.418 of the time, independent observation
/// 0.447.
void TestDPrime::oddityRulesApart() {
    PublishedLine line("Versfeld, Dai & Green 1996, oddity at d' = 1");
    line.compare(proportionCorrect(kTriangle, 1.0), 0.418, 5e-4);
    line.compare(proportionCorrect(kOddity, 1.0), 0.447, 5e-4);
    QVERIFY(line.holds());
    for (double d = 0.25; d < 6.0; d += 0.25)
        QVERIFY(proportionCorrect(kOddity, d) > proportionCorrect(kTriangle, d));
}

void TestDPrime::closedForms() {
    for (const DiscriminationTask& task : kAll) {
        QVERIFY(std::abs(proportionCorrect(task, 0.0) - chanceOf(task)) < 1e-12);
        QVERIFY(std::abs(proportionCorrect(task, 40.0) - 1.0) < 1e-9);
    }
    for (double d = -4.0; d <= 6.0; d += 0.5) // 2AFC by the integral of m-AFC: the same as sqrt 2 z(pc)
        QVERIFY(std::abs(dPrimeAt(kTwoAfc, proportionCorrect(kTwoAfc, d)) - d) < 1e-8);
    QVERIFY(std::abs(dPrimeAt(kTwoAfc, 0.75) - std::sqrt(2.0) * chiron::core::normalQuantile(0.75)) < 1e-10);
    // Hacker & Ratcliff (1979), table of m-AFC: m = 3 and 8 at d' = 1 and 2
    QVERIFY(std::abs(proportionCorrect({Discrimination::mAfc, 3}, 1.0) - 0.6337) < 5e-4);
}

void TestDPrime::inverses() {
    for (const DiscriminationTask& task : kAll)
        for (double d = 0.05; d < 5.0; d += 0.15) {
            const double back = dPrimeAt(task, proportionCorrect(task, d));
            QVERIFY2(std::abs(back - d) < 1e-6, qPrintable(QString::number(d)));
            QVERIFY(slopeOf(task, d) > 0.0);
        }
    QVERIFY(dPrimeAt(kTwoAfc, 0.2) < 0.0 && dPrimeAt(kTriangle, 0.2) == 0.0);
}

/// Each rule played out: 200,000 trials at d' = 1.5, within 4 standard errors.
void TestDPrime::simulatedObservers() {
    constexpr int trials = 200000;
    constexpr double d = 1.5;
    chiron::core::Random random(7);
    std::array<int, 4> right{}; // triangle, oddity, tetrad, abx
    for (int i = 0; i < trials; ++i) {
        const double a = d + random.normal();
        const double b = random.normal();
        const double c = random.normal();
        const double e = d + random.normal();
        right[0] += std::abs(b - c) < std::min(std::abs(a - b), std::abs(a - c)) ? 1 : 0;
        const double half = 0.5 * (a + b + c - 1.5 * d);
        const auto far = [&](double x) { return std::abs(x - 0.5 * d - half); };
        right[1] += far(a) > std::max(far(b), far(c)) ? 1 : 0;
        right[2] += std::max(b, c) < std::min(a, e) || std::min(b, c) > std::max(a, e) ? 1 : 0;
        right[3] += (std::abs(e - a) < std::abs(e - b)) ? 1 : 0;
    }
    const std::array<DiscriminationTask, 4> tasks{kTriangle, kOddity, kTetrad, kAbx};
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const double p = proportionCorrect(tasks[i], d);
        const double seen = static_cast<double>(right[i]) / trials;
        qInfo("rule %d: %.4f expected, %.4f seen", static_cast<int>(i), p, seen);
        QVERIFY(std::abs(seen - p) < 4.0 * std::sqrt(p * (1.0 - p) / trials));
    }
}

void TestDPrime::sameDifferentByDifferencing() {
    for (double d = 0.2; d < 5.0; d += 0.3)
        for (double k = 0.3; k < 3.0; k += 0.4) {
            const SameDifferentRates rates = sameDifferentRates(d, k);
            QVERIFY(std::abs(sameDifferentDPrime(rates.hit, rates.falseAlarm) - d) < 1e-6);
        }
    const DPrimeEstimate estimate = sameDifferentOfCounts(80, 120, 30, 120);
    QVERIFY(estimate.dPrime > 1.5 && estimate.dPrime < 2.5 && estimate.standardError > 0.1 &&
            estimate.standardError < 0.4);
    QVERIFY(sameDifferentOfCounts(10, 50, 20, 50).dPrime == 0.0);
    // The same rates of four and of nine times as many trials: a half and a third of the error. Each kind of
    // pair has its own number.
    const auto plain = [](long long n, long long m) {
        return sameDifferentOfCounts(2 * n, 3 * n, m, 4 * m, 0.95, chiron::core::RateCorrection::none);
    };
    const double one = plain(40, 30).standardError;
    QVERIFY(one > 0.0 && std::abs(plain(160, 120).standardError - 0.5 * one) < 1e-6 &&
            std::abs(plain(360, 270).standardError - one / 3.0) < 1e-6);
    const double byHits2 = one * one - std::pow(plain(40 * 1000000, 30).standardError, 2);
    QVERIFY(byHits2 > 0.1 * one * one);
    QVERIFY2(std::abs(one * one - std::pow(plain(160, 30).standardError, 2) - 0.75 * byHits2) < 1e-6,
             "hits count by pairs that differ");
}

/// Of counts of 2AFC in closed form: √(p q/n) over the slope φ(d′/√2)/√2.
void TestDPrime::errorFallsWithTheTrials() {
    const DiscriminationTask task; // 2AFC
    for (const long long n : {40, 160, 640}) {
        const DPrimeEstimate estimate = dPrimeOfCounts(task, n * 3 / 4, n);
        const double density = std::exp(-0.25 * estimate.dPrime * estimate.dPrime) / std::sqrt(2.0 * M_PI);
        QVERIFY(std::abs(estimate.standardError -
                         std::sqrt(0.75 * 0.25 / static_cast<double>(n)) / (density / M_SQRT2)) < 1e-6);
    }
}

/// Exact limits cover at least 95 % (here over all outcomes, without simulation).
void TestDPrime::intervalsCover() {
    for (const DiscriminationTask& task : {kTwoAfc, kTriangle, kTetrad})
        for (double d = 0.5; d < 3.0; d += 0.5) {
            const double p = proportionCorrect(task, d);
            double covered = 0.0;
            for (int right = 0; right <= 60; ++right) {
                const DPrimeEstimate estimate = dPrimeOfCounts(task, right, 60);
                const double chance =
                    std::exp(logChoose(60, right) + right * std::log(p) + (60 - right) * std::log1p(-p));
                covered += estimate.low <= d && d <= estimate.high ? chance : 0.0;
            }
            QVERIFY2(covered >= 0.95, qPrintable(QString::number(covered)));
        }
}

void TestDPrime::degenerate() {
    QVERIFY(std::isnan(dPrimeOfCounts(kTriangle, 0, 0).dPrime) &&
            !dPrimeOfCounts(kTriangle, 0, 0).warnings.empty());
    QVERIFY(std::isnan(dPrimeOfCounts(kTriangle, 5, 3).dPrime) &&
            std::isnan(dPrimeOfCounts(kTriangle, -1, 3).low));
    const DPrimeEstimate all = dPrimeOfCounts(kTriangle, 40, 40);
    QVERIFY(std::isnan(all.dPrime) && all.low > 2.0 && std::isinf(all.high) &&
            all.warnings.front().starts_with("all_right: "));
    const DPrimeEstimate chance = dPrimeOfCounts(kTriangle, 9, 40);
    QVERIFY(chance.dPrime == 0.0 && std::isnan(chance.standardError) && chance.low == 0.0);
    const DPrimeEstimate million = dPrimeOfCounts(kTwoAfc, 750000, 1000000);
    QVERIFY(std::abs(million.dPrime - 0.953872552) < 1e-6 && million.high - million.low < 0.01);
    QVERIFY(std::isnan(dPrimeAt(kTetrad, std::nan(""))) &&
            std::isnan(proportionCorrect(kTetrad, std::nan(""))));
    QVERIFY(std::isnan(dPrimeOfRates(kAbx, 1.0, 0.0)) && std::isnan(sameDifferentDPrime(0.0, 0.5)));
    QVERIFY(std::isnan(dPrimeOfCounts({Discrimination::mAfc, -3}, 0, 10).dPrime));
}

/// Tables: chi-square, t (5 % and 1 % points), binomial tails and Clopper–Pearson limits by R's pchisq, qt,
/// qchisq, binom.test.
void TestDPrime::tails() {
    QVERIFY(std::abs(chiSquareUpperTail(3.841458820694124, 1) - 0.05) < 1e-12);
    QVERIFY(std::abs(chiSquareUpperTail(18.30703805327515, 10) - 0.05) < 1e-12);
    QVERIFY(std::abs(chiSquareQuantile(0.95, 10) - 18.30703805327515) < 1e-9);
    QVERIFY(std::abs(studentQuantile(0.975, 4) - 2.776445105197799) < 1e-10);
    QVERIFY(std::abs(studentQuantile(0.975, 30) - 2.042272456301238) < 1e-10);
    QVERIFY(std::abs(studentUpperTail(-1.0, 3) + studentUpperTail(1.0, 3) - 1.0) < 1e-14);
    QVERIFY(std::abs(binomialUpperTail(8, 10, 0.5) - 56.0 / 1024.0) < 1e-14);
    QVERIFY(std::abs(binomialLowerTail(2, 10, 0.5) - 56.0 / 1024.0) < 1e-14);
    for (const auto& tail : {binomialUpperTail, binomialLowerTail}) { // no such experiment
        QVERIFY(std::isnan(tail(1, -1, 0.5)) && std::isnan(tail(1, 2, 1.5)) && std::isnan(tail(1, 2, -0.5)));
        QVERIFY(std::isnan(tail(1, 2, std::nan(""))));
    }
    QVERIFY(std::isnan(gammaUpperRegularised(0.0, 1.0)) &&
            std::isnan(gammaUpperRegularised(1.0, std::nan(""))));
    QVERIFY(std::abs(exactInterval(7, 20).low - 0.1539092) < 1e-7 &&
            std::abs(exactInterval(7, 20).high - 0.5921885) < 1e-7);
    QVERIFY(exactInterval(0, 0).low == 0.0 && exactInterval(0, 0).high == 1.0);
}

void TestDPrime::orderTable() {
    double worst = 0.0;
    for (double d = -13.0; d < 13.0; d += 0.0137) {
        const auto exact = rankProbabilities(d);
        const auto table = tabulatedOrderProbabilities(d);
        for (std::size_t i = 0; i < exact.size(); ++i)
            worst = std::max(worst, std::abs(exact[i] - table[i]));
    }
    qInfo("rank-3 table against the integral: %.2g", worst);
    QVERIFY(worst < 1e-7);
}

/// Without trials of one kind, or with counts that cannot be, there is no estimate and a warning says so.
void TestDPrime::impossibleCountsAreRefused() {
    const auto refused = [](const DPrimeEstimate& estimate) {
        return estimate.warnings.size() == 1 && estimate.warnings.front().starts_with("no_trials") &&
               std::isnan(estimate.dPrime);
    };
    QVERIFY(refused(sameDifferentOfCounts(0, 0, 3, 10)) && refused(sameDifferentOfCounts(3, 10, 0, 0)));
    QVERIFY(refused(sameDifferentOfCounts(11, 10, 3, 10)) && refused(sameDifferentOfCounts(3, 10, 11, 10)));
    QVERIFY(refused(sameDifferentOfCounts(-1, 10, 3, 10)) && refused(sameDifferentOfCounts(3, 10, -1, 10)));
    QVERIFY(!refused(sameDifferentOfCounts(10, 10, 0, 10)) && !refused(sameDifferentOfCounts(0, 1, 0, 1)));
}

/// Of 20 places with and 24 without the stimulus.
void TestDPrime::ratesAtTheirLimitsAreSaid() {
    const auto token = [](long long hits, long long falseAlarms) {
        const auto warnings = warningsOfRates(hits, 20, falseAlarms, 24);
        return warnings.empty() ? std::string() : warnings.front().substr(0, warnings.front().find(':'));
    };
    QCOMPARE(token(0, 0), std::string("one_answer"));
    QCOMPARE(token(20, 24), std::string("one_answer"));
    for (const auto& [hits, falseAlarms] : {std::pair{20, 0}, {0, 24}, {20, 3}, {0, 3}, {7, 0}, {7, 24}})
        QCOMPARE(token(hits, falseAlarms), std::string("rate_at_limit"));
    for (const auto& [hits, falseAlarms] : {std::pair{1, 1}, {19, 23}, {19, 1}})
        QCOMPARE(token(hits, falseAlarms), std::string());
    const auto first = [](const DPrimeEstimate& estimate) {
        return estimate.warnings.empty() ? std::string() : estimate.warnings.front();
    };
    QVERIFY(first(sameDifferentOfCounts(20, 20, 0, 24)).starts_with("rate_at_limit: "));
    QVERIFY(first(sameDifferentOfCounts(20, 20, 0, 24, 0.95, chiron::core::RateCorrection::none))
                .starts_with("no_limit: "));
    QCOMPARE(first(sameDifferentOfCounts(19, 20, 1, 24)), std::string());
}

QTEST_APPLESS_MAIN(TestDPrime)
#include "test_dprime.moc"
