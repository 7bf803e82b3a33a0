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
    double pValue = kNotKnown;          ///< chi-square with that freedom (Wilks 1938)
    double aicDifference = kNotKnown;   ///< smaller − larger: positive where the larger describes the data better
};
/// Do conditions differ in what `tested` names? Both models share what `shared` names; the smaller one `tested` too.
ModelComparison compareConditions(const std::vector<PsychometricData>& conditions, const FitOptions& options, const SharedParameters& shared,
                                  const SharedParameters& tested);

} // namespace chiron::psychophysics
