// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/planning/study_plan.h"

#include "core/log_gamma.h"
#include "core/random.h"
#include "psychophysics/measures/run_curve.h"
#include "psychophysics/measures/sample_moments.h"
#include "psychophysics/planning/fisher_information.h"
#include "psychophysics/planning/run_simulator.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "psychophysics/study/group_estimate.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace chiron::psychophysics {

namespace {

constexpr int kFewWithoutValue = 20; ///< one run in so many
constexpr double kMostTrialsExamined = 100.0;
/// Fewer simulated runs show no rate of 1 in 20. Of 40 without any, it may still be 1 in 14 (95 %, exact).
constexpr int kLeastRuns = 40;
constexpr double kSecondsAnObject = 4.0;
constexpr double kSecondsAnAnswer = 2.0;
/// The exercise's scripted operators take 20 to 33 s (modules/exercises/sphere_apex/operators).
constexpr double kSecondsAnApex = 25.0;

void summarise(ConditionPlan& plan, const std::vector<double>& offs, std::vector<double> webers,
               const std::vector<double>& trials, int covered) {
    const SampleMoments ofTrials = momentsOf(trials), ofOffs = momentsOf(offs);
    plan.meanTrials = ofTrials.mean;
    plan.trialsError = ofTrials.sd / std::sqrt(static_cast<double>(trials.size()));
    if (offs.empty())
        return;
    const auto n = static_cast<double>(offs.size());
    plan.biasLog10 = ofOffs.mean;
    plan.sdLog10 = ofOffs.sd;
    plan.biasError = ofOffs.sd / std::sqrt(n);
    plan.sdError = ofOffs.sd / std::sqrt(2.0 * (n - 1.0)); // for normal errors
    plan.coverage = covered / n;
    const double share = (covered + 2.0) / (n + 4.0);
    plan.coverageError = std::sqrt(share * (1.0 - share) / (n + 4.0));
    std::sort(webers.begin(), webers.end());
    plan.weber10 = quantileOf(webers, 0.1);
    plan.weber50 = quantileOf(webers, 0.5);
    plan.weber90 = quantileOf(webers, 0.9);
    plan.weber10Error = quantileErrorOf(webers, 0.1);
    plan.weber50Error = quantileErrorOf(webers, 0.5);
    plan.weber90Error = quantileErrorOf(webers, 0.9);
}

void simulate(ConditionPlan& plan, const Condition& condition, const ObserverSpec& observer,
              std::uint64_t seed) {
    const auto simulator = RunSimulator::make(condition);
    if (!simulator) {
        plan.warnings.push_back({WarningKind::notSimulated, 0, 0, simulator.error().message});
        plan.runs = 0;
        return;
    }
    const double truth = std::log10(sigmaOf(observer));
    std::vector<double> offs, webers, trials;
    int covered = 0, withoutValue = 0;
    for (int run = 0; run < plan.runs; ++run) {
        const std::uint64_t runSeed = core::Random::mix(seed, "plan." + std::to_string(run));
        const std::vector<ScoredTrial> scored = simulator->run(observer, runSeed);
        trials.push_back(static_cast<double>(scored.size()));
        const RunEstimate estimate = estimateRun(condition, scored, runSeed);
        withoutValue += usableInGroup(estimate) == Usable::yes ? 0 : 1;
        if (!std::isfinite(estimate.sigma_log10) || !(estimate.sigma_log10 > 0.0)) {
            ++plan.withoutEstimate;
            continue;
        }
        offs.push_back(std::log10(estimate.sigma_log10) - truth);
        webers.push_back(estimate.weber);
        covered += estimate.weber95.low <= observer.weber && observer.weber <= estimate.weber95.high ? 1 : 0;
    }
    if (condition.stimulus.attribute != Attribute::apex)
        plan.withoutValue = withoutValue;
    summarise(plan, offs, std::move(webers), trials, covered);
}

std::uint64_t seedOf(const Condition& condition, std::uint64_t seed) {
    return core::Random::mix(seed, "condition " + condition.id);
}

/// Integrates over 0..end by Simpson's rule.
template <class Function> double integral(Function f, double end, int pieces) {
    double sum = f(0.0) + f(end);
    for (int i = 1; i < pieces; ++i)
        sum += f(end * i / pieces) * (i % 2 == 1 ? 4.0 : 2.0);
    return sum * end / pieces / 3.0;
}

double phi(double z) {
    return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

/// Returns P(T ≤ t) of the noncentral t, that is, a normal variable over the root of a chi-square divided by
/// its degrees of freedom, integrated over that root.
double noncentralT(double t, int freedom, double shift) {
    const double logScale =
        std::log(2.0) + 0.5 * freedom * std::log(0.5 * freedom) - core::logGamma(0.5 * freedom);
    const double end = 1.0 + 10.0 / std::sqrt(static_cast<double>(freedom));
    return integral(
        [&](double s) {
            return s > 0.0 ? phi(t * s - shift) *
                                 std::exp(logScale + (freedom - 1) * std::log(s) - 0.5 * freedom * s * s)
                           : (freedom == 1 ? phi(-shift) * std::exp(logScale) : 0.0);
        },
        end, 2000);
}

double criticalT(double alpha, int freedom) {
    double low = 0.0, high = 1e4;
    for (int i = 0; i < 80; ++i) {
        const double t = 0.5 * (low + high);
        (noncentralT(t, freedom, 0.0) < 1.0 - 0.5 * alpha ? low : high) = t;
    }
    return 0.5 * (low + high);
}

} // namespace

double secondsOfTrial(const Condition& condition, const TrialRules& rules) {
    double exploring = condition.stimulus.attribute == Attribute::apex
                           ? kSecondsAnApex
                           : kSecondsAnObject * placesOf(condition.task);
    if (rules.exploreLimit_s > 0.0)
        exploring = std::min(exploring, rules.exploreLimit_s);
    return exploring + kSecondsAnAnswer + rules.betweenTrials_s;
}

double minutesOf(const Condition& condition, const TrialRules& rules, double trials) {
    const double one = secondsOfTrial(condition, rules);
    const double breaks = rules.breakEvery > 0 ? std::floor(std::max(trials - 1.0, 0.0) / rules.breakEvery) *
                                                     rules.breakAtLeast_s
                                               : 0.0;
    return ((trials + rules.practiceTrials) * one + breaks) / 60.0;
}

ConditionPlan planCondition(const Condition& condition, const TrialRules& rules, const ObserverSpec& observer,
                            int runs, std::uint64_t seed) {
    ConditionPlan plan;
    plan.runs = std::max(runs, 0);
    const BestSpacing best = bestSpacing(condition.task, observer.lapse, false, observer.ties);
    plan.fisherPerTrial = best.information;
    plan.bestSpacing = best.spacing;
    if (const int row = nearestCandidate(condition.stimulus.differences, best.spacing * sigmaOf(observer));
        row >= 0)
        plan.bestDifference = condition.stimulus.differences[static_cast<std::size_t>(row)];
    if (plan.runs > 0)
        simulate(plan, condition, observer, seedOf(condition, seed));
    plan.minutes = minutesOf(condition, rules, plan.meanTrials);
    plan.minutesError = 0.5 * (minutesOf(condition, rules, plan.meanTrials + plan.trialsError) -
                               minutesOf(condition, rules, plan.meanTrials - plan.trialsError));
    if (!condition.stimulus.differences.empty() &&
        condition.stimulus.differences.back() < 0.7 * best.spacing * sigmaOf(observer))
        plan.warnings.push_back({WarningKind::differencesTooSmall});
    if (plan.withoutEstimate > 0)
        plan.warnings.push_back({WarningKind::runsWithoutEstimate, plan.withoutEstimate, plan.runs});
    return plan;
}

bool oftenWithoutValue(const ConditionPlan& plan) noexcept {
    return plan.withoutValue.value_or(0) > 0 && kFewWithoutValue * *plan.withoutValue >= plan.runs;
}

std::optional<Condition> withTrials(Condition condition, int trials) {
    const int procedures = std::max(1, static_cast<int>(condition.procedures.size()));
    for (ProcedureSpec& procedure : condition.procedures)
        if (!kindFor(procedure).endAfter(procedure, std::max(1, trials / procedures)))
            return std::nullopt;
    return condition;
}

void examineLength(ConditionPlan& plan, const Condition& condition, const ObserverSpec& observer,
                   std::uint64_t seed) {
    constexpr double kLonger = 1.5;
    if (!oftenWithoutValue(plan) || plan.runs < kLeastRuns)
        return;
    int candidate = 0;
    for (double trials = kLonger * plan.meanTrials;
         trials > 1.0 && (candidate > 0 || trials <= kMostTrialsExamined); trials *= kLonger) {
        const auto longer = withTrials(condition, static_cast<int>(std::lround(trials)));
        if (!longer)
            return;
        ConditionPlan again;
        again.runs = plan.runs;
        simulate(again, *longer, observer, seedOf(condition, seed));
        const bool enough = again.runs > 0 && !oftenWithoutValue(again);
        if (enough && candidate > 0) { // the length before was no chance
            plan.trialsForValues = candidate;
            return;
        }
        candidate = enough ? static_cast<int>(std::lround(again.meanTrials)) : 0;
    }
}

double power(const PowerQuestion& question) {
    const int n = question.participants;
    if (n < 2)
        return 0.0;
    const double runs = 2.0 * question.runSdLog10 * question.runSdLog10;
    const double people = question.paired ? question.effectSdLog10 * question.effectSdLog10
                                          : 2.0 * question.personSdLog10 * question.personSdLog10;
    const double sd = std::sqrt(runs + people);
    if (!(sd > 0.0))
        return question.differenceLog10 != 0.0 ? 1.0 : question.alpha;
    const int freedom = question.paired ? n - 1 : 2 * (n - 1);
    const double shift = std::abs(question.differenceLog10) / sd * std::sqrt(static_cast<double>(n));
    const double critical = criticalT(question.alpha, freedom);
    return std::clamp(1.0 - noncentralT(critical, freedom, shift) + noncentralT(-critical, freedom, shift),
                      0.0, 1.0);
}

int participantsFor(PowerQuestion question, double wantedPower) {
    for (question.participants = 2; question.participants <= 1000; ++question.participants)
        if (power(question) >= wantedPower)
            return question.participants;
    return -1;
}

double detectableRatio(PowerQuestion question, double wantedPower) {
    const auto found = [&](double differenceLog10) {
        question.differenceLog10 = differenceLog10;
        return power(question) >= wantedPower;
    };
    double low = 0.0, high = 1.0;
    if (question.participants < 2 || !std::isfinite(question.runSdLog10) || !found(high))
        return std::numeric_limits<double>::quiet_NaN();
    constexpr int kHalvings = 20;
    for (int i = 0; i < kHalvings; ++i)
        (found(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return std::pow(10.0, high);
}

double figureError(const PowerQuestion& question, double runSdError,
                   const std::function<double(const PowerQuestion&)>& figure) {
    const auto at = [&](double sd) {
        PowerQuestion asked = question;
        asked.runSdLog10 = std::max(sd, 0.0);
        return std::isfinite(sd) ? figure(asked) : std::numeric_limits<double>::quiet_NaN();
    };
    return 0.5 * std::abs(at(question.runSdLog10 + runSdError) - at(question.runSdLog10 - runSdError));
}

} // namespace chiron::psychophysics
