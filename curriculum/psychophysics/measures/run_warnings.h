// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// Adds what a reader of the estimate must know: about the number and spread of trials, guessing, the
/// influence of the prior, and lapses. `chance` is said only where neither all answers nor those at the
/// largest differences are better than guessing, and where they are enough to show that a clear advantage
/// over it is missing; where they are not enough,
/// `tooFewToTell` is said instead. Neither is ever said together with `stepFunction`.
void warnOfAnswers(std::vector<Warning>& warnings, Task task, const ScoredAnswers& answers,
                   const ThurstonePosterior& posterior);

/// Adds positionBias if wrong answers favour some positions more than chance allows (forced choices; p <
/// 0.001 of chi-square).
void warnOfPlaces(std::vector<Warning>& warnings, Task task, const std::vector<ScoredTrial>& trials);

inline constexpr int kFewTrials = 20; ///< fewer trials than this: few_trials

} // namespace chiron::psychophysics
