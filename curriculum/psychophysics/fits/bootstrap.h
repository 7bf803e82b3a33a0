// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood_search.h"

namespace chiron::psychophysics {

/// Monte Carlo goodness of fit and bootstrap intervals as `options` ask for; fills pValue, draws, ci.
///
/// Goodness of fit: data sets simulated from the fitted curve, each fitted again; p = (1 + those with at least this deviance)/(1 + all).
/// Bootstrap: percentiles corrected for bias and acceleration (BCa; Efron 1987), acceleration from leaving out one answer at a time.
void addSimulations(FitResult& result, const PreparedLevels& levels, const FitOptions& options);

} // namespace chiron::psychophysics
