// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood_search.h"

namespace chiron::psychophysics {

/// Returns intervals of threshold (given units) and width (fitted axis) by profile likelihood. An interval
/// ends where twice the drop of the log-likelihood, with all other parameters searched again, reaches the
/// chi-square quantile or, if lapse or guess is free, the chi-bar-square quantile (chi_square.h). The latter
/// is needed because a flat curve without lapses looks like a steeper one with many, and a lapse rate cannot
/// be negative. An end that is never reached (a step's width towards 0) is 0 or infinite.
ParameterIntervals profileIntervals(const PreparedLevels& levels, const FitOptions& options,
                                    const SearchResult& best);

} // namespace chiron::psychophysics
