// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/thurstone_posterior.h"
#include "psychophysics/study/run_estimate.h"

namespace chiron::psychophysics {

/// The trials of a run, sorted for analysis.
struct ScoredAnswers {
    std::vector<AnswerCount> counts;  ///< by difference, then kind
    std::vector<CurvePoint> points;   ///< by difference: right of all (yes_no: yes; same_different: "different", 0 where both were the same)
    int used = 0;
    int right = 0;                    ///< correct answers
    int leftOut = 0;                  ///< trials without a finite difference or a possible answer
    bool binned = false;              ///< more than kMostLevels differences: put together, each bin at its mean
    double smallestDifference = 0.0;  ///< |D| > 0 presented, 0: none
    double largestDifference = 0.0;
    int levels = 0;                   ///< different |D| presented
};

inline constexpr std::size_t kMostLevels = 256;

/// Works the outcome out of arrangement and answer (an outcome may be what a procedure of two outcomes heard of an order); where there is no
/// answer, takes the outcome as outcomeOf counts it.
ScoredAnswers sortAnswers(Task task, const std::vector<ScoredTrial>& trials);

} // namespace chiron::psychophysics
