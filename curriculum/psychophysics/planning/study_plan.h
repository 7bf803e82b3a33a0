// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/observers/observer_spec.h"
#include "psychophysics/study/study_design.h"
#include "psychophysics/study/warning.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// What to expect of one condition, by simulated observers without rendering (real ones add the noise of exploring).
struct ConditionPlan {
    int runs = 0;        ///< simulated
    int withoutEstimate = 0; ///< of these, runs that gave no Weber fraction
    double biasLog10 = std::numeric_limits<double>::quiet_NaN(); ///< mean of log10(estimated/true JND)
    double sdLog10 = std::numeric_limits<double>::quiet_NaN();   ///< its sd from run to run
    double coverage = std::numeric_limits<double>::quiet_NaN();  ///< share of 95 % intervals that hold the true Weber fraction
    double meanTrials = 0.0; ///< scored ones, a run
    /// Standard errors of the five figures above and below, as so few simulated runs know them (Monte Carlo): of the coverage after Agresti & Coull 1998.
    double biasError = std::numeric_limits<double>::quiet_NaN(), sdError = std::numeric_limits<double>::quiet_NaN();
    double coverageError = std::numeric_limits<double>::quiet_NaN(), trialsError = std::numeric_limits<double>::quiet_NaN();
    double minutesError = std::numeric_limits<double>::quiet_NaN();
    /// Quantiles of the estimated Weber fractions: a tenth, half and nine tenths of the runs say less.
    double weber10 = std::numeric_limits<double>::quiet_NaN(), weber50 = std::numeric_limits<double>::quiet_NaN();
    double weber90 = std::numeric_limits<double>::quiet_NaN();
    double minutes = 0.0;    ///< a run, with practice and breaks, at 4 s an object (25 s an apex) and 2 s an answer
    double fisherPerTrial = 0.0; ///< information about ln σ at the best spacing
    double bestSpacing = 0.0;    ///< D/σ with most information
    double bestDifference = std::numeric_limits<double>::quiet_NaN(); ///< the candidate nearest to it
    std::vector<Warning> warnings;
};

/// How long a run of so many scored trials takes, with practice and breaks: 4 s an object (25 s an apex), or as long as the rules allow, and 2 s an answer.
double minutesOf(const Condition& condition, const TrialRules& rules, double trials);

/// `runs`: 0 for the analytic part only. Each condition has random numbers of its own, by its id and the seed. Never fails: what cannot be simulated is told in `warnings`.
ConditionPlan planCondition(const Condition& condition, const TrialRules& rules, const ObserverSpec& observer, int runs, std::uint64_t seed);

/// A comparison of JNDs between two conditions (each participant does both) or two groups.
struct PowerQuestion {
    double differenceLog10 = 0.1; ///< true difference of log10 JND
    double runSdLog10 = 0.1;      ///< of one run's estimate: ConditionPlan::sdLog10
    double personSdLog10 = 0.15;  ///< between people
    double effectSdLog10 = 0.05;  ///< of the difference itself, from person to person (paired only)
    bool paired = true;
    int participants = 12;        ///< paired: people; else in each group
    double alpha = 0.05;          ///< two-sided
};

/// Chance that a two-sided t-test of log10 JNDs finds the difference: exact (noncentral t), by numerical integration.
double power(const PowerQuestion& question);
/// The fewest participants (in each group) for that power; -1: more than 1,000.
int participantsFor(PowerQuestion question, double wantedPower);
/// The smallest ratio of JNDs (above 1) found with that power; not a number: none up to 10.
double detectableRatio(PowerQuestion question, double wantedPower);

} // namespace chiron::psychophysics
