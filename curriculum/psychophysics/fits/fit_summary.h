// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood.h"

namespace chiron::psychophysics {

/// What a maximum-likelihood and a Bayesian fit report alike. `result.best` and `freeParameters` must be set.

/// Copies `best` into threshold (given units), width, lapse, guess, eta; fills levels, residuals, deviance, chi-square p, log-likelihood, AIC.
void summarise(FitResult& result, const PreparedLevels& levels);
/// The same of the curve as it was searched: a steep one far from 0 loses digits that matter when it is written as threshold and width.
void summarise(FitResult& result, const PreparedLevels& levels, const UnitCurve& curve);

/// The curve at `options.curvePoints` places from the lowest to the highest level and a tenth of the range beyond either end; its band
/// from result.draws where there are at least 100.
void addCurve(FitResult& result, const PreparedLevels& levels, const FitOptions& options);

/// Options that make no sense, in words; empty where they do. A fit with one is not made.
std::string optionsProblem(const FitOptions& options);

/// Warnings for clinicians from data and fit: all_right, all_wrong, step_function, no_rise, lapse_at_bound, guess_at_bound,
/// few_trials_near_threshold, threshold_outside, wide, not_monotone, overdispersion, uneven_levels.
void addWarnings(FitResult& result, const PreparedLevels& levels, const FitOptions& options);

} // namespace chiron::psychophysics
