// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/prepared_levels.h"

#include <QtTest>
#include <algorithm>

using namespace chiron::psychophysics;

/// Where the warnings of a fit begin.
class TestFitWarnings : public QObject {
    Q_OBJECT
private slots:
    void warningsBeginWhereTheySay();
    void stepsThatChanceExplains();
    void fallsThatChanceExplainsBadly();
};

/// Each warning just below and just above its bound, of results and levels written by hand.
void TestFitWarnings::warningsBeginWhereTheySay() {
    const PreparedLevels levels = prepareLevels(
        {{0, 1, 2, 3, 4}, {101, 115, 150, 182, 196}, {200, 200, 200, 200, 200}}, StimulusScale::linear);
    const auto said = [&](const PreparedLevels& of, FitOptions options, const auto& change) {
        FitResult fit;
        fit.fitted = true;
        fit.best = {2.0, 2.0, 0.02, 0.5, 0.0};
        fit.freeParameters = 3;
        summarise(fit, of);
        fit.pValue = 0.5;
        change(fit);
        addWarnings(fit, of, options);
        std::string tokens;
        for (const std::string& warning : fit.warnings) {
            tokens += (tokens.empty() ? "" : " ") + warning.substr(0, warning.find(':'));
        }
        return QString::fromStdString(tokens);
    };
    const auto says = [&](const auto& change) { return said(levels, FitOptions{}, change); };
    QCOMPARE(says([](FitResult&) {}), QString());
    // Levels lie between 0 and 4.
    QCOMPARE(says([](FitResult& f) { f.best.threshold = 0.0; }), QString());
    QCOMPARE(says([](FitResult& f) { f.best.threshold = -1e-9; }), QStringLiteral("threshold_outside"));
    QCOMPARE(says([](FitResult& f) { f.best.threshold = 4.0; }), QString());
    QCOMPARE(says([](FitResult& f) { f.best.threshold = 4.0 + 1e-9; }), QStringLiteral("threshold_outside"));
    // Widths: half a spacing of 1; three ranges of 4.
    QCOMPARE(says([](FitResult& f) { f.best.width = 0.5; }), QString());
    QCOMPARE(says([](FitResult& f) { f.best.width = 0.4999; }), QStringLiteral("step_function"));
    QCOMPARE(says([](FitResult& f) { f.ci.width.low = 0.0; }), QStringLiteral("step_function"));
    QCOMPARE(says([](FitResult& f) { f.ci.width.low = 0.001; }), QString());
    QCOMPARE(says([](FitResult& f) { f.best.width = 12.0; }), QString());
    QCOMPARE(says([](FitResult& f) { f.best.width = 12.001; }), QStringLiteral("wide"));
    // Fifteen trials between 10 and 90 % of the rise, which begins at the guess and ends below the lapses.
    const auto rising = [&](double share, double of) {
        return says([&](FitResult& f) {
            for (FittedLevel& level : f.levels) {
                level.of = 0.0;
            }
            f.levels[2].of = of;
            f.levels[2].fitted = f.guess + share * (1.0 - f.guess - f.lapse);
        });
    };
    QCOMPARE(rising(0.5, 15.0), QString());
    QCOMPARE(rising(0.5, 14.0), QStringLiteral("few_trials_near_threshold"));
    QCOMPARE(rising(0.101, 15.0), QString());
    QCOMPARE(rising(0.099, 15.0), QStringLiteral("few_trials_near_threshold"));
    QCOMPARE(rising(0.899, 15.0), QString());
    QCOMPARE(rising(0.901, 15.0), QStringLiteral("few_trials_near_threshold"));
    // Asymptotes at their bounds: half by default; no lapse only in maximum likelihood, whose estimate may be
    // 0.
    QCOMPARE(says([](FitResult& f) { f.lapse = 0.0; }), QStringLiteral("lapse_at_bound"));
    QCOMPARE(says([](FitResult& f) { f.lapse = 2e-6; }), QString());
    QCOMPARE(says([](FitResult& f) { f.lapse = 0.0, f.method = FitMethod::bayesian; }), QString());
    const double most = freeParameters(FitOptions{}).largestLapse;
    QVERIFY(most > 0.49 && most <= 0.5);
    QVERIFY(says([&](FitResult& f) { f.lapse = most; }).contains(QLatin1String("lapse_at_bound")));
    QVERIFY(says([&](FitResult& f) {
                f.lapse = most, f.method = FitMethod::bayesian;
            }).contains(QLatin1String("lapse_at_bound")));
    FitOptions known;
    known.lapse = Asymptote::fixedAt(0.0);
    QCOMPARE(said(levels, known, [](FitResult& f) { f.lapse = 0.0; }), QString());
    FitOptions yesNo;
    yesNo.guess = Asymptote::fitted();
    const double mostGuess = freeParameters(yesNo).largestGuess;
    QVERIFY(said(levels, yesNo, [&](FitResult& f) {
                f.guess = mostGuess;
            }).contains(QLatin1String("guess_at_bound")));
    QVERIFY(!said(levels, yesNo, [&](FitResult& f) {
                 f.guess = mostGuess - 2e-6;
             }).contains(QLatin1String("guess_at_bound")));
    QVERIFY(!says([](FitResult& f) {
                 f.guess = 0.5;
             }).contains(QLatin1String("guess_at_bound"))); // told to the fit
    // Scatter: p below 0.01; a Bayesian fit also by its overdispersion.
    QCOMPARE(says([](FitResult& f) { f.pValue = 0.01; }), QString());
    QCOMPARE(says([](FitResult& f) { f.pValue = 0.0099; }), QStringLiteral("overdispersion"));
    QCOMPARE(says([](FitResult& f) { f.method = FitMethod::bayesian, f.mean.eta = 0.25; }), QString());
    QCOMPARE(says([](FitResult& f) { f.method = FitMethod::bayesian, f.mean.eta = 0.2501; }),
             QStringLiteral("overdispersion"));
    QCOMPARE(says([](FitResult& f) { f.mean.eta = 0.9; }), QString());
    // A fit whose intervals are that of the posterior already is not sent there; without overdispersion it
    // does not allow for scatter either.
    const auto advises = [&](FitMethod method, bool overdispersion) {
        FitResult fit;
        fit.fitted = true;
        fit.method = method;
        fit.best = {2.0, 2.0, 0.02, 0.5, 0.0};
        summarise(fit, levels);
        fit.pValue = 0.001;
        FitOptions options;
        options.overdispersion = overdispersion;
        addWarnings(fit, levels, options);
        return fit.warnings.size() == 1 && fit.warnings.front().ends_with("use the Bayesian interval");
    };
    QVERIFY(advises(FitMethod::maximumLikelihood, true) && advises(FitMethod::bayesian, false) &&
            !advises(FitMethod::bayesian, true));
    // A range of a thousand spacings, which only a posterior minds.
    PreparedLevels uneven = levels;
    uneven.spacing = 0.004;
    const auto bayesian = [](FitResult& f) { f.method = FitMethod::bayesian; };
    QCOMPARE(said(uneven, FitOptions{}, bayesian), QString());
    uneven.spacing = 0.00399;
    QCOMPARE(said(uneven, FitOptions{}, bayesian), QStringLiteral("uneven_levels"));
    QCOMPARE(said(uneven, FitOptions{}, [](FitResult&) {}), QString());
}

/// Twice the logarithm of the likelihood ratio of the best curve to the best step, just below and above the
/// 95 % quantile for one parameter: 3.841 where lapse and guess are known, and 4.231 where the lapse rate is
/// fitted and may be 0 (Self & Liang 1987). The ratios are those of a search of its own, with another method.
void TestFitWarnings::stepsThatChanceExplains() {
    const auto maybeStep = [](const std::vector<double>& right, const Asymptote& lapse) {
        FitOptions options;
        options.lapse = lapse;
        const PreparedLevels levels =
            prepareLevels({{0, 1, 2, 3, 4}, right, {40, 40, 40, 40, 40}}, StimulusScale::linear);
        FitResult fit;
        fit.fitted = true;
        fit.best = {2.0, 2.0, 0.02, 0.5, 0.0}; // wide, so that nothing else speaks for a step
        summarise(fit, levels);
        addWarnings(fit, levels, options);
        return std::any_of(fit.warnings.begin(), fit.warnings.end(),
                           [](const std::string& warning) { return warning.starts_with("step_function: "); });
    };
    QVERIFY(maybeStep({19, 22, 27, 34, 40}, Asymptote::fixedAt(0.0)));  // 3.776
    QVERIFY(!maybeStep({19, 20, 23, 26, 37}, Asymptote::fixedAt(0.0))); // 3.937
    QVERIFY(maybeStep({15, 17, 28, 33, 39}, Asymptote::fitted()));      // 4.058
    QVERIFY(!maybeStep({23, 20, 30, 36, 40}, Asymptote::fitted()));     // 4.472
}

/// Answers that fall by more than 2.58 standard errors (p = 0.01) between a lower and a higher part of the
/// levels: by hand, 60 of 100 and r of 100, z = (0.60 - r/100) / sqrt(p (1 - p) / 50) with p their common
/// share: 2.546 for r = 42, 2.687 for r = 41.
void TestFitWarnings::fallsThatChanceExplainsBadly() {
    const auto falls = [](const std::vector<double>& k) {
        FitResult fit; // not fitted: only the answers are looked at
        addWarnings(fit, prepareLevels({{0, 1, 2, 3}, k, {50, 50, 50, 50}}, StimulusScale::linear),
                    FitOptions{});
        return std::any_of(fit.warnings.begin(), fit.warnings.end(),
                           [](const std::string& warning) { return warning.starts_with("not_monotone: "); });
    };
    QVERIFY(!falls({30, 30, 21, 21}));
    QVERIFY(falls({30, 30, 21, 20}));
    QVERIFY(!falls({20, 21, 30, 30})); // a rise
}

QTEST_APPLESS_MAIN(TestFitWarnings)
#include "test_fit_warnings.moc"
