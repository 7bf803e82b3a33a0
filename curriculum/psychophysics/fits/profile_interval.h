// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood_search.h"

namespace chiron::psychophysics {

/// Intervals of threshold (given units) and width (fitted axis) by the profile of the likelihood: where twice the drop, everything else
/// searched again, reaches chi-square's quantile, or, with a free lapse or guess, chi-bar-square's (chi_square.h): a flat curve without lapses and a
/// steeper one with many look alike, and there are no fewer lapses than none. An end that never does (a step's width towards 0) is 0 or infinite.
ParameterIntervals profileIntervals(const PreparedLevels& levels, const FitOptions& options, const SearchResult& best);

} // namespace chiron::psychophysics
