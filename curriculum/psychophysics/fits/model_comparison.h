// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"

namespace chiron::psychophysics {

/// Which parameters all conditions have in common; the others each condition has its own.
struct SharedParameters {
    bool threshold = false;
    bool width = false;
    bool lapse = false; ///< where it is free
    bool guess = false; ///< where it is free
};

/// One model of several conditions, by maximum likelihood.
struct ConditionsFit {
    bool fitted = false;
    std::vector<CurveParameters> conditions; ///< threshold on the fitted axis
    double logLikelihood = kNotKnown;        ///< with the coefficients of the rows as given
    int freeParameters = 0;
    double aic = kNotKnown;
    std::vector<std::string> warnings;       ///< "token: words"
};
/// Never fails: conditions without two usable levels are named in a warning and nothing is fitted.
ConditionsFit fitConditions(const std::vector<PsychometricData>& conditions, const FitOptions& options, const SharedParameters& shared);

/// Two nested models: the smaller has more in common.
struct ModelComparison {
    ConditionsFit smaller, larger;
    double likelihoodRatio = kNotKnown; ///< 2 (ln L larger − ln L smaller)
    int freedom = 0;
    double pValue = kNotKnown;          ///< Monte Carlo where asked for, else chi-square
    double chiSquareP = kNotKnown;      ///< chi-square with that freedom (Wilks 1938)
    int simulated = 0;                  ///< sets of answers drawn from the smaller model that could be fitted: what a Monte Carlo p is of
    double aicDifference = kNotKnown;   ///< smaller − larger: positive where the larger describes the data better
};
/// Do conditions differ in what `tested` names? Both models share what `shared` names; the smaller one `tested` too. With
/// FitOptions::monteCarlo answers are drawn from the smaller model, as many at each intensity as were given there, and both are fitted again. Both p
/// take the intensities for chosen before the answers: of adaptive runs, where answers chose them, a slope that is fitted freely is biased (Leek 2001;
/// Kaernbach 2001), and neither p holds.
ModelComparison compareConditions(const std::vector<PsychometricData>& conditions, const FitOptions& options, const SharedParameters& shared,
                                  const SharedParameters& tested);

} // namespace chiron::psychophysics
