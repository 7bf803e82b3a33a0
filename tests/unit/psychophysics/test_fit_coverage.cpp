// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/fit_priors.h"
#include "psychophysics/fits/prepared_levels.h"

#include <QtTest>

#include <cmath>
#include <cstdio>

using namespace chiron;
using namespace chiron::psychophysics;

namespace {

constexpr int kSeeds = 2000;
constexpr int kLevels = 10;
constexpr int kTrials = 20;
constexpr double kLapse = 0.02;

double gammaDraw(core::Random& random, double shape) { // Marsaglia & Tsang 2000
    if (shape < 1.0) {
        return gammaDraw(random, shape + 1.0) * std::pow(random.uniform(), 1.0 / shape);
    }
    const double d = shape - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
    for (;;) {
        const double x = random.normal(), v = std::pow(1.0 + c * x, 3.0), u = random.uniform();
        if (v > 0.0 && std::log(u) < 0.5 * x * x + d - d * v + d * std::log(v)) {
            return d * v;
        }
    }
}

/// An observer of the middle of the range, or one drawn from the priors of the Bayesian fit (range 1, spacing
/// 1/(levels − 1)).
FitResult observerOf(core::Random& random, bool fromPriors) {
    FitResult observer;
    observer.function = Sigmoid::gauss;
    observer.best = {random.uniform(0.35, 0.65), random.uniform(0.4, 0.9), kLapse, 0.5, 0.0};
    if (fromPriors) {
        const FitPriors priors{0.0, 1.0, 1.0 / (kLevels - 1.0), 10.0};
        const auto drawn = [&](double low, double high, auto&& logDensity) {
            double at = random.uniform(low, high);
            while (!(random.uniform() < std::exp(logDensity(at)))) {
                at = random.uniform(low, high);
            }
            return at;
        };
        const auto share = [&](double at) { return priors.logShare(at); };
        observer.best.threshold = drawn(priors.lowestThreshold(), priors.highestThreshold(),
                                        [&](double at) { return priors.logThreshold(at); });
        observer.best.width =
            drawn(priors.spacing, priors.largestWidth(), [&](double at) { return priors.logWidth(at); });
        observer.best.lapse = drawn(0.0, 0.499, share);
        observer.best.eta = drawn(0.0, 0.999, share);
    }
    return observer;
}

PsychometricData answersOf(core::Random& random, const FitResult& observer, double eta) {
    PsychometricData data;
    for (int i = 0; i < kLevels; ++i) {
        const double x = i / (kLevels - 1.0);
        double p = proportionAt(observer, x);
        if (eta > 0.0) {
            const double nu = 1.0 / (eta * eta) - 1.0;
            const double a = gammaDraw(random, p * nu), b = gammaDraw(random, (1.0 - p) * nu);
            p = a / (a + b);
        }
        double right = 0.0;
        for (int t = 0; t < kTrials; ++t) {
            right += random.uniform() < p ? 1.0 : 0.0;
        }
        data.x.push_back(x);
        data.k.push_back(right);
        data.n.push_back(kTrials);
    }
    return data;
}

/// P(X <= count) for Binomial(kSeeds, p).
double binomialBelow(int count, double p) {
    double sum = 0.0;
    for (int k = 0; k <= count; ++k) {
        sum += std::exp(logFactorial(kSeeds) - logFactorial(k) - logFactorial(kSeeds - k) + k * std::log(p) +
                        (kSeeds - k) * std::log1p(-p));
    }
    return sum;
}

/// 95 % lies in the exact (Clopper–Pearson) 99.9 % interval of the count, and at least 92 % were observed.
bool accepted(int covered) {
    const bool notTooFew = binomialBelow(covered, 0.95) > 0.0005,
               notTooMany = 1.0 - binomialBelow(covered - 1, 0.95) > 0.0005;
    return notTooFew && notTooMany && covered >= 0.92 * kSeeds;
}

struct Covered {
    int threshold = 0, width = 0, unfitted = 0;
};

template <class Fit> Covered simulate(bool fromPriors, double eta, Fit&& fit) {
    Covered covered;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        core::Random random = core::Random::stream(static_cast<std::uint64_t>(seed), "coverage of intervals");
        const FitResult observer = observerOf(random, fromPriors);
        const FitResult found = fit(answersOf(random, observer, fromPriors ? observer.best.eta : eta));
        const auto inside = [](const FitInterval& interval, double truth) {
            return interval.low <= truth && truth <= interval.high;
        };
        covered.threshold += inside(found.ci.threshold, observer.best.threshold) ? 1 : 0;
        covered.width += inside(found.ci.width, observer.best.width) ? 1 : 0;
        covered.unfitted += found.fitted ? 0 : 1;
    }
    return covered;
}

void print(const char* what, const Covered& covered) {
    std::printf("| %s | threshold %.1f %% | width %.1f %% | not fitted %d |\n", what,
                100.0 * covered.threshold / kSeeds, 100.0 * covered.width / kSeeds, covered.unfitted);
    std::fflush(stdout);
}

} // namespace

/// 2,000 seeds of 10 levels × 20 trials of 2AFC, the observer drawn anew each time.
class TestFitCoverage : public QObject {
    Q_OBJECT
private slots:
    void observersFromThePriors();
    void overdispersedAnswers();
    void binomialAnswers();
    void profileIntervals();
};

/// A posterior is right when its intervals hold what the priors say they hold.
void TestFitCoverage::observersFromThePriors() {
    FitOptions theirs; // the priors that they come from: neither too few nor too many
    theirs.widthPrior = WidthPrior::psignifit;
    const Covered covered =
        simulate(true, 0.0, [&](const PsychometricData& data) { return fitBayesian(data, theirs); });
    print("Bayesian, observers and overdispersion from the priors", covered);
    QCOMPARE(covered.unfitted, 0);
    QVERIFY(accepted(covered.threshold));
    QVERIFY(accepted(covered.width));
    // What is opened where the prior would decide holds what it held before, and more.
    const Covered opened =
        simulate(true, 0.0, [](const PsychometricData& data) { return fitBayesian(data, FitOptions{}); });
    print("Bayesian, the same observers, a prior that opens", opened);
    QCOMPARE(opened.unfitted, 0);
    QVERIFY(opened.threshold >= covered.threshold && opened.width >= covered.width);
}

void TestFitCoverage::overdispersedAnswers() {
    const Covered covered =
        simulate(false, 0.2, [](const PsychometricData& data) { return fitBayesian(data, FitOptions{}); });
    print("Bayesian, overdispersion 0.2", covered);
    QVERIFY(covered.threshold >= 0.92 * kSeeds && covered.width >= 0.92 * kSeeds);
    QEXPECT_FAIL("",
                 "observed 92.5 %: psignifit's prior expects less overdispersion (mean 0.09) than these "
                 "observers have",
                 Continue);
    QVERIFY(accepted(covered.threshold));
}

void TestFitCoverage::binomialAnswers() {
    FitOptions options;
    options.overdispersion = false;
    const Covered covered =
        simulate(false, 0.0, [&](const PsychometricData& data) { return fitBayesian(data, options); });
    print("Bayesian, binomial answers and model", covered);
    QVERIFY(accepted(covered.threshold));
    QVERIFY(covered.width >= 0.92 * kSeeds);
}

void TestFitCoverage::profileIntervals() {
    FitOptions options;
    options.lapse = Asymptote::fixedAt(kLapse);
    const Covered covered = simulate(
        false, 0.0, [&](const PsychometricData& data) { return fitMaximumLikelihood(data, options); });
    print("maximum likelihood, profile, lapse known", covered);
    QVERIFY(accepted(covered.threshold));
    QVERIFY(covered.width >= 0.92 * kSeeds);
}

QTEST_GUILESS_MAIN(TestFitCoverage)
#include "test_fit_coverage.moc"
