// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// The fitted curve of a run with its pointwise 95 % band (over the posterior's draws), and the threshold at the run's criterion (without
/// lapses). rank3, rank3_ties: of orders wholly right; yes_no: of "yes"; same_different: of "different"; others: of right answers.
void takeCurve(RunEstimate& result, Task task, const ScoredAnswers& answers, const ThurstonePosterior& posterior);

/// The kind of answer (see AnswerCount) that the curve of a task is of.
int kindOfCurve(Task task) noexcept;

/// The value below which `share` of the values lie, between neighbours; `sorted` ascending. Not a number where there are none.
double quantileOf(const std::vector<double>& sorted, double share) noexcept;

} // namespace chiron::psychophysics
