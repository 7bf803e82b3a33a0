// SPDX-License-Identifier: GPL-3.0-or-later
// Fits of many kinds of answers with every option, and the parts they are made of, figure by figure against
// what was kept: the published cases show that fits are right, these that nothing of them changes unsaid
// (what data carry badly, bounds, warnings, rarely used options).
#include "support/kept_figures.h"

#include "core/random.h"
#include "psychophysics/fits/beta_binomial.h"
#include "psychophysics/fits/binomial_sampler.h"
#include "psychophysics/fits/chi_square.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/fit_priors.h"
#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/likelihood_search.h"
#include "psychophysics/fits/limit_curves.h"
#include "psychophysics/fits/model_comparison.h"
#include "psychophysics/fits/posterior_axes.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <limits>
#include <map>

using namespace chiron;
using namespace psychophysics;
using tests::Figures;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/psychophysics/data/kept_fits.txt");

PsychometricData rising() {
    return {{1, 2, 3, 4, 5, 6, 7, 8}, {21, 22, 25, 29, 31, 36, 38, 39}, {40, 40, 40, 40, 40, 40, 40, 40}};
}
PsychometricData yesNo() {
    return {{-3, -2, -1, 0, 1, 2, 3}, {2, 3, 8, 14, 23, 27, 29}, {30, 30, 30, 30, 30, 30, 30}};
}
PsychometricData positive() {
    return {{0.05, 0.1, 0.2, 0.4, 0.8, 1.6}, {11, 13, 15, 21, 23, 23}, {24, 24, 24, 24, 24, 24}};
}

/// Answers one by one, unordered, at places that come again.
PsychometricData oneByOne(int trials, double spread, double guess, std::uint64_t seed) {
    core::Random random(seed);
    PsychometricData data;
    for (int i = 0; i < trials; ++i) {
        const double x = 0.5 * std::floor(random.uniform(-6.0, 6.0));
        data.x.push_back(x);
        data.k.push_back(
            random.uniform() < guess + (1.0 - guess - 0.03) * 0.5 * std::erfc(-(x - 0.4) / spread) ? 1.0
                                                                                                   : 0.0);
        data.n.push_back(1.0);
    }
    return data;
}

/// More places than are fitted.
PsychometricData manyPlaces() {
    core::Random random(11);
    PsychometricData data;
    for (int i = 0; i < 400; ++i) {
        const double x = random.uniform(0.0, 10.0);
        data.x.push_back(x);
        data.n.push_back(static_cast<double>(1 + random.below(3)));
        data.k.push_back(random.uniform() < 0.5 + 0.47 * 0.5 * std::erfc((4.5 - x) / 2.0) ? data.n.back()
                                                                                          : 0.0);
    }
    return data;
}

std::map<QString, PsychometricData> badlyCarried() {
    return {
        {QStringLiteral("step"), {{1, 2, 3, 4, 5, 6}, {5, 6, 5, 10, 10, 10}, {10, 10, 10, 10, 10, 10}}},
        {QStringLiteral("step at a level"),
         {{1, 2, 3, 4, 5, 6}, {10, 9, 17, 20, 20, 20}, {20, 20, 20, 20, 20, 20}}},
        {QStringLiteral("flat"), {{1, 2, 3, 4, 5}, {15, 14, 16, 15, 15}, {20, 20, 20, 20, 20}}},
        {QStringLiteral("falling"), {{1, 2, 3, 4, 5}, {19, 17, 15, 12, 10}, {20, 20, 20, 20, 20}}},
        {QStringLiteral("all right"), {{1, 2, 3, 4}, {10, 10, 10, 10}, {10, 10, 10, 10}}},
        {QStringLiteral("all wrong"), {{1, 2, 3, 4}, {0, 0, 0, 0}, {10, 10, 10, 10}}},
        {QStringLiteral("two levels"), {{1, 2}, {12, 19}, {20, 20}}},
        {QStringLiteral("two levels, far"), {{1e6, 1e6 + 1.0}, {12, 19}, {20, 20}}},
        {QStringLiteral("one level"), {{3, 3}, {12, 14}, {20, 20}}},
        {QStringLiteral("none"), {}},
        {QStringLiteral("unusable"),
         {{1, kNaN, 2, 3, HUGE_VAL, 4, 5, 6, 7},
          {10, 3, 25, 14, 3, -1, 2.5, 19, 0},
          {20, 4, 20, 20, 4, 20, 20, 20, 0}}},
        {QStringLiteral("overdispersed"),
         {{1, 2, 3, 4, 5, 6, 7, 8}, {20, 33, 21, 39, 22, 40, 30, 40}, {40, 40, 40, 40, 40, 40, 40, 40}}},
        {QStringLiteral("not monotone"),
         {{1, 2, 3, 4, 5, 6}, {20, 22, 39, 24, 38, 39}, {40, 40, 40, 40, 40, 40}}},
        {QStringLiteral("lapses"), {{1, 2, 3, 4, 5, 6}, {21, 19, 24, 30, 31, 29}, {40, 40, 40, 40, 40, 40}}},
        {QStringLiteral("uneven"), {{1, 1.0004, 2, 3, 4}, {21, 24, 30, 36, 39}, {40, 40, 40, 40, 40}}},
        {QStringLiteral("threshold above"), {{1, 2, 3, 4, 5}, {10, 11, 10, 12, 13}, {20, 20, 20, 20, 20}}},
        {QStringLiteral("few"), {{1, 2, 3, 4, 5}, {1, 1, 2, 2, 2}, {2, 2, 2, 2, 2}}},
        {QStringLiteral("with a 0"), {{0, 0.1, 0.3, 1, 3}, {10, 11, 15, 19, 20}, {20, 20, 20, 20, 20}}},
        {QStringLiteral("negative places"),
         {{-1, 0.1, 0.3, 1, 3}, {10, 11, 15, 19, 20}, {20, 20, 20, 20, 20}}},
        {QStringLiteral("thousands"),
         {{1, 2, 3, 4, 5, 6}, {1013, 1100, 1380, 1700, 1902, 1960}, {2000, 2000, 2000, 2000, 2000, 2000}}}};
}

void tell(Figures& out, const FitResult& fit) {
    out.add(QStringLiteral("fit"), fit.fitted, fit.threshold, fit.width, fit.lapse, fit.guess, fit.eta);
    const auto parameters = [&](const char* name, const CurveParameters& of) {
        out.add(QLatin1String(name), of.threshold, of.width, of.lapse, of.guess, of.eta);
    };
    parameters("best", fit.best);
    parameters("mean", fit.mean);
    parameters("error", fit.error);
    parameters("expected error", fit.expectedError);
    parameters("prior's part", fit.priorInfluence);
    out.add(QStringLiteral("ends"), fit.ci.threshold.low, fit.ci.threshold.high, fit.ci.width.low,
            fit.ci.width.high, fit.ci.lapse.low, fit.ci.lapse.high, fit.ci.guess.low, fit.ci.guess.high,
            fit.ci.eta.low, fit.ci.eta.high);
    out.add(QStringLiteral("goodness"), fit.thresholdWidthCovariance, fit.deviance, fit.pValue,
            fit.chiSquareP, fit.freeParameters, fit.degreesOfFreedom, fit.logLikelihood, fit.logPosterior,
            fit.aic, fit.confidence, static_cast<int>(fit.intervalPrior));
    for (std::size_t i = 0; i < fit.levels.size() && i < 10; ++i)
        out.add(QStringLiteral("level"), fit.levels[i].x, fit.levels[i].right, fit.levels[i].of,
                fit.levels[i].fitted, fit.levels[i].residual);
    for (const CurveSample& at : fit.curve)
        out.add(QStringLiteral("curve"), at.x, at.fitted, at.low, at.high);
    out.add(QStringLiteral("draws"), fit.draws.size());
    for (std::size_t i = 0; i < fit.draws.size(); i += std::max<std::size_t>(fit.draws.size() / 3, 1))
        parameters("draw", fit.draws[i]);
    if (fit.fitted) {
        out.add(QStringLiteral("derived"), proportionAt(fit, fit.threshold), proportionAt(fit, 2.0),
                thresholdAt(fit, 0.6), thresholdAt(fit, 0.75), thresholdAt(fit, 0.9, true),
                slopeAt(fit, fit.threshold), pse(fit), jnd(fit), weberFraction(fit, 4.0));
        const FitInterval of =
            intervalOf(fit, [](const CurveParameters& at) { return at.threshold + at.width; });
        out.add(QStringLiteral("of draws"), of.low, of.high);
    }
    out.say(QStringLiteral("warns"), fit.warnings);
}

const std::vector<std::pair<Asymptote, Asymptote>> kEnds{
    {Asymptote::fixedAt(0.5), Asymptote::fitted()},
    {Asymptote::fixedAt(0.0), Asymptote::fixedAt(0.02)},
    {Asymptote::fitted(), Asymptote::fitted()},
    {Asymptote::equalToLapse(), Asymptote::fitted()},
    {Asymptote::equalToLapse(), Asymptote::fixedAt(0.05)},
    {Asymptote::fitted(), Asymptote::fixedAt(0.0)}};

} // namespace

class TestKeptFits : public QObject {
    Q_OBJECT
private slots:
    void shapes();
    void tailsAndTables();
    void priors();
    void levelsAsPrepared();
    void limits();
    void axes();
    void everyFunctionAndAxis();
    void everyTreatmentOfTheEnds();
    void whatIsBadlyCarried();
    void badOptions();
    void simulated();
    void posteriors();
    void conditions();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const char* name, const Figures& figures) {
        const QString differs = m_kept.differs(QLatin1String(name), figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{kFile, tests::sameFigures};
};

void TestKeptFits::shapes() {
    Figures out;
    for (int i = 0; i < kSigmoids; ++i) {
        const auto sigmoid = static_cast<Sigmoid>(i);
        const QString name =
            QString::fromUtf8(token(sigmoid).data(), static_cast<qsizetype>(token(sigmoid).size()));
        for (const double z : {-1e3, -30.0, -2.3, -0.7, 0.0, 0.4, 1.0, 1.6, 5.0, 40.0, 1e3}) {
            const SigmoidValue s = sigmoidAt(sigmoid, z);
            out.add(name, z, s.rise, s.rest, s.slope, s.bend);
        }
        for (const double p : {0.001, 0.05, 0.3, 0.5, 0.75, 0.99})
            out.add(name + QStringLiteral(" inverse"), p, sigmoidInverse(sigmoid, p));
        out.add(name + QStringLiteral(" units"), unitsOf(sigmoid).middle, unitsOf(sigmoid).spread,
                static_cast<int>(ownScale(sigmoid)));
        for (const double unit : {-0.5, 0.1, 0.4})
            out.add(name + QStringLiteral(" share"), proportionOf(sigmoid, {0.3, 2.0, 0.04, 0.25}, unit));
    }
    for (int i = 0; i < kStimulusScales; ++i)
        for (const double x : {-1.0, 0.0, 0.01, 1.0, 7.0})
            out.add(QStringLiteral("scale"), i, x, toScale(x, static_cast<StimulusScale>(i)),
                    fromScale(x, static_cast<StimulusScale>(i)));
    for (const char* word : {"linear", "ln", "log10", "db", "dB", ""})
        out.add(QStringLiteral("scale ") + QLatin1String(word),
                stimulusScaleFromToken(word) ? static_cast<int>(*stimulusScaleFromToken(word)) : -1);
    for (const char* word : {"logistic", "weibull", "tdist", "cauchy", "auto", "psignifit", "wide"})
        out.add(QStringLiteral("token ") + QLatin1String(word),
                sigmoidFromToken(word) ? static_cast<int>(*sigmoidFromToken(word)) : -1,
                widthPriorFromToken(word) ? static_cast<int>(*widthPriorFromToken(word)) : -1);
    hold("shapes", out);
}

void TestKeptFits::tailsAndTables() {
    Figures out;
    for (const double freedom : {0.0, 1.0, 2.0, 5.0, 40.0, 300.0})
        for (const double value : {-1.0, 0.0, 0.3, 4.0, 6.5, 45.0, 320.0})
            out.add(QStringLiteral("tail"), freedom, value, chiSquareTail(value, freedom));
    for (const double confidence : {0.0, 0.5, 0.8, 0.95, 0.99, 1.0})
        out.add(QStringLiteral("quantile"), confidence, chiSquareQuantileOne(confidence),
                chiBarSquareQuantile(confidence, 0), chiBarSquareQuantile(confidence, 1),
                chiBarSquareQuantile(confidence, 2));
    for (const double n : {0.0, 1.0, 5.0, 170.0, 255.0, 256.0, 1000.0, 1e6})
        out.add(QStringLiteral("factorial"), n, logFactorial(n));
    const std::vector<double> etas{0.0, 1e-8, 0.02, 0.2, 0.7, 0.99};
    for (const auto& [right, of] : std::vector<std::pair<double, double>>{
             {0, 10}, {10, 10}, {7, 10}, {1, 1}, {130, 400}, {2500, 3000}}) {
        for (const double psi : {0.001, 0.2, 0.5, 0.93})
            for (const double eta : etas)
                out.add(QStringLiteral("beta-binomial"), right, of, psi, eta,
                        betaBinomialLog(right, of, psi, 1.0 - psi, eta));
        const BetaBinomialTable table(right, of, etas, 0.01, 0.98);
        for (const double logit : {-20.0, -4.0, -1.234, 0.0, 0.517, 3.5, 20.0}) {
            std::vector<double> sums(etas.size(), 1.0);
            table.addTo(logit, sums.data());
            out.each(QStringLiteral("table %1").arg(logit), sums);
        }
    }
    core::Random random(5);
    for (const auto& [n, p] : std::vector<std::pair<double, double>>{
             {1, 0.3}, {20, 0.0}, {20, 1.0}, {20, 0.5}, {400, 0.97}, {100'000, 0.2}}) {
        const BinomialSampler sampler(n, p);
        std::vector<double> drawn;
        for (int i = 0; i < 12; ++i)
            drawn.push_back(sampler.draw(random));
        out.each(QStringLiteral("drawn of %1 at %2").arg(n).arg(p), drawn);
    }
    hold("tails and tables", out);
}

void TestKeptFits::priors() {
    Figures out;
    const PreparedLevels levels = prepareLevels(rising(), StimulusScale::linear);
    FitOptions narrower;
    narrower.lowest = 2.5;
    narrower.highest = 11.0;
    narrower.betaPrior = 4.0;
    for (const FitOptions& options : {FitOptions{}, narrower})
        for (const WidthPrior width :
             {WidthPrior::psignifit, WidthPrior::openBelow, WidthPrior::openAbove, WidthPrior::wide}) {
            const FitPriors priors = priorsFor(levels, options, StimulusScale::linear, width);
            out.say(QStringLiteral("prior"), std::string(widthPriorToken(width)));
            out.add(QStringLiteral("ends"), priors.low, priors.high, priors.spacing, priors.beta,
                    priors.lowestThreshold(), priors.highestThreshold(), priors.lowestWidth(),
                    priors.largestWidth(), priors.fullWidthFrom(), priors.fullWidthTo());
            for (const double at : {-1.2, -0.9, -0.55, -0.2, 0.0, 0.5, 0.61, 0.9, 1.2, 3.0})
                out.add(QStringLiteral("threshold"), at, priors.logThreshold(at));
            for (const double at : {0.0, 0.0005, 0.01, 0.11, 0.16, 0.2, 0.3, 0.9, 1.5, 2.9, 4.0, 8.0, 12.0})
                out.add(QStringLiteral("width"), at, priors.logWidth(at));
            for (const double at : {0.0, 0.1, 0.5, 0.99, 1.0})
                out.add(QStringLiteral("share"), at, priors.logShare(at));
            out.add(QStringLiteral("sd"), priorThresholdSd(priors), priorLogWidthSd(priors),
                    priorShareSd(priors, 0.5), priorShareSd(priors, 1.0));
        }
    hold("priors", out);
}

void TestKeptFits::levelsAsPrepared() {
    Figures out;
    auto all = badlyCarried();
    all[QStringLiteral("one by one")] = oneByOne(60, 1.5, 0.5, 3);
    all[QStringLiteral("many")] = manyPlaces();
    all[QStringLiteral("nearly alike")] = {
        {1.0, 1.0 + 1e-13, 1.0 + 1e-11, 2.0, 2.0 - 1e-9, 3.0}, {1, 2, 3, 4, 5, 6}, {8, 8, 8, 8, 8, 8}};
    all[QStringLiteral("rows of other lengths")] = {{1, 2, 3, 4}, {1, 2, 3}, {5, 5, 5, 5, 5}};
    for (const auto& [name, data] : all)
        for (const StimulusScale scale : {StimulusScale::linear, StimulusScale::db}) {
            const PreparedLevels levels = prepareLevels(data, scale);
            out.add(name, static_cast<int>(scale), levels.size(), levels.usable(), levels.centre,
                    levels.range, levels.spacing, levels.totalRight, levels.total, levels.logCoefficients);
            for (std::size_t i = 0; i<levels.size(); i += levels.size()> 40 ? 37 : 1)
                out.add(QStringLiteral("level"), i, levels.given[i], levels.axis[i],
                        levels.usable() ? levels.unit[i] : kNaN, levels.right[i], levels.of[i]);
            out.say(QStringLiteral("warns"), levels.warnings);
        }
    for (const std::array<double, 3>& row : {std::array<double, 3>{1, 0, 0},
                                             {1, 0, 1},
                                             {1, 1, 1},
                                             {1, 2, 1},
                                             {1, -1, 1},
                                             {kNaN, 1, 2},
                                             {HUGE_VAL, 1, 2},
                                             {1, 0.5, 2},
                                             {1, 1, 2.5},
                                             {1, 1, HUGE_VAL},
                                             {1, kNaN, 3}})
        out.add(QStringLiteral("usable"), row[0], row[1], row[2], isUsableRow(row[0], row[1], row[2]));
    hold("levels", out);
}

/// Steps and no rise, information and its inverse, and what options make free.
void TestKeptFits::limits() {
    Figures out;
    for (const auto& [name, data] : badlyCarried()) {
        const PreparedLevels levels = prepareLevels(data, StimulusScale::linear);
        if (!levels.usable())
            continue;
        const LevelsView view = viewOf(levels);
        out.add(name, saturatedLogLikelihood(view));
        for (const auto& [guess, lapse] : kEnds) {
            FitOptions options;
            options.guess = guess;
            options.lapse = lapse;
            options = settled(options);
            FreeParameters free = freeParameters(options);
            out.add(QStringLiteral("free"), free.alpha, free.beta, free.lapse, free.guess, free.equal,
                    free.largestLapse, free.largestGuess, free.count());
            const double l = free.lapse ? 0.0 : options.lapse.value,
                         g = free.guess || free.equal ? 0.0 : options.guess.value;
            const StepCurve step = bestStep(view, free, l, g);
            out.add(QStringLiteral("step"), step.level, step.atLevel, step.share, step.lapse, step.guess,
                    step.logLikelihood, flatLogLikelihood(view, free, l, g));
            const UnitCurve steep = curveOf(step, view, Sigmoid::gauss);
            out.add(QStringLiteral("steep"), logLikelihood(Sigmoid::gauss, view, steep),
                    likelihoodRatioOfStep(levels, Sigmoid::logistic, free, l, g));
            const SearchResult quick = searchMaximum(Sigmoid::weibull, view, free, l, g),
                               thorough = searchThoroughly(Sigmoid::weibull, view, free, l, g);
            out.add(QStringLiteral("best"), static_cast<int>(quick.kind), quick.logLikelihood,
                    static_cast<int>(thorough.kind), thorough.logLikelihood, thorough.converged);
        }
        const UnitCurve curve{0.2, 3.0, 0.03, 0.4};
        for (const bool equal : {false, true}) {
            const Information at = informationAt(Sigmoid::logistic, view, curve, equal);
            for (std::size_t a = 0; a < 4; ++a)
                out.add(QStringLiteral("information"), at.observed[a][0], at.observed[a][1],
                        at.observed[a][2], at.observed[a][3], at.expected[a][0], at.expected[a][1],
                        at.expected[a][2], at.expected[a][3]);
            Matrix4 inverse{};
            const bool can = invertPositive(at.expected, {true, true, !equal, true}, inverse);
            for (std::size_t a = 0; a < 4 && can; ++a)
                out.add(QStringLiteral("inverse"), inverse[a][0], inverse[a][1], inverse[a][2],
                        inverse[a][3]);
        }
    }
    for (const auto& [right, of] : std::vector<std::pair<double, double>>{{0, 5}, {5, 5}, {2, 5}})
        for (const double psi : {0.0, 1e-320, 0.3, 1.0})
            out.add(QStringLiteral("of a level"), right, of, psi,
                    levelLogLikelihood(right, of, psi, 1.0 - psi));
    hold("limits", out);
}

void TestKeptFits::axes() {
    Figures out;
    for (const std::size_t nodes : {1U, 2U, 3U, 5U, 8U, 12U}) {
        const QuadratureAxis axis = panelAxis({-1.0, 0.5, 2.0, 2.5}, nodes);
        out.each(QStringLiteral("nodes"), axis.nodes);
        out.each(QStringLiteral("weights"), axis.weights);
        out.each(QStringLiteral("edges"), axis.edges());
        std::vector<double> mass;
        for (std::size_t i = 0; i < axis.size(); ++i)
            mass.push_back(axis.weights[i] * std::exp(-2.0 * axis.nodes[i] * axis.nodes[i]));
        const Marginal marginal(axis, mass);
        for (const double x : {-2.0, -1.0, -0.7, 0.0, 0.5, 0.81, 2.0, 2.2, 2.5, 3.0})
            out.add(QStringLiteral("below"), x, marginal.below(x));
        out.add(QStringLiteral("of all"), marginal.total(), marginal.low(), marginal.high());
        const Marginal other(panelAxis({0.0, 1.0, 3.0}, 4), {0.1, 0.2, 0.3, 0.1, 0.05, 0.05, 0.01, 0.01});
        for (const double share : {0.0, 0.025, 0.3, 0.5, 0.975, 1.0})
            out.add(QStringLiteral("quantile"), share, quantile({marginal}, share),
                    quantile({marginal, other}, share));
    }
    const QuadratureAxis fixed = fixedAxis(0.3);
    out.add(QStringLiteral("fixed"), fixed.fixed(), fixed.low(), fixed.high(), fixed.size());
    for (const std::size_t panels : {1U, 3U, 6U})
        out.each(QStringLiteral("shares"),
                 equalShares({0.0, 1.0, 2.0, 4.0, 9.0}, {0.1, 0.6, 0.0, 0.3}, panels));
    hold("axes", out);
}

void TestKeptFits::everyFunctionAndAxis() {
    Figures out;
    for (int i = 0; i < kSigmoids; ++i) {
        for (int scale = -1; scale < kStimulusScales; ++scale) {
            FitOptions options;
            options.function = static_cast<Sigmoid>(i);
            if (scale >= 0)
                options.scale = static_cast<StimulusScale>(scale);
            options.curvePoints = 5;
            out.say(QStringLiteral("function"),
                    std::string(token(options.function)) + " " + std::to_string(scale));
            tell(out, fitMaximumLikelihood(positive(), options));
        }
        FitOptions options;
        options.function = static_cast<Sigmoid>(i);
        options.guess = Asymptote::fixedAt(0.0);
        options.scale = StimulusScale::linear;
        tell(out, fitMaximumLikelihood(yesNo(), options));
    }
    hold("functions", out);
}

void TestKeptFits::everyTreatmentOfTheEnds() {
    Figures out;
    for (const auto& [guess, lapse] : kEnds)
        for (const double largest : {0.5, 0.06})
            for (const double confidence : {0.95, 0.8}) {
                FitOptions options;
                options.guess = guess;
                options.lapse = lapse;
                options.largestAsymptote = largest;
                options.confidence = confidence;
                options.profileIntervals = largest > 0.1 || confidence > 0.9;
                out.add(QStringLiteral("ends"), static_cast<int>(guess.rule), guess.value,
                        static_cast<int>(lapse.rule), lapse.value, largest, confidence);
                tell(out, fitMaximumLikelihood(yesNo(), options));
                tell(out, fitMaximumLikelihood(rising(), options));
                if (confidence > 0.9)
                    tell(out, fitMaximumLikelihood(oneByOne(90, 2.0, guess.value, 7), options));
            }
    hold("ends", out);
}

void TestKeptFits::whatIsBadlyCarried() {
    Figures out;
    for (const auto& [name, data] : badlyCarried())
        for (const Sigmoid function : {Sigmoid::gauss, Sigmoid::weibull}) {
            FitOptions options;
            options.function = function;
            options.curvePoints = 4;
            out.say(QStringLiteral("answers"), name.toStdString() + " " + std::string(token(function)));
            tell(out, fitMaximumLikelihood(data, options));
        }
    tell(out, fitMaximumLikelihood(manyPlaces(), {}));
    hold("badly carried", out);
}

void TestKeptFits::badOptions() {
    Figures out;
    const auto with = [&](auto change) {
        FitOptions options;
        change(options);
        out.say(QStringLiteral("problem"), optionsProblem(options));
        out.say(QStringLiteral("said"), fitMaximumLikelihood(rising(), options).warnings);
        if (!optionsProblem(options).empty() || options.betaPrior < 1.0)
            out.say(QStringLiteral("said of the posterior"), fitBayesian(rising(), options).warnings);
    };
    for (const double value : {-0.01, 0.0, 0.98, 1.0, kNaN})
        with([&](FitOptions& o) { o.guess = Asymptote::fixedAt(value); });
    for (const double value : {-0.01, 0.0, 0.49, 0.5, 1.0})
        with([&](FitOptions& o) { o.lapse = Asymptote::fixedAt(value); });
    for (const double value : {-0.1, 0.0, 0.01, 1.0, kNaN})
        with([&](FitOptions& o) { o.confidence = value; });
    for (const double value : {0.0, 0.01, 1.0, 1.01, kNaN})
        with([&](FitOptions& o) { o.largestAsymptote = value; });
    for (const double value : {0.99, kNaN})
        with([&](FitOptions& o) { o.betaPrior = value; });
    hold("bad options", out);
}

void TestKeptFits::simulated() {
    Figures out;
    for (const auto& [name, data] : std::map<QString, PsychometricData>{
             {QStringLiteral("rising"), rising()},
             {QStringLiteral("step"), badlyCarried()[QStringLiteral("step")]},
             {QStringLiteral("overdispersed"), badlyCarried()[QStringLiteral("overdispersed")]},
             {QStringLiteral("one by one"), oneByOne(50, 2.0, 0.5, 5)}})
        for (const Bootstrap bootstrap : {Bootstrap::none, Bootstrap::parametric, Bootstrap::nonparametric}) {
            FitOptions options;
            options.bootstrap = bootstrap;
            options.bootstrapSamples = 120;
            options.monteCarlo = 30;
            options.seed = 8;
            options.curvePoints = bootstrap == Bootstrap::none ? 0 : 4;
            options.confidence = 0.9;
            out.say(QStringLiteral("answers"), name.toStdString());
            tell(out, fitMaximumLikelihood(data, options));
        }
    hold("simulated", out);
}

void TestKeptFits::posteriors() {
    Figures out;
    const auto of = [&](const char* name, const PsychometricData& data, auto change) {
        FitOptions options;
        options.draws = 40;
        change(options);
        out.say(QStringLiteral("posterior"), name);
        tell(out, fitBayesian(data, options));
    };
    of("rising", rising(), [](FitOptions& o) {
        o.draws = 1000;
        o.curvePoints = 4;
    });
    of("binomial", rising(), [](FitOptions& o) {
        o.overdispersion = false;
        o.credible = CredibleMethod::projection;
    });
    of("projection", yesNo(), [](FitOptions& o) {
        o.guess = Asymptote::fixedAt(0.0);
        o.lapse = Asymptote::fixedAt(0.02);
        o.credible = CredibleMethod::projection;
    });
    of("equal", yesNo(), [](FitOptions& o) {
        o.guess = Asymptote::equalToLapse();
        o.function = Sigmoid::logistic;
        o.monteCarlo = 10;
    });
    of("both free, binomial", yesNo(), [](FitOptions& o) {
        o.guess = Asymptote::fitted();
        o.overdispersion = false;
        o.confidence = 0.8;
    });
    of("weibull", positive(), [](FitOptions& o) {
        o.function = Sigmoid::weibull;
        o.betaPrior = 3.0;
        o.overdispersion = false;
    });
    of("range given", rising(), [](FitOptions& o) {
        o.lowest = 2.0;
        o.highest = 6.0;
        o.overdispersion = false;
    });
    for (const WidthPrior prior : {WidthPrior::psignifit, WidthPrior::openBelow, WidthPrior::openAbove,
                                   WidthPrior::wide, WidthPrior::automatic})
        for (const char* name : {"step", "flat", "threshold above"})
            of(name, badlyCarried()[QLatin1String(name)], [&](FitOptions& o) {
                o.widthPrior = prior;
                o.overdispersion = false;
            });
    for (const char* name : {"overdispersed", "step at a level"})
        of(name, badlyCarried()[QLatin1String(name)], [](FitOptions&) {});
    for (const char* name :
         {"all right", "all wrong", "two levels", "uneven", "few", "none", "one level", "lapses"})
        of(name, badlyCarried()[QLatin1String(name)], [](FitOptions& o) { o.overdispersion = false; });
    hold("posteriors", out);
}

void TestKeptFits::conditions() {
    Figures out;
    const std::vector<PsychometricData> two{{{1, 2, 3, 4, 5}, {11, 13, 17, 19, 20}, {20, 20, 20, 20, 20}},
                                            {{1, 2, 3, 4, 5}, {10, 11, 13, 16, 19}, {20, 20, 20, 20, 20}}};
    const std::vector<PsychometricData> three{two[0], two[1], {{2, 4, 6}, {12, 15, 18}, {20, 20, 20}}};
    const auto tellOf = [&](const ConditionsFit& fit) {
        out.add(QStringLiteral("fit"), fit.fitted, fit.logLikelihood, fit.freeParameters, fit.aic);
        for (const CurveParameters& at : fit.conditions)
            out.add(QStringLiteral("condition"), at.threshold, at.width, at.lapse, at.guess);
        out.say(QStringLiteral("warns"), fit.warnings);
    };
    for (const auto& data : {two, three})
        for (const auto& [guess, lapse] : kEnds) {
            FitOptions options;
            options.guess = guess;
            options.lapse = lapse;
            for (int bits = 0; bits < 16; bits += data.size() == 3 ? 3 : 1)
                tellOf(fitConditions(data, options,
                                     {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0}));
        }
    const auto compare = [&](const std::vector<PsychometricData>& data, const FitOptions& options,
                             const SharedParameters& shared, const SharedParameters& tested) {
        const ModelComparison of = compareConditions(data, options, shared, tested);
        tellOf(of.smaller);
        tellOf(of.larger);
        out.add(QStringLiteral("compared"), of.likelihoodRatio, of.freedom, of.pValue, of.chiSquareP,
                of.simulated, of.aicDifference);
    };
    FitOptions drawn;
    drawn.monteCarlo = 12;
    drawn.seed = 4;
    drawn.function = Sigmoid::logistic;
    compare(two, drawn, {false, true, true, false}, {true, false, false, false});
    compare(three, drawn, {false, false, true, true}, {true, true, false, false});
    compare(three, {}, {true, false, false, false}, {true, true, true, true});
    compare({two[0]}, {}, {}, {true, false, false, false});
    compare({}, {}, {}, {true, false, false, false});
    compare({two[0], {{1}, {3}, {5}}}, {}, {}, {true, false, false, false});
    compare({two[0], badlyCarried()[QStringLiteral("step")]}, {}, {false, false, true, false},
            {false, true, false, false});
    compare({two[0], badlyCarried()[QStringLiteral("all right")], badlyCarried()[QStringLiteral("flat")]}, {},
            {false, true, false, false}, {true, false, false, false});
    hold("conditions", out);
}

QTEST_APPLESS_MAIN(TestKeptFits)
#include "test_kept_fits.moc"
