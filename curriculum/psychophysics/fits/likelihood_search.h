// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood.h"
#include "psychophysics/fits/limit_curves.h"

#include <limits>

namespace chiron::psychophysics {

/// Where the likelihood is largest.
struct SearchResult {
    enum class Kind : std::uint8_t {
        curve, ///< a curve of its own
        step,  ///< no finite slope is best: a step
        flat,  ///< no rise is best
    } kind = Kind::curve;
    UnitCurve curve;
    double logLikelihood = 0.0; ///< without coefficients
    bool converged = false;
    double pearson = 0.0;       ///< Σ (k − nψ)²/(nψ(1 − ψ))
    StepCurve step;             ///< the best step, whatever the kind
};

/// When a climb ends.
struct ClimbGoal {
    double enough = 2e-12; ///< Newton decrement: twice what another step would add to the log-likelihood
    double beat = -std::numeric_limits<double>::infinity(); ///< given up early where it is clear that it stays below this
};

/// Damped Newton and Fisher scoring from one start, lapse and guess held between 0 and their largest; at most 100 steps.
SearchResult climb(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free, const UnitCurve& start, const ClimbGoal& goal = {}) noexcept;

/// The largest likelihood over all curves with the given lapse and guess where they are not free: a climb from a line through the
/// transformed proportions; wherever a second maximum is possible (free lapse or guess, a poor fit, a step or no rise nearly as likely)
/// more climbs, from steps and from the best of a grid of curves; then the two limits.
SearchResult searchMaximum(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free, double lapse, double guess) noexcept;

/// The same from many more starts, each climbed to its end: a millisecond, for a fit that somebody reads.
SearchResult searchThoroughly(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free, double lapse, double guess) noexcept;

/// 2 ln of the likelihood of the best curve over that of the best step: 0 where a step is best.
double likelihoodRatioOfStep(const PreparedLevels& levels, Sigmoid sigmoid, const FreeParameters& free, double lapse, double guess) noexcept;

} // namespace chiron::psychophysics
