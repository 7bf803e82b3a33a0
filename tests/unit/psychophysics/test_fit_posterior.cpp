// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/posterior_model.h"

#include <QtTest>

#include <cmath>

using namespace chiron::psychophysics;

namespace {

struct Case {
    const char* name;
    PsychometricData data;
    Sigmoid function;
    Asymptote guess;
};

PsychometricData counts(std::vector<double> x, std::vector<double> k, double n) {
    std::vector<double> of(k.size(), n);
    return {std::move(x), std::move(k), std::move(of)};
}

const std::vector<double> kEven{0.4, 1.05, 1.7, 2.35, 3.0};

FitOptions optionsOf(const Case& at) {
    FitOptions options;
    options.function = at.function;
    options.guess = at.guess;
    return options;
}

/// Log of the posterior density at parameters in given units, up to the constant of FitResult::logPosterior.
double logPosteriorAt(const Case& at, const CurveParameters& given) {
    const FitOptions options = optionsOf(at);
    const StimulusScale scale = ownScale(at.function);
    const PreparedLevels levels = prepareLevels(at.data, scale);
    const FreeParameters free = freeParameters(options);
    const PosteriorModel model{levels, at.function, priorsFor(levels, options, scale), free, 0.0, options.guess.value, true};
    return model.logDensity({(given.threshold - levels.centre) / levels.range, given.width / levels.range, given.lapse, given.guess, given.eta});
}

} // namespace

class TestFitPosterior : public QObject {
    Q_OBJECT
private slots:
    void modeIsTheHighest();
};

/// Places that long searches from outside found (simplex climbs from hundreds of starts): no place is higher than what is reported.
void TestFitPosterior::modeIsTheHighest() {
    const std::vector<double> uneven{0.361, 0.742, 0.81,  0.935, 0.983, 1.01,  1.088, 1.398, 1.404, 1.493, 1.587, 1.716, 1.842,
                                     1.89,  2.078, 2.116, 2.414, 2.588, 2.687, 3.029, 3.1,   3.332, 3.478, 3.765, 3.919};
    const std::vector<std::pair<Case, CurveParameters>> cases{
        {{"few lapses", counts(kEven, {2, 0, 2, 5, 4}, 5), Sigmoid::rgumbel, Asymptote::fitted()}, {1.785, 1.275, 0.0416, 0.1045, 0.0}},
        {{"no overdispersion", counts(kEven, {3, 3, 9, 3, 38}, 40), Sigmoid::hyperbolic, Asymptote::fixedAt(0.1)}, {2.696, 0.8689, 0.0, 0.1, 0.0}},
        {{"decades on a linear axis", counts({1, 10, 100, 1000, 10000}, {11, 15, 19, 28, 29}, 30), Sigmoid::gauss, Asymptote::fixedAt(0.5)},
         {103.1, 18.61, 0.0435, 0.5, 0.0}},
        {{"many levels, many lapses", counts(uneven, {6, 5, 3, 6, 6, 8, 8, 5, 3, 9, 5, 10, 5, 8, 9, 9, 8, 7, 6, 8, 6, 10, 8, 8, 10}, 10), Sigmoid::tdist,
          Asymptote::fixedAt(0.5)},
         {1.454, 0.0122, 0.2, 0.5, 0.0}}};
    for (const auto& [at, known] : cases) {
        const FitResult fit = fitBayesian(at.data, optionsOf(at));
        const double there = logPosteriorAt(at, known);
        QVERIFY2(fit.logPosterior > there - 1e-5, qPrintable(QStringLiteral("%1: %2, known %3").arg(at.name).arg(fit.logPosterior).arg(there)));
        QVERIFY(std::abs(logPosteriorAt(at, fit.best) - fit.logPosterior) < 1e-9 * std::abs(fit.logPosterior));
    }
}

QTEST_GUILESS_MAIN(TestFitPosterior)
#include "test_fit_posterior.moc"
