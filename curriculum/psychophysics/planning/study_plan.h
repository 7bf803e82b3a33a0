// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/observers/observer_spec.h"
#include "psychophysics/study/study_design.h"
#include "psychophysics/study/warning.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// Expectations for one condition, from simulated observers without rendering (real observers add the noise
/// of exploration).
struct ConditionPlan {
    int runs = 0;            ///< number of simulated runs
    int withoutEstimate = 0; ///< of these, runs without a Weber fraction
    /// Of the runs, those that a group would leave out because their answers support no value
    /// (usableInGroup). Nothing for marks of an apex, of which groups leave out none.
    std::optional<int> withoutValue;
    /// The number of trials from which on fewer than 1 in 20 runs are without a value; 0: not examined
    /// (examineLength), not needed, or none confirmed.
    int trialsForValues = 0;
    double biasLog10 = std::numeric_limits<double>::quiet_NaN(); ///< mean of log10(estimated/true JND)
    double sdLog10 = std::numeric_limits<double>::quiet_NaN();   ///< standard deviation of the same between
                                                                 ///< runs
    double coverage = std::numeric_limits<double>::quiet_NaN();  ///< share of the 95 % intervals that contain
                                                                 ///< the true Weber fraction
    double meanTrials = 0.0;                                     ///< scored trials per run
    /// Monte Carlo standard errors of the five values above and below, due to the limited number of simulated
    /// runs. The error of the coverage follows Agresti & Coull 1998.
    double biasError = std::numeric_limits<double>::quiet_NaN(),
           sdError = std::numeric_limits<double>::quiet_NaN();
    double coverageError = std::numeric_limits<double>::quiet_NaN(),
           trialsError = std::numeric_limits<double>::quiet_NaN();
    double minutesError = std::numeric_limits<double>::quiet_NaN();
    /// Quantiles of the estimated Weber fraction over the runs: 10 %, 50 % and 90 %.
    double weber10 = std::numeric_limits<double>::quiet_NaN(),
           weber50 = std::numeric_limits<double>::quiet_NaN();
    double weber90 = std::numeric_limits<double>::quiet_NaN();
    /// Their Monte Carlo standard errors, for the same reason (quantileErrorOf).
    double weber10Error = std::numeric_limits<double>::quiet_NaN(),
           weber50Error = std::numeric_limits<double>::quiet_NaN();
    double weber90Error = std::numeric_limits<double>::quiet_NaN();
    /// Per run, with practice and breaks, at 4 s per object (25 s per apex) and 2 s per answer.
    double minutes = 0.0;
    double fisherPerTrial = 0.0; ///< information per trial about ln σ at the best spacing
    double bestSpacing = 0.0;    ///< D/σ with the most information
    /// The candidate nearest to that spacing.
    double bestDifference = std::numeric_limits<double>::quiet_NaN();
    std::vector<Warning> warnings;
};

/// Returns how long one trial of a condition takes until the next one comes: 4 s per object (25 s per apex),
/// or as long as the rules allow, 2 s per answer, and the time between trials. Unit: s.
double secondsOfTrial(const Condition& condition, const TrialRules& rules);

/// Returns how long a run with this many scored trials takes, with practice and breaks
/// (secondsOfTrial).
double minutesOf(const Condition& condition, const TrialRules& rules, double trials);

/// Plans a condition. `runs`: 0 for the analytic part only. Each condition has its own random numbers, from
/// its id and the seed. It never fails: `warnings` say what cannot be simulated.
ConditionPlan planCondition(const Condition& condition, const TrialRules& rules, const ObserverSpec& observer,
                            int runs, std::uint64_t seed);

/// Returns whether 1 in 20 simulated runs or more are without a value.
bool oftenWithoutValue(const ConditionPlan& plan) noexcept;

/// Returns the condition with runs of about this many trials, instead of its own rules for stopping; nothing
/// if a procedure's rule does not allow that.
std::optional<Condition> withTrials(Condition condition, int trials);

/// Fills in trialsForValues of the condition's plan: simulates as many runs again with half as many trials
/// more, and so on up to 100 trials, until fewer than 1 in 20 are without a value at two lengths in
/// succession; the first of them is taken, and the second may be above 100. Does nothing if fewer are so
/// already, or if the plan has fewer than 40 runs, which do not show that. `observer` and `seed`: those of
/// planCondition.
void examineLength(ConditionPlan& plan, const Condition& condition, const ObserverSpec& observer,
                   std::uint64_t seed);

/// Describes a comparison of JNDs between two conditions (each participant does both) or between two groups.
struct PowerQuestion {
    double differenceLog10 = 0.1; ///< true difference of log10 JND
    double runSdLog10 = 0.1;      ///< of the estimate from one run: ConditionPlan::sdLog10
    double personSdLog10 = 0.15;  ///< between people
    double effectSdLog10 = 0.05;  ///< of the difference itself, between people (paired only)
    bool paired = true;
    int participants = 12; ///< paired: people; otherwise: people in each group
    double alpha = 0.05;   ///< two-sided
};

/// Returns the probability that a two-sided t-test of log10 JNDs finds the difference: exact (noncentral t),
/// by numerical integration.
double power(const PowerQuestion& question);
/// Returns the smallest number of participants (in each group) with that power; -1: more than 1,000.
int participantsFor(PowerQuestion question, double wantedPower);
/// Returns the smallest ratio of JNDs (above 1) that is found with that power; not a number: none up to 10.
double detectableRatio(PowerQuestion question, double wantedPower);

/// Returns the Monte Carlo standard error of a figure that follows from the spread between runs: half of what
/// it changes by when runSdLog10 is one standard error larger and smaller (`runSdError`:
/// ConditionPlan::sdError). Not a number where the figure is none at one of the two.
double figureError(const PowerQuestion& question, double runSdError,
                   const std::function<double(const PowerQuestion&)>& figure);

} // namespace chiron::psychophysics
