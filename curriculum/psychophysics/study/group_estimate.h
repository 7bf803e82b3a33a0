// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/warning.h"

#include <cstdint>

namespace chiron::psychophysics {

/// Whether an estimate counts in its group's value and in comparisons, and if not, why. Both use this one
/// rule. The criterion is whether the answers bound the value at both ends. Other warnings (few trials,
/// answers that could be guesses) exclude nobody, because the interval already shows that.
enum class Usable : std::uint8_t {
    yes,
    noValue,     ///< no Weber fraction above zero with an interval; for magnitude estimation, no exponent
    priorMadeIt, ///< the answers do not bound the value: the prior determines it
};
Usable usableInGroup(const RunEstimate& run);

/// Whether the ends of an interval of a group, or of a ratio, differ so much (by a factor of 100 and more)
/// that it tells nothing. False for an interval that is not known.
bool isUnbounded(const Interval& interval) noexcept;

/// One participant in a group estimate.
struct GroupMember {
    int index = 0; ///< index among the estimates given
    double weber = std::numeric_limits<double>::quiet_NaN();
    double errorLog10 = std::numeric_limits<double>::quiet_NaN(); ///< of log10 W, from its 95 % interval
    double weight = 0.0;                                          ///< share in the group's mean; 0: left out
};

/// Combined estimate of a condition's participants: random effects on log10 W, with the subjects drawn from a
/// population.
struct GroupEstimate {
    double weber = std::numeric_limits<double>::quiet_NaN(); ///< geometric mean of the population
    Interval weber95;                                        ///< Hartung–Knapp
    Interval bootstrap95;                                    ///< BCa, with subjects drawn with replacement
    Interval prediction95;                                   ///< of a further participant's W
    double jnd = std::numeric_limits<double>::quiet_NaN();   ///< in `unit`, at the reference
    double sigma_log10 = std::numeric_limits<double>::quiet_NaN();
    double sdBetweenLog10 = std::numeric_limits<double>::quiet_NaN(); ///< τ, of log10 W
    double iSquared = std::numeric_limits<double>::quiet_NaN();
    /// Null hypothesis: all participants are alike.
    double heterogeneityP = std::numeric_limits<double>::quiet_NaN();
    double pse = std::numeric_limits<double>::quiet_NaN(); ///< geometric mean over participants, t interval
    Interval pse95;
    double exponent = std::numeric_limits<double>::quiet_NaN(); ///< magnitude estimation: mean, t interval
    Interval exponent95;
    std::string unit;
    std::string method;
    int participants = 0; ///< participants used: see usableInGroup
    int leftOut = 0;      ///< the other participants, except those whose answers are sealed
    std::vector<GroupMember> members;
    std::vector<Warning> warnings;
};

/// Estimates a group, with one estimate per participant. `seed` is for the bootstrap. Never fails.
GroupEstimate estimateGroup(const std::vector<RunEstimate>& runs, std::uint64_t seed);

/// Comparison of the Weber fractions in two conditions (or of two groups of people in one condition).
struct ConditionComparison {
    double ratio = std::numeric_limits<double>::quiet_NaN(); ///< W of the second divided by W of the first
    /// Paired: Hartung–Knapp on differences of log10 W; otherwise Welch's t on the means of the two groups.
    Interval ratio95;
    Interval bootstrap95;                                     ///< BCa over participants; paired only
    double pValue = std::numeric_limits<double>::quiet_NaN(); ///< two-sided; null hypothesis: the ratio is 1
    /// The same, adjusted for all comparisons of the study (Holm 1979); see adjustHolm.
    double pHolm = std::numeric_limits<double>::quiet_NaN();
    /// paired: of the difference between people.
    double sdBetweenLog10 = std::numeric_limits<double>::quiet_NaN();
    bool paired = true;
    int participants = 0;      ///< paired: with both values; otherwise of both groups together
    int first = 0, second = 0; ///< number in each
    std::vector<Warning> warnings;
};
/// Compares conditions done by the same participants: runs[i] of both belong to participant i.
ConditionComparison compareConditions(const std::vector<RunEstimate>& first,
                                      const std::vector<RunEstimate>& second, std::uint64_t seed);
/// Compares groups of different participants: random effects of each, with Welch's degrees of freedom for
/// their difference (Welch 1947).
ConditionComparison compareGroups(const std::vector<RunEstimate>& first,
                                  const std::vector<RunEstimate>& second);
/// Fills in pHolm of all comparisons that have a p.
void adjustHolm(const std::vector<ConditionComparison*>& comparisons);

/// Whether a separate threshold for each of two conditions describes the participants' answers better than a
/// common one; slope, lapse and guess rates are shared by the two curves of a participant. The likelihood
/// ratios of independent participants add up (Wilks 1938). The result is about these people, while the ratio
/// above is about the population that they come from.
struct ThresholdModels {
    double likelihoodRatio = std::numeric_limits<double>::quiet_NaN();
    int freedom = 0; ///< one per participant
    double pValue = std::numeric_limits<double>::quiet_NaN();
    /// AIC of one threshold minus AIC of two: above 0, two thresholds describe the answers better.
    double aicDifference = std::numeric_limits<double>::quiet_NaN();
    int participants = 0; ///< participants whose answers could be fitted
};
/// Compares the same participants, as compareConditions does. Empty if the tasks differ, or have no right or
/// wrong answers.
ThresholdModels compareThresholdModels(Task first, const std::vector<RunEstimate>& firstRuns, Task second,
                                       const std::vector<RunEstimate>& secondRuns);

} // namespace chiron::psychophysics
