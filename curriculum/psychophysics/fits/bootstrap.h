// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood_search.h"

namespace chiron::psychophysics {

/// Computes the Monte Carlo goodness of fit and the bootstrap intervals that `options` ask for; fills pValue,
/// draws and ci.
///
/// Goodness of fit: data sets are simulated from the fitted curve and fitted again; p = (1 + those with at
/// least this deviance)/(1 + all).
/// Bootstrap: percentiles corrected for bias and acceleration (BCa; Efron 1987), with the acceleration from
/// leaving out one answer at a time.
void addSimulations(FitResult& result, const PreparedLevels& levels, const FitOptions& options);

} // namespace chiron::psychophysics
