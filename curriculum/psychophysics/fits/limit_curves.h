// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood.h"

namespace chiron::psychophysics {

/// What a curve tends to at the ends of its parameter space, where no climb arrives: a step (width → 0) between two levels or at one of
/// them, and no rise at all (width → ∞). Their likelihoods have closed forms, lapse and guess included.
struct StepCurve {
    std::size_t level = 0;    ///< the step is at this level ...
    bool atLevel = false;     ///< ... which then has a share of its own; else it lies between the level before and this one
    double share = 0.0;       ///< ψ at the level itself, where atLevel
    double lapse = 0.0;
    double guess = 0.0;
    double logLikelihood = 0.0;
};

/// The most likely step among all places: the supremum of the likelihood as width → 0.
StepCurve bestStep(const LevelsView& levels, const FreeParameters& free, double lapse, double guess) noexcept;
/// The likelihood of one proportion at every level, held between guess and 1 − lapse: the supremum as width → ∞.
double flatLogLikelihood(const LevelsView& levels, const FreeParameters& free, double lapse, double guess) noexcept;
/// A curve so steep that its likelihood is that of the step (to 1e-8; beyond the neighbouring levels S is 0 or 1 to 1e-15, t: 1e-9).
UnitCurve curveOf(const StepCurve& step, const LevelsView& levels, Sigmoid sigmoid) noexcept;

} // namespace chiron::psychophysics
