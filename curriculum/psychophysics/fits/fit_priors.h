// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/prepared_levels.h"

namespace chiron::psychophysics {

/// psignifit's priors (Schütt et al. 2016), and variants that leave the width open at either end. They are on
/// the unit axis (threshold, and width in ranges of the levels).
///
/// Threshold: 1 inside the range, falling to 0 as a half cosine at half a range beyond either end. Width,
/// with d the smallest spacing and R the range: 0 below d, a half cosine up to 1 at 2d, 1 up to R, a quarter
/// cosine down to 0 at 3R. Lapse, guess and η: Beta(1, b), that is, proportional to (1 − p)^(b − 1). Open
/// below: 1 from d/100. Open above: 1 up to 3R, a quarter cosine down to 0 at 9R, because an observer three
/// times as steep or as flat as a design expects lies outside psignifit's prior. If the guess equals the
/// lapse, their prior counts once.
struct FitPriors {
    double low = -0.5, high = 0.5; ///< range of the stimuli
    double spacing = 0.1;
    double beta = 10.0;
    WidthPrior ofWidth = WidthPrior::psignifit; ///< never automatic

    double range() const noexcept { return high - low; }
    double lowestThreshold() const noexcept { return low - 0.5 * range(); }
    double highestThreshold() const noexcept { return high + 0.5 * range(); }
    bool openBelow() const noexcept {
        return ofWidth == WidthPrior::openBelow || ofWidth == WidthPrior::wide;
    }
    bool openAbove() const noexcept {
        return ofWidth == WidthPrior::openAbove || ofWidth == WidthPrior::wide;
    }
    double lowestWidth() const noexcept { return openBelow() ? 0.01 * spacing : spacing; }
    double largestWidth() const noexcept { return (openAbove() ? 9.0 : 3.0) * range(); }
    /// The prior is at its full height between these two widths.
    double fullWidthFrom() const noexcept { return openBelow() ? lowestWidth() : 2.0 * spacing; }
    double fullWidthTo() const noexcept { return (openAbove() ? 3.0 : 1.0) * range(); }
    double logThreshold(double threshold) const noexcept; ///< −∞ where impossible
    double logWidth(double width) const noexcept;
    double logShare(double share) const noexcept; ///< for lapse, guess or η
};
/// Standard deviations of the prior alone: of the threshold, of ln width, and of a share that is at most
/// `largest`.
double priorThresholdSd(const FitPriors& priors) noexcept;
double priorLogWidthSd(const FitPriors& priors) noexcept;
double priorShareSd(const FitPriors& priors, double largest) noexcept;

FitPriors priorsFor(const PreparedLevels& levels, const FitOptions& options, StimulusScale scale,
                    WidthPrior width = WidthPrior::psignifit) noexcept;

} // namespace chiron::psychophysics
