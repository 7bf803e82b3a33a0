// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood.h"
#include "psychophysics/fits/limit_curves.h"

#include <limits>

namespace chiron::psychophysics {

/// The maximum of the likelihood.
struct SearchResult {
    enum class Kind : std::uint8_t {
        curve, ///< a curve with a finite, positive slope
        step,  ///< no finite slope is best: the limit is a step
        flat,  ///< the best curve does not rise
    } kind = Kind::curve;
    UnitCurve curve;
    double logLikelihood = 0.0; ///< without coefficients
    bool converged = false;
    double pearson = 0.0; ///< Σ (k − nψ)²/(nψ(1 − ψ))
    StepCurve step;       ///< the best step, whatever `kind` is
};

/// When to end a climb.
struct ClimbGoal {
    double enough = 2e-12; ///< Newton decrement: twice the gain in log-likelihood that another step would
                           ///< bring
    /// The climb is abandoned early if it clearly cannot reach this log-likelihood.
    double beat = -std::numeric_limits<double>::infinity();
};

/// Climbs by damped Newton and Fisher scoring from one start, with lapse and guess kept between 0 and their
/// largest values. At most 100 steps.
SearchResult climb(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                   const UnitCurve& start, const ClimbGoal& goal = {}) noexcept;

/// Finds the largest likelihood over all curves; lapse and guess have the given values if they are not free.
/// The first climb starts from a line through the transformed proportions. If a second maximum is possible
/// (free lapse or guess, a poor fit, or a step or a flat line almost as likely), further climbs start from
/// steps and from the best of a grid of curves. Finally the two limits are compared.
SearchResult searchMaximum(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                           double lapse, double guess) noexcept;

/// The same from many more starts, each climbed to its end. It takes about a millisecond and is meant for
/// fits that are shown to people.
SearchResult searchThoroughly(Sigmoid sigmoid, const LevelsView& levels, const FreeParameters& free,
                              double lapse, double guess) noexcept;

/// Returns 2 ln of the likelihood ratio of the best curve to the best step; 0 if a step is best.
double likelihoodRatioOfStep(const PreparedLevels& levels, Sigmoid sigmoid, const FreeParameters& free,
                             double lapse, double guess) noexcept;

} // namespace chiron::psychophysics
