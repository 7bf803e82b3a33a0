// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/prepared_levels.h"

namespace chiron::psychophysics {

/// psignifit's priors (Schütt et al. 2016), on the unit axis (threshold, and width in ranges of the levels).
///
/// Threshold: 1 inside the range, a half cosine down to 0 at half a range beyond either end. Width, with d the smallest spacing and R
/// the range: 0 below d, half a cosine up to 1 at 2d, 1 to R, a quarter cosine down to 0 at 3R. Lapse, guess and η: Beta(1, b), that is
/// proportional to (1 − p)^(b − 1). Where the guess equals the lapse its prior counts once.
struct FitPriors {
    double low = -0.5, high = 0.5; ///< range of the stimuli
    double spacing = 0.1;
    double beta = 10.0;

    double range() const noexcept { return high - low; }
    double lowestThreshold() const noexcept { return low - 0.5 * range(); }
    double highestThreshold() const noexcept { return high + 0.5 * range(); }
    double largestWidth() const noexcept { return 3.0 * range(); }
    double logThreshold(double threshold) const noexcept; ///< −∞ where impossible
    double logWidth(double width) const noexcept;
    double logShare(double share) const noexcept;          ///< of lapse, guess or η
};
FitPriors priorsFor(const PreparedLevels& levels, const FitOptions& options, StimulusScale scale) noexcept;

} // namespace chiron::psychophysics
