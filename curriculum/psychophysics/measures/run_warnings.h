// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// What a reader of the estimate must know, one sentence each after its token: no_trials, left_out, few_trials, one_level, all_right,
/// chance, prior_edge, prior_bound, step_function, lapses, binned.
void warnOfAnswers(std::vector<std::string>& warnings, Task task, const ScoredAnswers& answers, const ThurstonePosterior& posterior);

/// position_bias: wrong answers fall on some places more than chance allows (forced choices; p < 0.001 of chi-square).
void warnOfPlaces(std::vector<std::string>& warnings, Task task, const std::vector<ScoredTrial>& trials);

inline constexpr int kFewTrials = 20; ///< fewer than so many: few_trials

} // namespace chiron::psychophysics
