// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_fit.h"

#include "psychophysics/fits/fit.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

constexpr double kPoorFit = 0.01;
constexpr double kTrialsForChiSquare = 5.0; ///< a level on average; else chi-square says nothing about the deviance

bool saysYes(Task task) { return task == Task::yesNo || task == Task::sameDifferent; }

PsychometricData dataOf(const ScoredAnswers& answers, bool positiveOnly) {
    PsychometricData data;
    for (const CurvePoint& point : answers.points) {
        if (positiveOnly && !(point.difference > 0.0))
            continue;
        data.x.push_back(point.difference);
        data.k.push_back(point.right);
        data.n.push_back(point.of);
    }
    return data;
}

FitOptions optionsOf(Task task, bool positive) {
    FitOptions options;
    options.function = Sigmoid::gauss;
    options.scale = positive ? StimulusScale::log10 : StimulusScale::linear;
    options.guess = saysYes(task) ? Asymptote::fitted() : Asymptote::fixedAt(task == Task::rank3 ? 1.0 / 6.0 : 1.0 / answers(task));
    options.largestAsymptote = 0.3;
    return options;
}

/// D at the criterion of a threshold and width taken as they are, without lapses.
double at(const FitResult& fit, CurveParameters parameters, double threshold, double criterion) {
    parameters.threshold = toScale(threshold, fit.scale);
    parameters.lapse = 0.0;
    return thresholdAt(fit, parameters, criterion);
}

bool meet(const Interval& a, const Interval& b) { return !(a.high < b.low) && !(b.high < a.low); }

std::string tokenOf(const std::string& warning) { return warning.substr(0, warning.find(':')); }

/// What the fit says of the answers is passed on; what it says of its own lapse and slope is not: the estimate is not taken from it.
bool concernsTheAnswers(const std::string& token) { return token == "no_rise" || token == "not_monotone"; }

void addWarnings(RunEstimate& result, const FitResult& fit) {
    for (const std::string& warning : fit.warnings) {
        if (!concernsTheAnswers(tokenOf(warning)))
            continue;
        const auto same = [&](const std::string& known) { return tokenOf(known) == tokenOf(warning); };
        if (std::none_of(result.warnings.begin(), result.warnings.end(), same))
            result.warnings.push_back(warning);
    }
    if (result.pValue < kPoorFit)
        result.warnings.emplace_back("poor_fit: the curve does not describe the answers; attention or strategy may have changed");
    const bool both = std::isfinite(result.fitThreshold95.low) && std::isfinite(result.threshold95.low);
    if (both && !meet(result.fitThreshold95, result.threshold95))
        result.warnings.emplace_back("curves_disagree: the free curve puts the threshold elsewhere than the Thurstone observer");
}

} // namespace

void takeFit(RunEstimate& result, Task task, const ScoredAnswers& answers) {
    const bool positive = !answers.points.empty() && !saysYes(task) && answers.points.front().difference > 0.0;
    const PsychometricData data = dataOf(answers, positive);
    if (data.x.size() < 2 || answers.levels < 2)
        return;
    const FitResult fit = fitMaximumLikelihood(data, optionsOf(task, positive));
    if (!fit.fitted)
        return addWarnings(result, fit);
    result.fitThreshold = at(fit, fit.best, fit.threshold, result.criterion);
    result.fitThreshold95 = {at(fit, fit.best, fit.ci.threshold.low, result.criterion), at(fit, fit.best, fit.ci.threshold.high, result.criterion)};
    result.deviance = fit.deviance;
    if (result.trials >= kTrialsForChiSquare * static_cast<double>(data.x.size()))
        result.pValue = fit.pValue;
    addWarnings(result, fit);
}

} // namespace chiron::psychophysics
