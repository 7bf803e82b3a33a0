// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"

namespace chiron::psychophysics {

/// Says which parameters all conditions share. Of the others each condition has its own.
struct SharedParameters {
    bool threshold = false;
    bool width = false;
    bool lapse = false; ///< if it is free
    bool guess = false; ///< if it is free
};

/// A maximum-likelihood fit of one model to several conditions.
struct ConditionsFit {
    bool fitted = false;
    std::vector<CurveParameters> conditions; ///< threshold on the fitted axis
    double logLikelihood = kNotKnown;        ///< with the coefficients of the rows as given
    int freeParameters = 0;
    double aic = kNotKnown;
    std::vector<std::string> warnings; ///< "token: words"
};
/// Fits the model. It never fails: if conditions have fewer than two usable levels, a warning names them and
/// nothing is fitted.
ConditionsFit fitConditions(const std::vector<PsychometricData>& conditions, const FitOptions& options,
                            const SharedParameters& shared);

/// Comparison of two nested models; the smaller one shares more parameters.
struct ModelComparison {
    ConditionsFit smaller, larger;
    double likelihoodRatio = kNotKnown; ///< 2 (ln L larger − ln L smaller)
    int freedom = 0;
    double pValue = kNotKnown;     ///< Monte Carlo if asked for, else chi-square
    double chiSquareP = kNotKnown; ///< chi-square with that freedom (Wilks 1938)
    /// Number of data sets drawn from the smaller model that could be fitted, on which a Monte Carlo p is
    /// based.
    int simulated = 0;
    double aicDifference = kNotKnown; ///< smaller − larger: positive if the larger describes the data
                                      ///< better
};
/// Tests whether conditions differ in the parameters named by `tested`. Both models share the parameters
/// named by `shared`; the smaller model also shares `tested`. With FitOptions::monteCarlo, answers are drawn
/// from the smaller model, as many at each intensity as were given there, and both models are fitted again.
/// Both p values assume that the intensities were chosen before the answers. In adaptive runs the answers
/// chose them: a freely fitted slope is then biased (Leek 2001; Kaernbach 2001), and neither p is valid.
ModelComparison compareConditions(const std::vector<PsychometricData>& conditions, const FitOptions& options,
                                  const SharedParameters& shared, const SharedParameters& tested);

} // namespace chiron::psychophysics
