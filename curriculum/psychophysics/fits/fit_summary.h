// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood.h"

namespace chiron::psychophysics {

/// Functions for the results that maximum-likelihood and Bayesian fits have in common. `result.best` and
/// `freeParameters` must be set.

/// Copies `best` into threshold (given units), width, lapse, guess, eta; fills levels, residuals, deviance,
/// chi-square p, log-likelihood, AIC.
void summarise(FitResult& result, const PreparedLevels& levels);
/// The same for the curve in the coordinates of the search: a steep curve far from 0 loses significant digits
/// when it is written as threshold and width.
void summarise(FitResult& result, const PreparedLevels& levels, const UnitCurve& curve);

/// Adds the curve at `options.curvePoints` positions, from the lowest to the highest level and a tenth of the
/// range beyond either end. Its band comes from result.draws if there are at least 100.
void addCurve(FitResult& result, const PreparedLevels& levels, const FitOptions& options);

/// Describes in words why the options make no sense; empty if they do. No fit is made with options that make
/// no sense.
std::string optionsProblem(const FitOptions& options);

/// Adds warnings for clinicians about data and fit: all_right, all_wrong, step_function, no_rise,
/// lapse_at_bound, guess_at_bound, few_trials_near_threshold, threshold_outside, wide, not_monotone,
/// overdispersion, uneven_levels.
void addWarnings(FitResult& result, const PreparedLevels& levels, const FitOptions& options);

} // namespace chiron::psychophysics
