// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/posterior_model.h"

#include <QtTest>

#include <algorithm>
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
    options.widthPrior = WidthPrior::psignifit;
    return options;
}

/// Log of the posterior density at parameters in given units, up to the constant of FitResult::logPosterior.
double logPosteriorAt(const Case& at, const CurveParameters& given) {
    const FitOptions options = optionsOf(at);
    const StimulusScale scale = ownScale(at.function);
    const PreparedLevels levels = prepareLevels(at.data, scale);
    const FreeParameters free = freeParameters(options);
    const PosteriorModel model{
        levels, at.function, priorsFor(levels, options, scale), free, 0.0, options.guess.value, true};
    return model.logDensity({(given.threshold - levels.centre) / levels.range, given.width / levels.range,
                             given.lapse, given.guess, given.eta});
}

} // namespace

class TestFitPosterior : public QObject {
    Q_OBJECT
private slots:
    void modeIsTheHighest();
    void intervalsAreTheIntegrals();
    void sharesWithoutInformationKeepTheirPrior();
    void manyTrialsNarrowTheInterval();
    void decadesOnALinearAxis();
    void steepAndFlatObservers_data();
    void steepAndFlatObservers();
    void influenceOfThePrior();
    void anOpenEndDrawsInNoOther();
};

/// Places that long searches from outside found (simplex climbs from hundreds of starts): no place is higher
/// than what is reported.
void TestFitPosterior::modeIsTheHighest() {
    const std::vector<double> uneven{0.361, 0.742, 0.81,  0.935, 0.983, 1.01,  1.088, 1.398, 1.404,
                                     1.493, 1.587, 1.716, 1.842, 1.89,  2.078, 2.116, 2.414, 2.588,
                                     2.687, 3.029, 3.1,   3.332, 3.478, 3.765, 3.919};
    const std::vector<double> twins{0.3019179673, 0.5092309707, 0.8833577023, 0.9807979329,
                                    1.6605318301, 1.6687599915, 2.2433761881, 3.1920232364,
                                    3.4414585613, 3.6122463686, 3.6452733747, 3.8409867668};
    const std::vector<std::pair<Case, CurveParameters>> cases{
        {{"a step before two near levels", counts(twins, {1, 0, 1, 1, 9, 10, 9, 10, 10, 10, 10, 10}, 10),
          Sigmoid::gauss, Asymptote::fitted()},
         {1.6539, 0.016396, 0.0127, 0.0612, 0.0}},
        {{"few lapses", counts(kEven, {2, 0, 2, 5, 4}, 5), Sigmoid::rgumbel, Asymptote::fitted()},
         {1.785, 1.275, 0.0416, 0.1045, 0.0}},
        {{"no overdispersion", counts(kEven, {3, 3, 9, 3, 38}, 40), Sigmoid::hyperbolic,
          Asymptote::fixedAt(0.1)},
         {2.696, 0.8689, 0.0, 0.1, 0.0}},
        {{"decades on a linear axis", counts({1, 10, 100, 1000, 10000}, {11, 15, 19, 28, 29}, 30),
          Sigmoid::gauss, Asymptote::fixedAt(0.5)},
         {103.1, 18.61, 0.0435, 0.5, 0.0}},
        {{"many levels, many lapses",
          counts(uneven, {6, 5, 3, 6, 6, 8, 8, 5, 3, 9, 5, 10, 5, 8, 9, 9, 8, 7, 6, 8, 6, 10, 8, 8, 10}, 10),
          Sigmoid::tdist, Asymptote::fixedAt(0.5)},
         {1.454, 0.0122, 0.2, 0.5, 0.0}}};
    for (const auto& [at, known] : cases) {
        const FitResult fit = fitBayesian(at.data, optionsOf(at));
        const double there = logPosteriorAt(at, known);
        QVERIFY2(
            fit.logPosterior > there - 1e-5,
            qPrintable(QStringLiteral("%1: %2, known %3").arg(at.name).arg(fit.logPosterior).arg(there)));
        QVERIFY(std::abs(logPosteriorAt(at, fit.best) - fit.logPosterior) <
                1e-9 * std::abs(fit.logPosterior));
    }
}

/// Means and interval ends of a chain of 6 million steps (differential evolution, 100 walkers), to 2.5 % of
/// the interval: more than its noise.
void TestFitPosterior::intervalsAreTheIntegrals() {
    struct Known {
        Case at;
        FitInterval threshold, width, guess; ///< thresholds on the fitted axis
        double meanWidth;
    };
    const std::vector<double> gap{0.4906636386, 0.5207731454, 0.8984970662, 2.1085163006,
                                  2.2457047500, 2.3044747749, 2.6738953694, 2.6851964450,
                                  2.8108047792, 2.8322613276, 3.1527049042, 3.2037784628};
    const std::vector<Known> cases{
        {{"between two far levels",
          counts(gap, {43, 41, 37, 192, 196, 191, 191, 190, 188, 187, 190, 192}, 200), Sigmoid::logistic,
          Asymptote::fitted()},
         {1.031, 1.964},
         {0.02843, 0.8694},
         {0.1622, 0.2346},
         0.33364},
        {{"width and lapse go together",
          counts({0.408129353, 0.770529633, 1.731711857, 1.733197136, 1.844692443}, {27, 56, 117, 120, 136},
                 200),
          Sigmoid::logistic, Asymptote::equalToLapse()},
         {1.342, 1.627},
         {1.433, 3.72},
         {},
         2.8145},
        {{"one level against the rest", counts(kEven, {7, 7, 9, 7, 35}, 40), Sigmoid::logn,
          Asymptote::fitted()},
         {0.7337, 1.233},
         {0.2915, 3.717},
         {0.0444, 0.2493},
         0.78416}};
    for (const Known& known : cases) {
        const FitResult fit = fitBayesian(known.at.data, optionsOf(known.at));
        const auto like = [&](const char* what, const FitInterval& got, const FitInterval& expected) {
            const double allowed = 0.025 * (expected.high - expected.low);
            const QString words = QStringLiteral("%1, %2: %3 to %4, expected %5 to %6")
                                      .arg(known.at.name, what)
                                      .arg(got.low)
                                      .arg(got.high)
                                      .arg(expected.low)
                                      .arg(expected.high);
            QVERIFY2(std::abs(got.low - expected.low) < allowed &&
                         std::abs(got.high - expected.high) < allowed,
                     qPrintable(words));
        };
        like("threshold",
             {toScale(fit.ci.threshold.low, fit.scale), toScale(fit.ci.threshold.high, fit.scale)},
             known.threshold);
        like("width", fit.ci.width, known.width);
        if (!std::isnan(known.guess.low)) {
            like("guess", fit.ci.guess, known.guess);
        }
        QVERIFY2(std::abs(fit.mean.width - known.meanWidth) < 0.01 * known.meanWidth,
                 qPrintable(QStringLiteral("%1: %2").arg(known.at.name).arg(fit.mean.width)));
    }
}

void TestFitPosterior::steepAndFlatObservers_data() {
    QTest::addColumn<double>("width");
    QTest::addColumn<bool>("within"); // psignifit's prior allows for it
    for (const double width : {0.001, 0.05, 0.10, 0.14, 0.17, 0.20, 0.25, 2.0, 2.7})
        QTest::addRow("width %g", width) << width << (width > 0.18 && width < 2.5);
}

/// Eight levels of 40 trials at a spacing of 0.143: psignifit's prior has nothing below that width, and
/// nearly nothing at 2.7 of the range, so that its intervals hold none of the observers beyond it (1 of 40 at
/// 0.17). 12 fresh answers each: at least 9 held (fewer by chance: 1 in 4,000), and those beyond are warned.
void TestFitPosterior::steepAndFlatObservers() {
    QFETCH(double, width);
    QFETCH(bool, within);
    constexpr int kRuns = 12;
    int held = 0, heldByPsignifit = 0, warned = 0;
    for (int seed = 1; seed <= kRuns; ++seed) {
        auto random = chiron::core::Random::stream(static_cast<std::uint64_t>(seed), "steep and flat");
        FitResult observer;
        observer.function = Sigmoid::gauss;
        observer.best = {random.uniform(0.4, 0.6), width, 0.02, 0.5, 0.0};
        PsychometricData data;
        for (int i = 0; i < 8; ++i) {
            double right = 0.0;
            for (int trial = 0; trial < 40; ++trial)
                right += random.uniform() < proportionAt(observer, i / 7.0) ? 1.0 : 0.0;
            data.x.push_back(i / 7.0);
            data.k.push_back(right);
            data.n.push_back(40.0);
        }
        FitOptions options;
        options.overdispersion = false; // a tenth of the time, and the same answer
        const FitResult fit = fitBayesian(data, options);
        options.widthPrior = WidthPrior::psignifit;
        const FitResult narrow = fitBayesian(data, options);
        QCOMPARE(fit.best.width, narrow.best.width);
        QCOMPARE(fit.mean.threshold, narrow.mean.threshold);
        held += fit.ci.width.low <= width && width <= fit.ci.width.high ? 1 : 0;
        heldByPsignifit += narrow.ci.width.low <= width && width <= narrow.ci.width.high ? 1 : 0;
        warned += fit.warnings.empty() || narrow.warnings.empty() ? 0 : 1;
    }
    qInfo("width %g: %d of %d held (psignifit's prior %d), %d warned", width, held, kRuns, heldByPsignifit,
          warned);
    QVERIFY(held >= 9);
    QVERIFY(within || (heldByPsignifit <= 5 && warned >= 11));
}

/// 1 where nothing was answered to speak of, near 0 after thousands of answers; not a number of what is
/// fixed.
void TestFitPosterior::influenceOfThePrior() {
    FitOptions options;
    options.overdispersion = false;
    options.lapse = Asymptote::fixedAt(0.02);
    const FitResult few = fitBayesian({{1, 2, 3, 4, 5}, {1, 0, 1, 1, 1}, {1, 1, 1, 1, 1}}, options);
    const FitResult many =
        fitBayesian({{1, 2, 3, 4, 5}, {5010, 5630, 7420, 9210, 9780}, {1e4, 1e4, 1e4, 1e4, 1e4}}, options);
    QVERIFY2(few.priorInfluence.threshold > 0.8 && few.priorInfluence.threshold < 1.2,
             qPrintable(QString::number(few.priorInfluence.threshold)));
    QVERIFY(few.priorInfluence.width > 0.7 && few.priorInfluence.width < 1.2);
    QVERIFY(std::any_of(few.warnings.begin(), few.warnings.end(),
                        [](const std::string& w) { return w.starts_with("prior_decides: "); }));
    QVERIFY(many.priorInfluence.threshold < 0.03 && many.priorInfluence.width < 0.05);
    QVERIFY(std::isnan(many.priorInfluence.lapse) && std::isnan(many.priorInfluence.eta));
}

/// Answers near chance everywhere, with guess and lapses free: an interval of the open prior alone begins
/// above the likeliest curve (width 8.3, from 19 on).
void TestFitPosterior::anOpenEndDrawsInNoOther() {
    FitOptions options;
    options.guess = Asymptote::fitted();
    const PsychometricData flat = counts({0, 1, 2, 3, 4, 5, 6, 7}, {20, 21, 20, 19, 21, 22, 24, 27}, 40);
    const FitResult both = fitBayesian(flat, options);
    QCOMPARE(both.intervalPrior, WidthPrior::openAbove);
    options.widthPrior = WidthPrior::psignifit;
    const FitResult own = fitBayesian(flat, options);
    options.widthPrior = WidthPrior::openAbove;
    const FitResult open = fitBayesian(flat, options);
    QVERIFY(open.ci.width.low > both.width && both.ci.width.low <= both.width &&
            both.width <= both.ci.width.high);
    QCOMPARE(both.ci.width.low, own.ci.width.low);
    QCOMPARE(both.ci.width.high, open.ci.width.high);
    QCOMPARE(both.ci.threshold.low, std::min(own.ci.threshold.low, open.ci.threshold.low));
    QCOMPARE(both.ci.threshold.high, std::max(own.ci.threshold.high, open.ci.threshold.high));
}

/// One trial a level says nothing of overdispersion: its interval is that of Beta(1, 10).
void TestFitPosterior::sharesWithoutInformationKeepTheirPrior() {
    for (const Asymptote guess : {Asymptote::fixedAt(0.5), Asymptote::fitted(), Asymptote::equalToLapse()}) {
        const Case at{"one trial each", counts({1, 2, 3, 4, 5, 6, 7, 8}, {0, 1, 0, 0, 1, 1, 1, 1}, 1),
                      Sigmoid::gauss, guess};
        const FitResult fit = fitBayesian(at.data, optionsOf(at));
        QVERIFY2(std::abs(fit.ci.eta.low - (1.0 - std::pow(0.975, 0.1))) < 2e-4,
                 qPrintable(QString::number(fit.ci.eta.low)));
        QVERIFY2(std::abs(fit.ci.eta.high - (1.0 - std::pow(0.025, 0.1))) < 2e-3,
                 qPrintable(QString::number(fit.ci.eta.high)));
        QVERIFY(std::abs(fit.mean.eta - 1.0 / 11.0) < 5e-4);
    }
}

/// Where answers lie on a curve, the threshold's interval narrows with the root of the number of trials,
/// however many.
void TestFitPosterior::manyTrialsNarrowTheInterval() {
    FitResult curve;
    curve.function = Sigmoid::gauss;
    curve.best = {3.0, 2.5, 0.02, 0.5, 0.0};
    double last = 0.0;
    for (const double n : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9}) {
        std::vector<double> right;
        for (const double x : {1.0, 2.0, 3.0, 4.0, 5.0}) {
            right.push_back(std::round(n * proportionAt(curve, x)));
        }
        const FitResult fit = fitBayesian(counts({1, 2, 3, 4, 5}, right, n), FitOptions{});
        const double half = 0.5 * (fit.ci.threshold.high - fit.ci.threshold.low);
        QVERIFY2(fit.ci.threshold.low < 3.0 && 3.0 < fit.ci.threshold.high, qPrintable(QString::number(n)));
        QVERIFY2(last == 0.0 || (half > 0.25 * last && half < 0.55 * last),
                 qPrintable(QStringLiteral("%1: %2 after %3").arg(n).arg(half).arg(last)));
        last = half;
        if (n == 1e5 || n == 1e6) { // chains: 0.031 and 0.012
            QVERIFY2(std::abs(half / (n == 1e5 ? 0.031 : 0.012) - 1.0) < 0.08,
                     qPrintable(QString::number(half)));
        }
        if (n == 1e4 || n == 1e9) { // a free guess hardly bounds the overdispersion: a wide tail under a peak
                                    // up to e^40 times as high
            FitOptions freeGuess;
            freeGuess.guess = Asymptote::fitted();
            const FitResult both = fitBayesian(counts({1, 2, 3, 4, 5}, right, n), freeGuess);
            QVERIFY2(both.ci.threshold.low < 1.5 && both.ci.threshold.high > 3.0 && both.ci.width.high > 6.0,
                     qPrintable(QString::number(both.ci.threshold.low)));
        }
    }
}

/// A narrow peak among the lowest of eleven doublings and a wide tail: mass is found in both (chain:
/// width 2.3 to 594, overdispersion to 0.43).
void TestFitPosterior::decadesOnALinearAxis() {
    const Case at{"doublings",
                  counts({1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024},
                         {12, 22, 28, 30, 30, 30, 29, 30, 29, 30, 29}, 30),
                  Sigmoid::logistic, Asymptote::fixedAt(0.25)};
    const FitResult fit = fitBayesian(at.data, optionsOf(at));
    QVERIFY2(std::abs(fit.ci.width.low - 2.27) < 0.1 && std::abs(fit.ci.width.high - 594.0) < 60.0,
             qPrintable(QString::number(fit.ci.width.high)));
    QVERIFY2(std::abs(fit.ci.threshold.low + 251.0) < 25.0 && std::abs(fit.ci.threshold.high - 2.37) < 0.1,
             qPrintable(QString::number(fit.ci.threshold.low)));
    QVERIFY(std::abs(fit.ci.eta.high - 0.431) < 0.01);
    const auto told = [](const FitResult& of) {
        return std::any_of(of.warnings.begin(), of.warnings.end(),
                           [](const std::string& words) { return words.rfind("uneven_levels: ", 0) == 0; });
    };
    FitOptions logarithmic = optionsOf(at);
    logarithmic.scale = StimulusScale::ln;
    QVERIFY(told(fit) && !told(fitBayesian(at.data, logarithmic)));
}

QTEST_GUILESS_MAIN(TestFitPosterior)
#include "test_fit_posterior.moc"
