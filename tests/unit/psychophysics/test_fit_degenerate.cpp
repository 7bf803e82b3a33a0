// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "psychophysics/fits/fit.h"
#include "unusual_data.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace chiron::psychophysics;
using namespace chiron::tests;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

bool warned(const FitResult& fit, const char* token) {
    return std::any_of(fit.warnings.begin(), fit.warnings.end(),
                       [&](const std::string& w) { return w.rfind(std::string(token) + ": ", 0) == 0; });
}

const PsychometricData kUsual{{1, 2, 3, 4, 5, 6}, {10, 12, 13, 17, 19, 20}, {20, 20, 20, 20, 20, 20}};

} // namespace

class TestFitDegenerate : public QObject {
    Q_OBJECT
private slots:
    void unusualData_data();
    void unusualData();
    void unusableRowsAreLeftOut();
    void badOptions();
    void thresholdMovesWithTheAxis_data();
    void thresholdMovesWithTheAxis();
    void splitBlocksAreOneLevel();
    void manyTrials();
    void zeroOnALogarithmicAxis();
    void everyTrialAtAPlaceOfItsOwn();
    void bootstrapOfDegenerateData();
};

void TestFitDegenerate::unusualData_data() {
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < unusualExperiments().size(); ++i) {
        QTest::newRow(unusualExperiments()[i].name) << static_cast<int>(i);
    }
}

/// Fits every function by maximum likelihood. A posterior can take seconds, so each experiment gets that of
/// one function, in turn; the long test test_fit_unusual_posteriors computes all of them.
void TestFitDegenerate::unusualData() {
    QFETCH(int, number);
    const UnusualData& experiment = unusualExperiments()[static_cast<std::size_t>(number)];
    const PsychometricData data = counts(experiment.right, experiment.of);
    for (int function = 0; function < kSigmoids; ++function) {
        for (FitOptions options :
             {twoChoices(static_cast<Sigmoid>(function)), yesNo(static_cast<Sigmoid>(function))}) {
            mustBeSane(fitMaximumLikelihood(data, options));
            if (function == number % kSigmoids) {
                mustBeSane(fitBayesian(data, options));
            }
            options.lapse = Asymptote::fixedAt(0.0);
            mustBeSane(fitMaximumLikelihood(data, options));
            options.guess = Asymptote::equalToLapse();
            mustBeSane(fitMaximumLikelihood(data, options));
        }
    }
    const FitResult likely = fitMaximumLikelihood(data, twoChoices()),
                    posterior = fitBayesian(data, twoChoices());
    const auto words = [](const FitResult& fit) {
        std::string all;
        for (const std::string& w : fit.warnings) {
            all += w + '\n';
        }
        return all;
    };
    const auto asked = [](const char* token) { return *token != '\0'; };
    QVERIFY2(!asked(experiment.likelihoodWarning) || warned(likely, experiment.likelihoodWarning),
             words(likely).c_str());
    QVERIFY2(!asked(experiment.posteriorWarning) || warned(posterior, experiment.posteriorWarning),
             words(posterior).c_str());
}

void TestFitDegenerate::unusableRowsAreLeftOut() {
    PsychometricData data = kUsual;
    const FitResult clean = fitMaximumLikelihood(data, twoChoices());
    const auto add = [&](double x, double k, double n) {
        data.x.push_back(x);
        data.k.push_back(k);
        data.n.push_back(n);
    };
    add(kNan, 1, 2);
    add(kInf, 1, 2);
    add(2, kNan, 2);
    add(2, 1, kInf);
    add(2, -1, 2);
    add(2, 3, 2);
    add(2, 1.5, 2);
    add(2, 0, 0); // no trials: no data, and no fault
    data.x.push_back(9.0);
    for (const FitResult& fit : {fitMaximumLikelihood(data, twoChoices()), fitBayesian(data, twoChoices())}) {
        QVERIFY(warned(fit, "unusable_rows"));
        mustBeSane(fit);
    }
    QCOMPARE(fitMaximumLikelihood(data, twoChoices()).threshold, clean.threshold);
    for (const PsychometricData& nothing : {PsychometricData{}, PsychometricData{{kNan}, {1}, {1}}}) {
        QVERIFY(warned(fitMaximumLikelihood(nothing, twoChoices()), "no_data"));
        QVERIFY(warned(fitBayesian(nothing, twoChoices()), "no_data"));
    }
    QVERIFY(warned(fitMaximumLikelihood({{2, 2}, {5, 6}, {10, 10}}, twoChoices()), "one_level"));
    QVERIFY(warned(fitBayesian({{2, 2}, {5, 6}, {10, 10}}, twoChoices()), "one_level"));
    const PsychometricData negative{{-1, 1, 2, 4}, {1, 1, 2, 4}, {4, 4, 4, 4}};
    QVERIFY(warned(fitMaximumLikelihood(negative, twoChoices(Sigmoid::weibull)), "off_scale"));
}

void TestFitDegenerate::badOptions() {
    FitOptions options = twoChoices();
    options.guess = Asymptote::fixedAt(kNan);
    QVERIFY(warned(fitMaximumLikelihood(kUsual, options), "bad_options"));
    options = twoChoices();
    options.lapse = Asymptote::fixedAt(0.6);
    QVERIFY(warned(fitBayesian(kUsual, options), "bad_options"));
    options = twoChoices();
    options.confidence = 1.0;
    QVERIFY(warned(fitBayesian(kUsual, options), "bad_options"));
}

void TestFitDegenerate::thresholdMovesWithTheAxis_data() {
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("scale");
    QTest::newRow("far away") << 1e6 << 1.0;
    QTest::newRow("tiny") << 0.0 << 1e-9;
    QTest::newRow("huge") << 0.0 << 1e12;
    QTest::newRow("below zero") << -1e6 << 1e-3;
}

void TestFitDegenerate::thresholdMovesWithTheAxis() {
    QFETCH(double, offset);
    QFETCH(double, scale);
    PsychometricData moved = kUsual;
    for (double& x : moved.x) {
        x = offset + scale * x;
    }
    for (const FitOptions& options : {twoChoices(), yesNo(Sigmoid::gumbel)}) {
        const double tolerance = scale * 1e-6 + std::abs(offset) * 1e-12;
        const FitResult a = fitMaximumLikelihood(kUsual, options), b = fitMaximumLikelihood(moved, options);
        QVERIFY(std::abs(offset + scale * a.threshold - b.threshold) < tolerance);
        QVERIFY(std::abs(scale * a.width - b.width) < 10.0 * tolerance);
        const FitResult c = fitBayesian(kUsual, options), d = fitBayesian(moved, options);
        QVERIFY(std::abs(offset + scale * c.mean.threshold - d.mean.threshold) < 10.0 * tolerance);
        QVERIFY(std::abs(offset + scale * c.ci.threshold.low - d.ci.threshold.low) < 100.0 * tolerance);
    }
}

void TestFitDegenerate::splitBlocksAreOneLevel() {
    PsychometricData trials;
    for (std::size_t i = 0; i < kUsual.x.size(); ++i) {
        for (int t = 0; t < 20; ++t) {
            trials.x.insert(t % 2 ? trials.x.begin() : trials.x.end(), kUsual.x[i]);
            trials.k.insert(t % 2 ? trials.k.begin() : trials.k.end(), t < kUsual.k[i] ? 1.0 : 0.0);
            trials.n.push_back(1.0);
        }
    }
    const FitResult a = fitMaximumLikelihood(kUsual, twoChoices()),
                    b = fitMaximumLikelihood(trials, twoChoices());
    QCOMPARE(b.threshold, a.threshold);
    QCOMPARE(b.deviance, a.deviance);
    const FitResult c = fitBayesian(kUsual, twoChoices()), d = fitBayesian(trials, twoChoices());
    QCOMPARE(d.threshold, c.threshold);
    QCOMPARE(d.ci.width.high, c.ci.width.high);
}

void TestFitDegenerate::manyTrials() {
    PsychometricData million = kUsual;
    for (std::size_t i = 0; i < million.x.size(); ++i) {
        million.k[i] *= 1e6 / 20.0;
        million.n[i] *= 1e6 / 20.0;
    }
    const FitResult likely = fitMaximumLikelihood(million, twoChoices()),
                    few = fitMaximumLikelihood(kUsual, twoChoices());
    QVERIFY(std::abs(likely.threshold - few.threshold) < 1e-4);
    QVERIFY(std::abs(likely.error.threshold - few.error.threshold / std::sqrt(5e4)) <
            0.02 * likely.error.threshold);
    mustBeSane(fitBayesian(million, twoChoices()));
    PsychometricData exact =
        million; // on a curve: the posterior is as narrow as the errors of maximum likelihood
    FitResult curve;
    curve.function = Sigmoid::gauss;
    curve.best = {3.2, 4.0, 0.02, 0.5, 0.0};
    for (std::size_t i = 0; i < exact.x.size(); ++i) {
        exact.k[i] = std::round(1e6 * proportionAt(curve, exact.x[i]));
    }
    const FitResult posterior = fitBayesian(exact, twoChoices()),
                    sharp = fitMaximumLikelihood(exact, twoChoices());
    QVERIFY(std::abs(sharp.threshold - 3.2) < 1e-4);
    QVERIFY(std::abs(posterior.mean.threshold - 3.2) < 4.0 * posterior.error.threshold + 1e-3);
    QVERIFY(posterior.error.threshold <
            0.05); // wider than 0.002 of maximum likelihood: six levels hardly bound the overdispersion
}

void TestFitDegenerate::zeroOnALogarithmicAxis() {
    PsychometricData data{{0, 1, 2, 4, 8, 16}, {9, 11, 13, 16, 19, 20}, {20, 20, 20, 20, 20, 20}};
    for (const FitResult& fit : {fitMaximumLikelihood(data, twoChoices(Sigmoid::weibull)),
                                 fitBayesian(data, twoChoices(Sigmoid::weibull))}) {
        mustBeSane(fit);
        QVERIFY(fit.threshold > 1.0 && fit.threshold < 16.0);
        QCOMPARE(fit.levels.front().fitted, 0.5); // no stimulus: guessing
    }
}

/// 100,000 trials at as many places: put together, and as exact as they were.
void TestFitDegenerate::everyTrialAtAPlaceOfItsOwn() {
    FitResult curve;
    curve.function = Sigmoid::gauss;
    curve.best = {3.2, 4.0, 0.02, 0.5, 0.0};
    auto random = chiron::core::Random::stream(5, "places");
    PsychometricData trials;
    for (int i = 0; i < 100'000; ++i) {
        trials.x.push_back(random.uniform(0.0, 8.0));
        trials.k.push_back(random.uniform() < proportionAt(curve, trials.x.back()) ? 1.0 : 0.0);
        trials.n.push_back(1.0);
    }
    const FitResult likely = fitMaximumLikelihood(trials, twoChoices()),
                    credible = fitBayesian(trials, twoChoices());
    for (const FitResult& fit : {likely, credible}) {
        mustBeSane(fit);
        QVERIFY(warned(fit, "binned"));
        QVERIFY(fit.levels.size() >= 250 && fit.levels.size() <= 257);
    }
    QVERIFY(std::abs(likely.threshold - 3.2) < 4.0 * likely.error.threshold + 1e-3);
    QVERIFY(std::abs(likely.width - 4.0) < 4.0 * likely.error.width + 0.01);
    QVERIFY(likely.error.threshold < 0.05);
    QVERIFY(credible.ci.threshold.low < 3.2 && 3.2 < credible.ci.threshold.high);
    for (auto* column : {&trials.x, &trials.k, &trials.n})
        column->resize(256);
    QVERIFY(!warned(fitMaximumLikelihood(trials, twoChoices()), "binned"));
}

void TestFitDegenerate::bootstrapOfDegenerateData() {
    for (const std::vector<double>& k :
         {std::vector<double>{0, 0, 3, 3}, {3, 3, 3, 3}, {1, 2, 1, 2}, {0, 1, 3, 3}}) {
        for (const Bootstrap kind : {Bootstrap::parametric, Bootstrap::nonparametric}) {
            FitOptions options = twoChoices();
            options.bootstrap = kind;
            options.bootstrapSamples = 200;
            options.monteCarlo = 100;
            const FitResult fit = fitMaximumLikelihood(counts(k, 3), options);
            mustBeSane(fit);
            QVERIFY(!fit.fitted || (fit.pValue > 0.0 && fit.pValue <= 1.0));
            QVERIFY(std::isnan(fit.ci.threshold.low) || fit.ci.threshold.low <= fit.ci.threshold.high);
        }
    }
}

QTEST_GUILESS_MAIN(TestFitDegenerate)
#include "test_fit_degenerate.moc"
