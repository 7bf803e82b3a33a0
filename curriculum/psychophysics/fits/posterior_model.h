// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_priors.h"
#include "psychophysics/fits/likelihood.h"

#include <array>

namespace chiron::psychophysics {

inline constexpr double kMostEta = 0.999;

/// The beta-binomial model of Schütt et al. (2016) for one set of levels; thresholds and widths on the unit
/// axis.
struct PosteriorModel {
    const PreparedLevels& levels;
    Sigmoid sigmoid;
    FitPriors priors;
    FreeParameters free; ///< which of lapse and guess are free
    double lapse = 0.0;  ///< used if fixed, as is `guess`
    double guess = 0.0;
    bool overdispersion = true; ///< false: η is 0

    /// Returns the log of prior × likelihood (a density over threshold, width, lapse, guess and η), up to a
    /// constant; −∞ if impossible.
    double logDensity(const CurveParameters& at) const noexcept;
};

} // namespace chiron::psychophysics
