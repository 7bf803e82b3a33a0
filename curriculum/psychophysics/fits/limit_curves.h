// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood.h"

namespace chiron::psychophysics {

/// The limits of a curve at the ends of its parameter space, which no climb reaches: a step (width → 0)
/// between two levels or at one of them, and no rise at all (width → ∞). Their likelihoods have closed forms,
/// lapse and guess included.
struct StepCurve {
    std::size_t level = 0; ///< level of the step; see atLevel
    bool atLevel = false;  ///< true: at this level, which has a proportion of its own; false: between the
                           ///< previous level and this one
    double share = 0.0;    ///< ψ at the level itself, if atLevel
    double lapse = 0.0;
    double guess = 0.0;
    double logLikelihood = 0.0;
};

/// Returns the most likely step over all positions: the supremum of the likelihood as width → 0.
StepCurve bestStep(const LevelsView& levels, const FreeParameters& free, double lapse, double guess) noexcept;
/// Returns the likelihood of one common proportion at all levels, clamped between guess and 1 − lapse: the
/// supremum as width → ∞.
double flatLogLikelihood(const LevelsView& levels, const FreeParameters& free, double lapse,
                         double guess) noexcept;
/// Returns a curve so steep that its likelihood equals that of the step (to 1e-8; beyond the neighbouring
/// levels S is 0 or 1 to 1e-15, for t to 1e-9).
UnitCurve curveOf(const StepCurve& step, const LevelsView& levels, Sigmoid sigmoid) noexcept;

} // namespace chiron::psychophysics
