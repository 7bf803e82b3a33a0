// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// What a reader of the estimate must know: of the number and spread of trials, of guessing, of what the prior decides, of lapses.
void warnOfAnswers(std::vector<Warning>& warnings, Task task, const ScoredAnswers& answers, const ThurstonePosterior& posterior);

/// positionBias: wrong answers fall on some places more than chance allows (forced choices; p < 0.001 of chi-square).
void warnOfPlaces(std::vector<Warning>& warnings, Task task, const std::vector<ScoredTrial>& trials);

inline constexpr int kFewTrials = 20; ///< fewer than so many: few_trials

} // namespace chiron::psychophysics
