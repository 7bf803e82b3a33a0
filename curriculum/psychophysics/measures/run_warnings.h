// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// Adds what a reader of the estimate must know: about the number and spread of trials, guessing, the
/// influence of the prior, and lapses.
void warnOfAnswers(std::vector<Warning>& warnings, Task task, const ScoredAnswers& answers,
                   const ThurstonePosterior& posterior);

/// Adds positionBias if wrong answers favour some positions more than chance allows (forced choices; p <
/// 0.001 of chi-square).
void warnOfPlaces(std::vector<Warning>& warnings, Task task, const std::vector<ScoredTrial>& trials);

inline constexpr int kFewTrials = 20; ///< fewer trials than this: few_trials

} // namespace chiron::psychophysics
