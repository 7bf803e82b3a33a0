// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/run_estimate.h"

#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/run_curve.h"
#include "psychophysics/measures/run_fit.h"
#include "psychophysics/measures/run_warnings.h"
#include "psychophysics/measures/scored_answers.h"
#include "psychophysics/measures/set_and_said.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace chiron::psychophysics {

namespace {

constexpr double kJndPerSigma = 0.9538725524089398; ///< √2 z(0.75): the 75 % point of 2AFC in units of σ

constexpr double kMostTie = 3.0; ///< σ: an observer with a larger tie threshold nearly always says "equal"

/// Returns the grids of log10 σ that the condition's procedures use.
std::vector<std::vector<double>> noiseGrids(const Condition& condition) {
    std::vector<std::vector<double>> grids;
    for (const ProcedureSpec& spec : condition.procedures)
        for (const Parameter& row : kindFor(spec).rows())
            if (row.quantity == Quantity::noise)
                grids.push_back(std::get<std::vector<double>>(row.get(spec)));
    return grids;
}

/// Returns a prior from a tenth of the smallest to ten times the largest difference, extended to the whole
/// grid of the procedure. This still covers an observer whose σ is three times the end of a procedure's grid.
ThurstonePrior priorOf(const Condition& condition, const ScoredAnswers& answers) {
    ThurstonePrior prior;
    if (answers.smallestDifference > 0.0) {
        prior.lowLog10Sigma = std::log10(answers.smallestDifference) - 1.0;
        prior.highLog10Sigma = std::log10(answers.largestDifference) + 1.0;
        prior.evenUpTo = std::log10(answers.largestDifference);
    }
    for (const std::vector<double>& grid : noiseGrids(condition)) {
        if (grid.size() < 2)
            continue;
        const auto [low, high] = std::minmax_element(grid.begin(), grid.end());
        if (std::isfinite(*low) && std::isfinite(*high) && *low < *high)
            prior.lowLog10Sigma =
                std::min(answers.smallestDifference > 0.0 ? prior.lowLog10Sigma : *low, *low),
            prior.highLog10Sigma =
                std::max(answers.smallestDifference > 0.0 ? prior.highLog10Sigma : *high, *high);
    }
    if (condition.task == Task::sameDifferent)
        prior.highCriterion = 6.0;
    if (condition.task == Task::rank3Ties)
        prior.highCriterion = kMostTie;
    // From below the lowest presented value to above the highest.
    if (condition.task == Task::yesNo && !answers.points.empty()) {
        const double margin = 0.5 * answers.largestDifference;
        prior.lowCriterion = std::min(0.0, answers.points.front().difference) - margin;
        prior.highCriterion = std::max(0.0, answers.points.back().difference) + margin;
    }
    return prior;
}

/// Widens the interval for answers at a single difference. A few such answers have few possible outcomes, and
/// the prior then shapes the posterior's interval, which contains the true value for some observers in only
/// two of three runs and for some never. The interval is extended to the exact interval of the proportion
/// (Clopper & Pearson), with the posterior's mean lapse rate at the lower end and without lapses at the upper
/// end.
void widenToExact(ThurstonePosterior& posterior, const ThurstonePrior& prior, Task task,
                  const ScoredAnswers& answers) {
    if (answers.levels != 1 ||
        (task != Task::rank3 && task != Task::twoAfc && task != Task::threeAfc && task != Task::oddity))
        return;
    long long right = 0, of = 0;
    for (const CurvePoint& point : answers.points)
        if (point.difference != 0.0) {
            right += point.right;
            of += point.of;
        }
    const ProportionInterval exact = exactInterval(right, of);
    // The proportion falls as σ grows. The result is an end of the prior if no observer has this proportion.
    const auto sigmaAt = [&](double share, double lapse) {
        double low = prior.lowLog10Sigma, high = prior.highLog10Sigma;
        for (int halving = 0; halving < 60; ++halving) {
            const double between = 0.5 * (low + high);
            (answerProbability(task, answers.largestDifference, kindOfCurve(task), {between, lapse, 0.0}) >
                     share
                 ? low
                 : high) = between;
        }
        return 0.5 * (low + high);
    };
    posterior.lowLog10Sigma = std::min(posterior.lowLog10Sigma, sigmaAt(exact.high, posterior.meanLapse));
    posterior.highLog10Sigma = std::max(posterior.highLog10Sigma, sigmaAt(exact.low, 0.0));
}

void takeSigma(RunEstimate& result, const ThurstonePosterior& posterior, double reference) {
    const auto weber = [](double log10Sigma) {
        return std::expm1(std::log(10.0) * kJndPerSigma * std::pow(10.0, log10Sigma));
    };
    result.sigma_log10 = std::pow(10.0, posterior.medianLog10Sigma);
    result.sigma95 = {std::pow(10.0, posterior.lowLog10Sigma), std::pow(10.0, posterior.highLog10Sigma)};
    result.weber = weber(posterior.medianLog10Sigma);
    result.weber95 = {weber(posterior.lowLog10Sigma), weber(posterior.highLog10Sigma)};
    result.jnd = result.weber * reference;
    result.lapse = posterior.meanLapse;
}

void takeCriterion(RunEstimate& result, const ThurstonePosterior& posterior, double reference) {
    result.pse = reference * std::pow(10.0, posterior.criterion);
    result.pse95 = {reference * std::pow(10.0, posterior.lowCriterion),
                    reference * std::pow(10.0, posterior.highCriterion)};
}

void fromAnswers(RunEstimate& result, const Condition& condition, const std::vector<ScoredTrial>& trials) {
    const ScoredAnswers answers = sortAnswers(condition.task, trials);
    result.trials = answers.used;
    result.points = answers.points;
    result.method = ranksThree(condition.task) ? EstimateMethod::observerOfOrders : EstimateMethod::observer;
    const ThurstonePrior prior = priorOf(condition, answers);
    ThurstonePosterior posterior =
        answers.levels > 0 ? thurstonePosterior(condition.task, answers.counts, prior) : ThurstonePosterior{};
    if (posterior.known) {
        widenToExact(posterior, prior, condition.task, answers);
        result.priorInfluence = posterior.sdLog10Sigma / priorLog10SigmaSd(condition.task, prior);
        takeSigma(result, posterior, condition.stimulus.reference);
        if (condition.task == Task::yesNo)
            takeCriterion(result, posterior, condition.stimulus.reference);
        if (condition.task == Task::rank3Ties) {
            result.tie = posterior.criterion;
            result.tie95 = {posterior.lowCriterion, posterior.highCriterion};
        }
        takeCurve(result, condition.task, answers, posterior);
    }
    warnOfAnswers(result.warnings, condition.task, answers, posterior);
    warnOfPlaces(result.warnings, condition.task, trials);
    if (posterior.known)
        takeFit(result, condition.task, answers, posterior);
}

} // namespace

std::string_view methodText(EstimateMethod method) {
    switch (method) {
    case EstimateMethod::none:
        return {};
    case EstimateMethod::observer:
        return "posterior of a Thurstone observer over log10 sigma and lapse";
    case EstimateMethod::observerOfOrders:
        return "posterior of a Thurstone observer over log10 sigma and lapse, all orders said";
    case EstimateMethod::settings:
        return "geometric mean and standard deviation of the settings";
    case EstimateMethod::numbersSaid:
        return "log-log regression of the numbers said";
    case EstimateMethod::apexMarks:
        return "marks of an apex";
    }
    return {};
}

RunEstimate estimateRun(const Condition& condition, const std::vector<ScoredTrial>& trials,
                        std::uint64_t seed) {
    (void)seed; // nothing is drawn: the intervals come from the posterior, profiles and t
    RunEstimate result;
    result.criterion = condition.criterion;
    result.unit = std::string(unitOf(condition.stimulus.attribute));
    if (!(condition.stimulus.reference > 0.0) || !std::isfinite(condition.stimulus.reference)) {
        result.warnings.push_back({WarningKind::noReference});
        return result;
    }
    // Nothing is compared; summariseApex evaluates the marks.
    if (condition.stimulus.attribute == Attribute::apex) {
        result.method = EstimateMethod::apexMarks;
        result.trials = static_cast<int>(trials.size());
        return result;
    }
    if (condition.task == Task::adjustment)
        takeSettings(result, condition, trials);
    else if (condition.task == Task::magnitude)
        takeMagnitudes(result, condition, trials);
    else
        fromAnswers(result, condition, trials);
    return result;
}

} // namespace chiron::psychophysics
