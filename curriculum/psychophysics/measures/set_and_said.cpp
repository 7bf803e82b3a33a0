// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/set_and_said.h"

#include "psychophysics/measures/adjustment_summary.h"
#include "psychophysics/measures/magnitude_estimation.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace chiron::psychophysics {

namespace {

double valueOf(const ScoredTrial& trial) {
    return trial.value.value_or(std::numeric_limits<double>::quiet_NaN());
}

double weberOfJnd(double jndLog10) {
    return std::expm1(std::numbers::ln10 * jndLog10);
}

} // namespace

void takeSettings(RunEstimate& result, const Condition& condition, const std::vector<ScoredTrial>& trials) {
    std::vector<double> settings;
    for (const ScoredTrial& trial : trials)
        settings.push_back(valueOf(trial));
    const AdjustmentSummary summary = summariseSettings(condition.stimulus.reference, settings);
    const double perSd = summary.jndLog10 / summary.sdLog10;
    result.trials = summary.settings;
    result.method = EstimateMethod::settings;
    result.warnings = summary.warnings;
    result.pse = summary.pse;
    result.pse95 = {summary.pseLow, summary.pseHigh};
    if (!(summary.sdLog10 > 0.0))
        return;
    result.sigma_log10 = summary.sdLog10 / std::numbers::sqrt2;
    result.sigma95 = {summary.sdLow / std::numbers::sqrt2, summary.sdHigh / std::numbers::sqrt2};
    result.weber = weberOfJnd(summary.jndLog10);
    result.weber95 = {weberOfJnd(perSd * summary.sdLow), weberOfJnd(perSd * summary.sdHigh)};
    result.jnd = result.weber * condition.stimulus.reference;
}

void takeMagnitudes(RunEstimate& result, const Condition& condition, const std::vector<ScoredTrial>& trials) {
    std::vector<MagnitudeAnswer> answers;
    for (const ScoredTrial& trial : trials)
        answers.push_back(
            {0, condition.stimulus.reference * std::pow(10.0, trial.difference), valueOf(trial)});
    const MagnitudeScale scale = magnitudeScale(answers);
    result.method = EstimateMethod::numbersSaid;
    result.exponent = scale.exponent;
    result.exponent95 = {scale.exponentLow, scale.exponentHigh};
    for (const SubjectPower& subject : scale.subjects)
        result.trials += subject.answers;
    for (const Warning& warning : scale.warnings)
        if (warning.kind != WarningKind::fewSubjects)
            result.warnings.push_back(warning);
    if (result.trials > 0 && result.trials < 10)
        result.warnings.push_back({WarningKind::fewNumbers, result.trials});
}

} // namespace chiron::psychophysics
