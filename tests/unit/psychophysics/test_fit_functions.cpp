// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "psychophysics/fits/beta_binomial.h"
#include "psychophysics/fits/chi_square.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/likelihood.h"
#include "psychophysics/fits/model_comparison.h"

#include <QtTest>

#include <cmath>

using namespace chiron::psychophysics;

namespace {

const PsychometricData kData{
    {1, 2, 3, 4, 5, 6, 7, 8}, {51, 53, 55, 69, 72, 86, 95, 99}, {100, 100, 100, 100, 100, 100, 100, 100}};

bool close(double a, double b, double allowed) {
    return std::abs(a - b) <= allowed;
}

} // namespace

class TestFitFunctions : public QObject {
    Q_OBJECT
private slots:
    void sigmoidsAndTheirDerivatives();
    void thresholdAndWidthMeanTheSame();
    void derivedQuantities();
    void betaBinomialSumsToOne();
    void chiSquare();
    void equalRowsOfOneTrial();
    void intervalsSurroundTheFit();
    void lapsesStandInForAFlatCurve();
    void bootstrapRepeats();
    void equalAsymptotes();
    void conditionsCompared();
    void curveHasABand();
    void twentyDrawsAreTheFewest();
    void aStepLiesBetweenItsLevels();
    void guessReachesAHalf();
};

void TestFitFunctions::sigmoidsAndTheirDerivatives() {
    for (int i = 0; i < kSigmoids; ++i) {
        const auto sigmoid = static_cast<Sigmoid>(i);
        QCOMPARE(sigmoidFromToken(token(sigmoid)).value(), sigmoid);
        for (const double z : {-6.0, -2.3, -0.4, 0.3, 1.1, 2.9}) {
            const SigmoidValue s = sigmoidAt(sigmoid, z);
            const double h = 1e-5;
            const SigmoidValue above = sigmoidAt(sigmoid, z + h), below = sigmoidAt(sigmoid, z - h);
            QVERIFY(close(s.rise + s.rest, 1.0, 1e-15));
            QVERIFY(close(s.slope, (above.rise - below.rise) / (2.0 * h), 1e-9));
            QVERIFY(close(s.bend, (above.slope - below.slope) / (2.0 * h), 1e-9));
            if (s.rise > 1e-6 && s.rest > 1e-6) {
                QVERIFY(close(sigmoidInverse(sigmoid, s.rise), z, 1e-7));
            }
        }
        QCOMPARE(sigmoidAt(sigmoid, -INFINITY).rise, 0.0);
        QCOMPARE(sigmoidAt(sigmoid, INFINITY).rest, 0.0);
    }
}

void TestFitFunctions::thresholdAndWidthMeanTheSame() {
    for (int i = 0; i < kSigmoids; ++i) {
        FitResult fit;
        fit.function = static_cast<Sigmoid>(i);
        fit.scale = ownScale(fit.function);
        fit.best = {0.7, 1.3, 0.03, 0.5, 0.0};
        QVERIFY(close(toScale(thresholdAt(fit, 0.5, true), fit.scale), 0.7, 1e-12));
        const double width = toScale(thresholdAt(fit, 0.95, true), fit.scale) -
                             toScale(thresholdAt(fit, 0.05, true), fit.scale);
        QVERIFY(close(width, 1.3, 1e-9));
        QVERIFY(close(proportionAt(fit, thresholdAt(fit, 0.75)), 0.75, 1e-9));
        QVERIFY(std::isnan(thresholdAt(fit, 0.4))); // below guessing
        const double x = thresholdAt(fit, 0.8), h = 1e-6;
        const double up = fromScale(toScale(x, fit.scale) + h, fit.scale),
                     down = fromScale(toScale(x, fit.scale) - h, fit.scale);
        QVERIFY(close(slopeAt(fit, x), (proportionAt(fit, up) - proportionAt(fit, down)) / (2.0 * h), 1e-6));
    }
}

void TestFitFunctions::derivedQuantities() {
    FitResult fit;
    fit.function = Sigmoid::gauss;
    fit.best = {100.0, unitsOf(Sigmoid::gauss).spread * 10.0, 0.0, 0.0, 0.0}; // Φ((x − 100)/10)
    QVERIFY(close(pse(fit), 100.0, 1e-9));
    QVERIFY(close(jnd(fit), 6.744897501960817, 1e-8));
    QVERIFY(close(weberFraction(fit, 100.0), 0.06744897501960817, 1e-10));
}

void TestFitFunctions::betaBinomialSumsToOne() {
    for (const double eta : {0.0, 1e-9, 1e-4, 0.05, 0.4, 0.95}) {
        for (const double n : {1.0, 7.0, 60.0, 3000.0}) {
            double sum = 0.0;
            for (double k = 0.0; k <= n; k += 1.0) {
                sum += std::exp(betaBinomialLog(k, n, 0.7, 0.3, eta) + logFactorial(n) - logFactorial(k) -
                                logFactorial(n - k));
            }
            QVERIFY2(close(sum, 1.0, 1e-9), qPrintable(QString::number(eta) + ' ' + QString::number(n) + ' ' +
                                                       QString::number(sum - 1.0)));
        }
    }
    const BetaBinomialTable table(13, 40, {0.0, 0.1}, 0.0, 1.0);
    for (const double psi : {0.1, 0.2513, 0.333, 0.6}) {
        std::array<double, 2> sums{};
        table.addTo(std::log(psi / (1.0 - psi)), sums.data());
        QVERIFY(close(sums[0], betaBinomialLog(13, 40, psi, 1.0 - psi, 0.0), 1e-3));
        QVERIFY(close(sums[1], betaBinomialLog(13, 40, psi, 1.0 - psi, 0.1), 1e-3));
    }
}

void TestFitFunctions::chiSquare() {
    QVERIFY(close(chiSquareTail(3.841458820694124, 1), 0.05, 1e-12));
    QVERIFY(close(chiSquareTail(18.307038053275146, 10), 0.05, 1e-12));
    QVERIFY(close(chiSquareTail(1.0, 2), std::exp(-0.5), 1e-14));
    QVERIFY(close(chiSquareQuantileOne(0.95), 3.841458820694124, 1e-9));
    QVERIFY(std::isnan(chiSquareTail(1.0, 0)));
    // Mixtures 1/4, 1/2, 1/4 and 1/8, 3/8, 3/8, 1/8, from erf and exp in closed form.
    QCOMPARE(chiBarSquareQuantile(0.95, 0), chiSquareQuantileOne(0.95));
    QVERIFY(close(chiBarSquareQuantile(0.95, 1), 4.230599177831495, 1e-9));
    QVERIFY(close(chiBarSquareQuantile(0.95, 2), 5.434530130517375, 1e-9));
    const double q = chiBarSquareQuantile(0.6, 1);
    QVERIFY(close(0.25 + 0.5 * std::erf(std::sqrt(0.5 * q)) + 0.25 * -std::expm1(-0.5 * q), 0.6, 1e-12));
    QVERIFY(std::isnan(chiBarSquareQuantile(0.95, 3)) && std::isnan(chiBarSquareQuantile(0.95, -1)) &&
            std::isnan(chiBarSquareQuantile(1.0, 1)) && std::isnan(chiBarSquareQuantile(0.0, 1)));
}

/// A list of single trials has the log-likelihood of its Bernoulli answers; blocks add their coefficients.
void TestFitFunctions::equalRowsOfOneTrial() {
    const PsychometricData trials{
        {1, 1, 2, 2, 3, 3, 4, 4}, {0, 1, 1, 0, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1, 1, 1}};
    FitOptions options;
    options.lapse = Asymptote::fixedAt(0.02);
    const FitResult fit = fitMaximumLikelihood(trials, options);
    double sum = 0.0;
    for (std::size_t i = 0; i < trials.x.size(); ++i) {
        const double psi = proportionAt(fit, trials.x[i]);
        sum += std::log(trials.k[i] > 0.0 ? psi : 1.0 - psi);
    }
    QVERIFY(close(fit.logLikelihood, sum, 1e-9));
}

void TestFitFunctions::intervalsSurroundTheFit() {
    FitOptions options;
    options.lapse = Asymptote::fixedAt(0.0);
    const FitResult profile = fitMaximumLikelihood(kData, options);
    QVERIFY(profile.ci.threshold.low < profile.threshold && profile.threshold < profile.ci.threshold.high);
    QVERIFY(profile.ci.width.low < profile.width && profile.width < profile.ci.width.high);
    const double wald = 1.96 * profile.error.threshold; // 800 trials: nearly normal
    QVERIFY(close(profile.ci.threshold.high - profile.threshold, wald, 0.15 * wald));
    options.bootstrap = Bootstrap::parametric;
    options.bootstrapSamples = 1000;
    const FitResult bootstrap = fitMaximumLikelihood(kData, options);
    QVERIFY(close(bootstrap.ci.threshold.low, profile.ci.threshold.low, 0.3 * wald));
    QVERIFY(close(bootstrap.ci.threshold.high, profile.ci.threshold.high, 0.3 * wald));
    QVERIFY(close(bootstrap.ci.width.high, profile.ci.width.high, 0.1 * profile.width));
    const FitInterval jndInterval = intervalOf(bootstrap, [&](const CurveParameters& at) {
        return 0.5 * (thresholdAt(bootstrap, at, 0.75, true) - thresholdAt(bootstrap, at, 0.25, true));
    });
    QVERIFY(jndInterval.low < jnd(bootstrap) && jnd(bootstrap) < jndInterval.high);
}

/// Observers three times as flat as the range is made for, in yes-no with lapses and guesses free: a steeper
/// curve with many of them looks alike, and there are no fewer than none. 95 % intervals by chi-square of one
/// degree held 89.5 % of 3,000.
void TestFitFunctions::lapsesStandInForAFlatCurve() {
    FitResult observer;
    observer.function = Sigmoid::gauss;
    observer.best = {0.5, 1.5, 0.02, 0.02, 0.0};
    FitOptions options;
    options.guess = Asymptote::fitted();
    constexpr int kRuns = 600;
    int held = 0;
    for (int run = 0; run < kRuns; ++run) {
        chiron::core::Random random =
            chiron::core::Random::stream(static_cast<std::uint64_t>(run), "flat curves with lapses");
        PsychometricData data;
        for (int i = 0; i < 8; ++i) {
            double right = 0.0;
            for (int trial = 0; trial < 40; ++trial)
                right += random.uniform() < proportionAt(observer, i / 7.0) ? 1.0 : 0.0;
            data.x.push_back(i / 7.0);
            data.k.push_back(right);
            data.n.push_back(40.0);
        }
        const FitInterval width = fitMaximumLikelihood(data, options).ci.width;
        held += width.low <= 1.5 && 1.5 <= width.high ? 1 : 0;
    }
    constexpr int kFewest = 551; // of 600 at 95 %: fewer by chance 4 in 10,000
    QVERIFY2(held >= kFewest, qPrintable(QString::number(held)));
}

void TestFitFunctions::bootstrapRepeats() {
    FitOptions options;
    options.bootstrap = Bootstrap::nonparametric;
    options.bootstrapSamples = 200;
    options.monteCarlo = 200;
    options.seed = 5;
    const FitResult once = fitMaximumLikelihood(kData, options), again = fitMaximumLikelihood(kData, options);
    QCOMPARE(once.ci.threshold.low, again.ci.threshold.low);
    QCOMPARE(once.pValue, again.pValue);
    QVERIFY(close(once.pValue, once.chiSquareP, 0.2));
}

/// The prior of the lapse counts once where the guess equals it: half the data's shape either way round gives
/// the same posterior.
void TestFitFunctions::equalAsymptotes() {
    FitOptions options;
    options.guess = Asymptote::equalToLapse();
    const PsychometricData data{{1, 2, 3, 4, 5, 6}, {2, 3, 12, 28, 37, 38}, {40, 40, 40, 40, 40, 40}};
    PsychometricData mirrored = data;
    for (std::size_t i = 0; i < 6; ++i) {
        mirrored.x[i] = 7.0 - data.x[i];
        mirrored.k[i] = 40.0 - data.k[i];
    }
    const FitResult a = fitBayesian(data, options), b = fitBayesian(mirrored, options);
    QCOMPARE(a.guess, a.lapse);
    QVERIFY(close(a.mean.threshold, 7.0 - b.mean.threshold, 1e-6));
    QVERIFY(close(a.mean.lapse, b.mean.lapse, 1e-6));
    QVERIFY(close(fitMaximumLikelihood(data, options).threshold,
                  7.0 - fitMaximumLikelihood(mirrored, options).threshold, 1e-5));
}

void TestFitFunctions::conditionsCompared() {
    PsychometricData harder = kData;
    harder.k = {50, 52, 51, 54, 60, 70, 78, 90};
    FitOptions options;
    options.lapse = Asymptote::fixedAt(0.01);
    options.profileIntervals = false;
    const ModelComparison differ =
        compareConditions({kData, harder}, options, {.width = true}, {.threshold = true});
    QVERIFY(differ.smaller.fitted && differ.larger.fitted);
    QCOMPARE(differ.freedom, 1);
    QVERIFY(differ.pValue < 1e-4 && differ.aicDifference > 10.0);
    const ModelComparison same =
        compareConditions({kData, kData}, options, {}, {.threshold = true, .width = true});
    QCOMPARE(same.freedom, 2);
    QVERIFY(same.likelihoodRatio < 1e-6 && same.pValue > 0.999);
    options.monteCarlo = 99;
    const ModelComparison drawn =
        compareConditions({kData, harder}, options, {.width = true}, {.threshold = true});
    QCOMPARE(drawn.pValue, 0.01); // none of 99 as large
    QCOMPARE(drawn.simulated, 99);
    QCOMPARE(drawn.chiSquareP, differ.pValue);
    QVERIFY(compareConditions({kData, kData}, options, {}, {.threshold = true, .width = true}).pValue > 0.9);
    options.monteCarlo = 0;
    // Nothing in common: as if fitted alone.
    const ConditionsFit apart = fitConditions({kData, harder}, options, {});
    const FitResult first = fitMaximumLikelihood(kData, options),
                    second = fitMaximumLikelihood(harder, options);
    QVERIFY(close(apart.logLikelihood, first.logLikelihood + second.logLikelihood, 1e-6));
    QVERIFY(close(apart.conditions[1].threshold, second.threshold, 1e-3));
    options.lapse = Asymptote::fitted();
    const ConditionsFit oneLapse = fitConditions({kData, harder}, options, {.lapse = true});
    QCOMPARE(oneLapse.freeParameters, 5);
    QCOMPARE(oneLapse.conditions[0].lapse, oneLapse.conditions[1].lapse);
    QVERIFY(!fitConditions({kData, {{1, 2}, {3, 3}, {3, 3}}}, options, {}).warnings.empty());
}

void TestFitFunctions::curveHasABand() {
    FitOptions options;
    options.curvePoints = 41;
    const FitResult fit = fitBayesian(kData, options);
    QCOMPARE(fit.curve.size(), std::size_t{41});
    QCOMPARE(fit.draws.size(), std::size_t{1000});
    for (const CurveSample& sample : fit.curve) {
        QVERIFY(sample.low <= sample.high && sample.low <= sample.fitted + 0.03 &&
                sample.fitted <= sample.high + 0.03);
    }
    const FitInterval drawn = intervalOf(fit, [](const CurveParameters& at) { return at.threshold; });
    QVERIFY(close(drawn.low, fit.ci.threshold.low, 0.15 * fit.error.threshold * 2.0));
    QVERIFY(close(drawn.high, fit.ci.threshold.high, 0.15 * fit.error.threshold * 2.0));
}

/// Of the draws 0 to 19 the middle 95 % reach from 0.025 to 0.975 of 19; of one fewer nothing is said.
void TestFitFunctions::twentyDrawsAreTheFewest() {
    FitResult fit;
    fit.confidence = 0.95;
    for (int i = 19; i >= 0; --i) {
        CurveParameters draw;
        draw.threshold = i;
        fit.draws.push_back(draw);
    }
    const auto threshold = [](const CurveParameters& at) { return at.threshold; };
    const FitInterval twenty = intervalOf(fit, threshold);
    QVERIFY(close(twenty.low, 0.475, 1e-12) && close(twenty.high, 18.525, 1e-12));
    fit.draws.back().threshold = std::nan("");
    const FitInterval fewer = intervalOf(fit, threshold);
    QVERIFY(std::isnan(fewer.low) && std::isnan(fewer.high));
}

/// A step between two intensities is put between them, whichever end is which.
void TestFitFunctions::aStepLiesBetweenItsLevels() {
    FitOptions options;
    for (const double low : {0.0, 5.0, 50.0}) {
        options.guess = Asymptote::fixedAt(low / 100.0);
        const PsychometricData step{{1, 2, 3, 4}, {low, low, 100, 100}, {100, 100, 100, 100}};
        const FitResult fit = fitMaximumLikelihood(step, options);
        QVERIFY2(std::abs(fit.threshold - 2.5) < 0.1, qPrintable(QString::number(fit.threshold)));
    }
}

/// Free, the guess rate is at least as likely as fixed at a half.
void TestFitFunctions::guessReachesAHalf() {
    const PsychometricData data{{1, 2, 3, 4, 5}, {52, 50, 60, 80, 98}, {100, 100, 100, 100, 100}};
    FitOptions fixed, free;
    fixed.guess = Asymptote::fixedAt(0.5);
    free.guess = Asymptote::fitted();
    fixed.lapse = free.lapse = Asymptote::fitted();
    QVERIFY(fitMaximumLikelihood(data, free).logLikelihood >
            fitMaximumLikelihood(data, fixed).logLikelihood - 1e-6);
}

QTEST_GUILESS_MAIN(TestFitFunctions)
#include "test_fit_functions.moc"
