// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"

#include <functional>

namespace chiron::psychophysics {

/// Fits by binomial maximum likelihood (Wichmann & Hill 2001). It never fails: a value that cannot be
/// determined is not a number, with a warning. Intervals are bootstrap intervals (BCa) if asked for, else
/// profile likelihood. Deterministic.
/// Thread: any.
FitResult fitMaximumLikelihood(const PsychometricData& data, const FitOptions& options);

/// Computes the beta-binomial posterior with the priors of Schütt et al. (2016). `threshold` and the other
/// parameters are its mode, `mean` its mean, `ci` its credible intervals. It never fails, as above.
FitResult fitBayesian(const PsychometricData& data, const FitOptions& options);

/// Returns ψ(x) of a fit; x in given units.
double proportionAt(const FitResult& fit, double x);
/// Returns x (given units) at a proportion, either of the unscaled sigmoid or of ψ with guess and lapse. Not
/// a number if the curve never reaches it.
double thresholdAt(const FitResult& fit, double proportion, bool unscaled = false);
/// The same for any parameter set (a bootstrap or posterior draw) with the fit's function and axis.
double thresholdAt(const FitResult& fit, const CurveParameters& at, double proportion, bool unscaled = false);
double slopeAt(const FitResult& fit, double x); ///< dψ/dx on the fitted axis; x in given units
double pse(const FitResult& fit); ///< x at which ψ = 0.5 (yes–no and comparisons; not for m-AFC)
double jnd(const FitResult& fit); ///< (x75 − x25)/2 of the unscaled sigmoid, given units
double weberFraction(const FitResult& fit, double reference); ///< jnd/reference

/// Returns the central interval, over fit.draws, of any quantity computed from a parameter set (bootstrap
/// percentiles or posterior).
FitInterval intervalOf(const FitResult& fit, const std::function<double(const CurveParameters&)>& quantity);

} // namespace chiron::psychophysics
