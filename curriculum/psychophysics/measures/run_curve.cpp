// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_curve.h"

#include "psychophysics/measures/exact_tests.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace chiron::psychophysics {

namespace {

constexpr int kCurvePoints = 41;

void sample(RunEstimate& result, Task task, double x, const ThurstonePosterior& posterior) {
    std::vector<double> values;
    values.reserve(posterior.draws.size());
    for (const ThurstonePoint& draw : posterior.draws)
        values.push_back(answerProbability(task, x, kindOfCurve(task), draw));
    std::sort(values.begin(), values.end());
    result.curveDifference.push_back(x);
    result.curveProportion.push_back(quantileOf(values, 0.5));
    result.curveLow.push_back(quantileOf(values, 0.025));
    result.curveHigh.push_back(quantileOf(values, 0.975));
}

/// Returns D at which the observer without lapses reaches the criterion; NaN if that is below the curve's
/// start or beyond 12 log10 units.
double thresholdOf(Task task, ThurstonePoint observer, double criterion) {
    observer.lapse = 0.0;
    const auto at = [&](double x) { return answerProbability(task, x, kindOfCurve(task), observer); };
    double low = task == Task::yesNo ? -12.0 : 0.0;
    double high = 12.0;
    if (!(at(low) < criterion) || !(at(high) > criterion))
        return std::numeric_limits<double>::quiet_NaN();
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (at(middle) < criterion ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

void takeThreshold(RunEstimate& result, Task task, const ThurstonePosterior& posterior) {
    std::vector<double> values;
    if (task == Task::yesNo || task == Task::sameDifferent || task == Task::rank3Ties) {
        for (const ThurstonePoint& draw : posterior.draws)
            values.push_back(thresholdOf(task, draw, result.criterion));
    } else { // the threshold is proportional to σ
        const double ofUnit = thresholdOf(task, ThurstonePoint{}, result.criterion);
        result.threshold = ofUnit * result.sigma_log10;
        result.threshold95 = {ofUnit * result.sigma95.low, ofUnit * result.sigma95.high};
        return;
    }
    if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
        return;
    std::sort(values.begin(), values.end());
    result.threshold = quantileOf(values, 0.5);
    result.threshold95 = {quantileOf(values, 0.025), quantileOf(values, 0.975)};
}

} // namespace

int kindOfCurve(Task task) noexcept {
    if (ranksThree(task))
        return 0;
    return task == Task::yesNo || task == Task::sameDifferent ? 3 : 1;
}

double quantileOf(const std::vector<double>& sorted, double share) noexcept {
    if (sorted.empty())
        return std::numeric_limits<double>::quiet_NaN();
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double part = place - static_cast<double>(below);
    return part > 0.0 ? sorted[below] + part * (sorted[above] - sorted[below]) : sorted[below];
}

double quantileErrorOf(const std::vector<double>& sorted, double share) {
    if (sorted.size() < 2)
        return std::numeric_limits<double>::quiet_NaN();
    const auto n = static_cast<double>(sorted.size());
    const double a = share * (n + 1.0), b = (1.0 - share) * (n + 1.0);
    // How often each value is the quantile of a bootstrap sample
    std::vector<double> weight(sorted.size());
    double below = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double upTo = betaRegularised(static_cast<double>(i + 1) / n, a, b);
        weight[i] = upTo - below;
        below = upTo;
        mean += weight[i] * sorted[i];
    }
    double variance = 0.0;
    for (std::size_t i = 0; i < sorted.size(); ++i)
        variance += weight[i] * (sorted[i] - mean) * (sorted[i] - mean);
    return std::sqrt(std::max(0.0, variance));
}

void takeCurve(RunEstimate& result, Task task, const ScoredAnswers& answers,
               const ThurstonePosterior& posterior) {
    if (answers.points.empty() || posterior.draws.empty())
        return;
    const double low = std::min(0.0, 1.1 * answers.points.front().difference);
    const double high = std::max(0.0, 1.1 * answers.points.back().difference);
    for (int i = 0; i < kCurvePoints; ++i)
        sample(result, task, low + (high - low) * i / (kCurvePoints - 1), posterior);
    takeThreshold(result, task, posterior);
}

} // namespace chiron::psychophysics
