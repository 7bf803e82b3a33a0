// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"
#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// The free psychometric curve of a task: cumulative Gaussian, lapse free below 0.3, guess at chance, for tasks with a criterion free too. `positive`:
/// all differences are above zero, and the curve is over their logarithm.
FitOptions freeCurveOptions(Task task, bool positive);
/// Points of a run as levels; `positive`: of those above zero alone.
PsychometricData curveData(const std::vector<CurvePoint>& points, bool positive);
/// Whether the curve of a run is over log10 D: no point at or below zero, and the task says right or wrong.
bool isPositive(Task task, const std::vector<CurvePoint>& points);

/// How well the Thurstone observer's own curve (at the posterior's median σ and criterion and mean lapse) describes the answers: deviance
/// with its p (chi-square; where that is below 0.05, from runs drawn of the curve), and poor_fit below 0.01. Beside it a free psychometric
/// curve through all trials (fits/: cumulative Gaussian, maximum likelihood, lapse free, guess at chance, for yes_no and same_different
/// free; on log10 D where all differences are above zero, else on D): fitThreshold with its profile interval, no_rise and not_monotone of
/// it, and curves_disagree (the two intervals of the threshold do not meet).
void takeFit(RunEstimate& result, Task task, const ScoredAnswers& answers, const ThurstonePosterior& posterior);

} // namespace chiron::psychophysics
