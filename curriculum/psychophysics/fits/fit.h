// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"

#include <functional>

namespace chiron::psychophysics {

/// Binomial maximum likelihood (Wichmann & Hill 2001). Never fails: what cannot be had is not a number, with a warning. Intervals:
/// bootstrap (BCa) where asked for, else profile likelihood. Deterministic. Thread: any.
FitResult fitMaximumLikelihood(const PsychometricData& data, const FitOptions& options);

/// Beta-binomial posterior with the priors of Schütt et al. (2016). `threshold` and the rest are its mode, `mean` its mean, `ci` its
/// credible intervals. Never fails, as above.
FitResult fitBayesian(const PsychometricData& data, const FitOptions& options);

/// ψ(x) of a fit; x in given units.
double proportionAt(const FitResult& fit, double x);
/// x (given units) at a proportion: of the unscaled sigmoid, or of ψ with guess and lapse. Not a number where the curve never has it.
double thresholdAt(const FitResult& fit, double proportion, bool unscaled = false);
/// The same for any parameter set of the fit's function and axis (a bootstrap or posterior draw).
double thresholdAt(const FitResult& fit, const CurveParameters& at, double proportion, bool unscaled = false);
double slopeAt(const FitResult& fit, double x); ///< dψ/dx on the fitted axis; x in given units
double pse(const FitResult& fit);               ///< x at which ψ = 0.5 (yes–no and comparisons; not for m-AFC)
double jnd(const FitResult& fit);               ///< (x75 − x25)/2 of the unscaled sigmoid, given units
double weberFraction(const FitResult& fit, double reference); ///< jnd/reference

/// Central interval, over fit.draws, of anything computed from a parameter set (bootstrap percentiles or posterior).
FitInterval intervalOf(const FitResult& fit, const std::function<double(const CurveParameters&)>& quantity);

} // namespace chiron::psychophysics
