// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"
#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// Returns the options of the free psychometric curve of a task: cumulative Gaussian, lapse rate free below
/// 0.3, guess rate at chance or, for tasks with a criterion, free too. `positive`: all differences are above
/// zero, and the curve is over their logarithm.
FitOptions freeCurveOptions(Task task, bool positive);
/// Returns the points of a run as levels; with `positive`, only those above zero.
PsychometricData curveData(const std::vector<CurvePoint>& points, bool positive);
/// Returns whether the curve of a run is over log10 D: no point is at or below zero, and the answers of the
/// task are right or wrong.
bool isPositive(Task task, const std::vector<CurvePoint>& points);

/// Fills in how well the curve of the Thurstone observer (at the posterior's median σ and criterion and mean
/// lapse rate) describes the answers: deviance with its p (chi-square; if that is below 0.05, from runs
/// simulated with the curve), and poor_fit if p is below 0.01. For comparison it also fits a free
/// psychometric curve to all trials (fits/: cumulative Gaussian, maximum likelihood, lapse free, guess at
/// chance or, for tasks with a criterion, free; on log10 D if all differences are above zero, else on D).
/// This gives fitThreshold with its profile interval, the warnings no_rise and not_monotone, and
/// curves_disagree if the two intervals of the threshold do not overlap.
void takeFit(RunEstimate& result, Task task, const ScoredAnswers& answers,
             const ThurstonePosterior& posterior);

} // namespace chiron::psychophysics
