// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/thurstone_posterior.h"
#include "psychophysics/study/run_estimate.h"

namespace chiron::psychophysics {

/// The trials of a run, sorted for analysis.
struct ScoredAnswers {
    std::vector<AnswerCount> counts; ///< by difference, then kind
    /// By difference: right answers of all (yes_no: "yes" answers; same_different: "different" answers, at 0
    /// if both objects were the same).
    std::vector<CurvePoint> points;
    int used = 0;
    int right = 0;   ///< correct answers
    int leftOut = 0; ///< trials without a finite difference or without a possible answer
    /// There are more than kMostLevels differences; they are merged into bins, each at its mean.
    bool binned = false;
    double smallestDifference = 0.0; ///< smallest |D| > 0 presented; 0: none
    double largestDifference = 0.0;
    int levels = 0; ///< number of distinct |D| presented
};

inline constexpr std::size_t kMostLevels = 256;

/// Derives each outcome from arrangement and answer, because the stored outcome may be what a procedure with
/// two outcomes was told about an order. If there is no answer, the stored outcome is used as outcomeOf
/// counts it.
ScoredAnswers sortAnswers(Task task, const std::vector<ScoredTrial>& trials);

} // namespace chiron::psychophysics
