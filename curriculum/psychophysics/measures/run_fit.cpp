// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_fit.h"

#include "psychophysics/fits/binomial_sampler.h"
#include "psychophysics/fits/chi_square.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/measures/run_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace chiron::psychophysics {

namespace {

constexpr double kPoorFit = 0.01;
constexpr double kTrialsForChiSquare = 5.0; ///< per level on average; with fewer, the deviance is meaningless
constexpr double kWorthDrawing = 0.05;      ///< a smaller chi-square p is replaced by one from simulated runs
constexpr int kDraws = 1999;
constexpr std::uint64_t kDrawSeed = 1; ///< fixed, so that the same run gives the same p
/// Smallest proportion, at which one contradicting answer still has a finite deviance.
constexpr double kSmallest = 1e-9;

/// Returns whether the observer has a criterion in addition to σ.
bool hasCriterion(Task task) {
    return task == Task::yesNo || task == Task::sameDifferent || task == Task::rank3Ties;
}

bool saysYes(Task task) {
    return task == Task::yesNo || task == Task::sameDifferent;
}

/// Returns −2 ln of the likelihood ratio of ψ to a level's own proportion.
double devianceOf(double k, double n, double psi) {
    const double wrong = n - k;
    return 2.0 * ((k > 0.0 ? k * std::log(k / (n * psi)) : 0.0) +
                  (wrong > 0.0 ? wrong * std::log(wrong / (n * (1.0 - psi))) : 0.0));
}

/// Returns the share of runs simulated with the curve itself that deviate at least as much. Levels with few
/// answers do not follow chi-square.
double drawnTail(const std::vector<CurvePoint>& points, const std::vector<double>& psi, double deviance) {
    core::Random random(kDrawSeed);
    std::vector<BinomialSampler> samplers;
    for (std::size_t i = 0; i < points.size(); ++i)
        samplers.emplace_back(points[i].of, psi[i]);
    int farther = 0;
    for (int draw = 0; draw < kDraws; ++draw) {
        double sum = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
            sum += devianceOf(samplers[i].draw(random), points[i].of, psi[i]);
        farther += sum >= deviance ? 1 : 0;
    }
    return (farther + 1.0) / (kDraws + 1.0);
}

/// Fills in how far the answers are from the Thurstone observer's own curve, from which the estimate is
/// taken. σ and a criterion are fitted. The lapse rate is largely determined by its prior and is not counted
/// as a fitted parameter.
void takeGoodness(RunEstimate& result, Task task, const ScoredAnswers& answers,
                  const ThurstonePosterior& posterior) {
    const ThurstonePoint at{posterior.medianLog10Sigma, posterior.meanLapse,
                            std::isfinite(posterior.criterion) ? posterior.criterion : 0.0};
    std::vector<double> psi;
    double deviance = 0.0;
    for (const CurvePoint& point : answers.points) {
        psi.push_back(std::clamp(answerProbability(task, point.difference, kindOfCurve(task), at), kSmallest,
                                 1.0 - kSmallest));
        deviance += devianceOf(point.right, point.of, psi.back());
    }
    result.deviance = deviance;
    const auto levels = static_cast<double>(psi.size());
    const double freedom = levels - (hasCriterion(task) ? 2.0 : 1.0);
    if (!(freedom > 0.0) || result.trials < kTrialsForChiSquare * levels)
        return;
    result.pValue = chiSquareTail(deviance, freedom);
    if (result.pValue < kWorthDrawing)
        result.pValue = drawnTail(answers.points, psi, deviance);
}

/// Returns D at the criterion for a given threshold and width, without lapses.
double thresholdOfFit(const FitResult& fit, CurveParameters parameters, double threshold, double criterion) {
    parameters.threshold = toScale(threshold, fit.scale);
    parameters.lapse = 0.0;
    return thresholdAt(fit, parameters, criterion);
}

bool meet(const Interval& a, const Interval& b) {
    return !(a.high < b.low) && !(b.high < a.low);
}

/// Selects the warnings of the fit that are about the answers. Those about its own lapse rate and slope are
/// dropped, because the estimate is not taken from this fit.
std::optional<WarningKind> concernsTheAnswers(const std::string& warning) {
    for (const WarningKind kind : {WarningKind::noRise, WarningKind::notMonotone})
        if (warning.starts_with(std::string(warningToken(kind)) + ": "))
            return kind;
    return std::nullopt;
}

void addWarnings(RunEstimate& result, const FitResult& fit) {
    // Answers too few to tell from guessing do not show that there is no threshold either.
    const bool untold = hasWarning(result.warnings, WarningKind::tooFewToTell);
    for (const std::string& warning : fit.warnings)
        if (const auto kind = concernsTheAnswers(warning);
            kind && !hasWarning(result.warnings, *kind) && !(untold && *kind == WarningKind::noRise))
            result.warnings.push_back({*kind});
    if (result.pValue < kPoorFit)
        result.warnings.push_back({WarningKind::poorFit});
    const bool both = std::isfinite(result.fitThreshold95.low) && std::isfinite(result.threshold95.low);
    if (both && !meet(result.fitThreshold95, result.threshold95))
        result.warnings.push_back({WarningKind::curvesDisagree});
}

} // namespace

PsychometricData curveData(const std::vector<CurvePoint>& points, bool positive) {
    PsychometricData data;
    for (const CurvePoint& point : points) {
        if (positive && !(point.difference > 0.0))
            continue;
        data.x.push_back(point.difference);
        data.k.push_back(point.right);
        data.n.push_back(point.of);
    }
    return data;
}

FitOptions freeCurveOptions(Task task, bool positive) {
    FitOptions options;
    options.function = Sigmoid::gauss;
    options.scale = positive ? StimulusScale::log10 : StimulusScale::linear;
    options.guess = hasCriterion(task)
                        ? Asymptote::fitted()
                        : Asymptote::fixedAt(task == Task::rank3 ? 1.0 / 6.0 : 1.0 / answers(task));
    options.largestAsymptote = 0.3;
    return options;
}

bool isPositive(Task task, const std::vector<CurvePoint>& points) {
    return !points.empty() && !saysYes(task) && points.front().difference > 0.0;
}

void takeFit(RunEstimate& result, Task task, const ScoredAnswers& answers,
             const ThurstonePosterior& posterior) {
    const bool positive = isPositive(task, answers.points);
    const PsychometricData data = curveData(answers.points, positive);
    if (data.x.size() < 2 || answers.levels < 2)
        return;
    takeGoodness(result, task, answers, posterior);
    const FitResult fit = fitMaximumLikelihood(data, freeCurveOptions(task, positive));
    if (!fit.fitted)
        return addWarnings(result, fit);
    result.fitThreshold = thresholdOfFit(fit, fit.best, fit.threshold, result.criterion);
    result.fitThreshold95 = {thresholdOfFit(fit, fit.best, fit.ci.threshold.low, result.criterion),
                             thresholdOfFit(fit, fit.best, fit.ci.threshold.high, result.criterion)};
    addWarnings(result, fit);
}

} // namespace chiron::psychophysics
