// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/warning.h"

#include <cstdint>

namespace chiron::psychophysics {

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
    int participants = 0; ///< used
    int leftOut = 0;      ///< without a Weber fraction, or with one that the prior made
    std::vector<GroupMember> members;
    std::vector<Warning> warnings;
};

/// One estimate a participant. `seed`: of the bootstrap. Never fails.
GroupEstimate estimateGroup(const std::vector<RunEstimate>& runs, std::uint64_t seed);

/// Two conditions done by the same participants: runs[i] of both is participant i's.
struct ConditionComparison {
    double ratio = std::numeric_limits<double>::quiet_NaN(); ///< W of the second over the first
    Interval ratio95;      ///< Hartung–Knapp on differences of log10 W
    Interval bootstrap95;  ///< BCa over participants
    double pValue = std::numeric_limits<double>::quiet_NaN(); ///< two-sided, of ratio 1
    double sdBetweenLog10 = std::numeric_limits<double>::quiet_NaN();
    int participants = 0;  ///< with both
    std::vector<Warning> warnings;
};
ConditionComparison compareConditions(const std::vector<RunEstimate>& first, const std::vector<RunEstimate>& second, std::uint64_t seed);

} // namespace chiron::psychophysics
