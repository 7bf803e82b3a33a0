// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/warning.h"

#include <cstdint>

namespace chiron::psychophysics {

/// Whether an estimate counts in its group's value and in comparisons, or why it does not: the one rule for both. What decides is whether the answers
/// bound the value at both ends; other warnings (few trials, answers that could be guesses) leave nobody out, since the interval tells as much.
enum class Usable : std::uint8_t {
    yes,
    noValue,     ///< no Weber fraction above zero with an interval; of numbers said no exponent
    priorMadeIt, ///< a value that the answers do not bound: it is where the prior put it
};
Usable usableInGroup(const RunEstimate& run);

/// One participant in a group's estimate.
struct GroupMember {
    int index = 0;                ///< of the estimates given
    double weber = std::numeric_limits<double>::quiet_NaN();
    double errorLog10 = std::numeric_limits<double>::quiet_NaN(); ///< of log10 W, from its 95 % interval
    double weight = 0.0;          ///< share in the group's mean; 0: left out
};

/// What a condition's participants say together: random effects on log10 W, subjects drawn from a population.
struct GroupEstimate {
    double weber = std::numeric_limits<double>::quiet_NaN(); ///< geometric mean of the population
    Interval weber95;      ///< Hartung–Knapp
    Interval bootstrap95;  ///< BCa, subjects drawn with replacement
    Interval prediction95; ///< of a further participant's W
    double jnd = std::numeric_limits<double>::quiet_NaN();   ///< in `unit`, at the reference
    double sigma_log10 = std::numeric_limits<double>::quiet_NaN();
    double sdBetweenLog10 = std::numeric_limits<double>::quiet_NaN(); ///< τ, of log10 W
    double iSquared = std::numeric_limits<double>::quiet_NaN();
    double heterogeneityP = std::numeric_limits<double>::quiet_NaN(); ///< of all participants alike
    double pse = std::numeric_limits<double>::quiet_NaN();            ///< geometric mean over participants, t interval
    Interval pse95;
    double exponent = std::numeric_limits<double>::quiet_NaN();       ///< magnitude estimation: mean, t interval
    Interval exponent95;
    std::string unit;
    std::string method;
    int participants = 0; ///< used: usableInGroup
    int leftOut = 0;      ///< the others whose answers are not sealed
    std::vector<GroupMember> members;
    std::vector<Warning> warnings;
};

/// One estimate a participant. `seed`: of the bootstrap. Never fails.
GroupEstimate estimateGroup(const std::vector<RunEstimate>& runs, std::uint64_t seed);

/// The Weber fractions of two conditions (or of two groups of people at one).
struct ConditionComparison {
    double ratio = std::numeric_limits<double>::quiet_NaN(); ///< W of the second over the first
    Interval ratio95;      ///< paired: Hartung–Knapp on differences of log10 W; else Welch's t on the two groups' means
    Interval bootstrap95;  ///< BCa over participants; paired only
    double pValue = std::numeric_limits<double>::quiet_NaN(); ///< two-sided, of ratio 1
    double pHolm = std::numeric_limits<double>::quiet_NaN();  ///< the same, adjusted for all comparisons of the study (Holm 1979); see adjustHolm
    double sdBetweenLog10 = std::numeric_limits<double>::quiet_NaN(); ///< paired: of the difference from person to person
    bool paired = true;
    int participants = 0;  ///< paired: with both; else of both together
    int first = 0, second = 0; ///< of each
    std::vector<Warning> warnings;
};
/// Done by the same participants: runs[i] of both is participant i's.
ConditionComparison compareConditions(const std::vector<RunEstimate>& first, const std::vector<RunEstimate>& second, std::uint64_t seed);
/// Done by different participants: random effects of each, their difference with Welch's degrees of freedom (Welch 1947).
ConditionComparison compareGroups(const std::vector<RunEstimate>& first, const std::vector<RunEstimate>& second);
/// Fills pHolm of comparisons that have a p.
void adjustHolm(const std::vector<ConditionComparison*>& comparisons);

/// Whether a threshold of its own for each of two conditions describes each participant's answers better than one for both; slope, lapse and guess
/// are shared by a participant's two curves. Likelihood ratios of participants, who are independent, add up (Wilks 1938): it is of these people,
/// while the ratio above is of the population they come from.
struct ThresholdModels {
    double likelihoodRatio = std::numeric_limits<double>::quiet_NaN();
    int freedom = 0;       ///< one a participant
    double pValue = std::numeric_limits<double>::quiet_NaN();
    double aicDifference = std::numeric_limits<double>::quiet_NaN(); ///< one threshold less two: above 0 two describe the answers better
    int participants = 0;  ///< whose answers could be fitted
};
/// Of the same participants, as in compareConditions. Of none where the tasks differ, or nothing is right or wrong in them.
ThresholdModels compareThresholdModels(Task first, const std::vector<RunEstimate>& firstRuns, Task second, const std::vector<RunEstimate>& secondRuns);

} // namespace chiron::psychophysics
