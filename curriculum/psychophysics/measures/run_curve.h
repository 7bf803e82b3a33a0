// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// Fills in the fitted curve of a run with its pointwise 95 % band (over the posterior's draws), and the
/// threshold at the run's criterion (without lapses). The curve shows, for rank3 and rank3_ties: entirely
/// correct orders; yes_no: "yes"; same_different: "different"; other tasks: right answers.
void takeCurve(RunEstimate& result, Task task, const ScoredAnswers& answers,
               const ThurstonePosterior& posterior);

/// Returns the answer kind (see AnswerCount) whose probability the curve of a task shows.
int kindOfCurve(Task task) noexcept;

/// Returns the value below which `share` of the values lie, interpolated between neighbours; `sorted` is
/// ascending. Not a number if there are no values.
double quantileOf(const std::vector<double>& sorted, double share) noexcept;
/// Returns the standard error of that quantile, 0 < share < 1, as if the values were drawn anew: the spread
/// of a bootstrap of the order statistic, exact and without drawing (Maritz & Jarrett 1978). Not a number for
/// fewer than two values.
double quantileErrorOf(const std::vector<double>& sorted, double share);

} // namespace chiron::psychophysics
