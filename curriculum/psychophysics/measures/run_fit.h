// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/scored_answers.h"

namespace chiron::psychophysics {

/// A free psychometric curve through all trials (fits/: cumulative Gaussian, maximum likelihood, lapse free, guess at chance, for yes_no and
/// same_different free), beside the Thurstone observer, which knows no free slope: fitThreshold with its profile interval, deviance and its
/// p. On log10 D where all differences are above zero, else on D. Adds no_rise and not_monotone of it, poor_fit (p < 0.01) and curves_disagree (the two
/// intervals of the threshold do not meet).
void takeFit(RunEstimate& result, Task task, const ScoredAnswers& answers);

} // namespace chiron::psychophysics
