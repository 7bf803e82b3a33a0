// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit.h"

#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/likelihood_search.h"
#include "psychophysics/fits/posterior_mode.h"
#include "psychophysics/fits/posterior_region.h"
#include "psychophysics/fits/posterior_summary.h"

#include <cmath>
#include <string>

namespace chiron::psychophysics {
namespace {

constexpr GridSize kStarts{{8, 4}, {9, 3}, {2, 3}, {2, 2}};
constexpr GridSize kFine{{6, 6}, {6, 6}, {3, 4}, {1, 5}};

CurveParameters fromUnitAxis(const CurveParameters& at, const PreparedLevels& levels) noexcept {
    return {levels.centre + levels.range * at.threshold, levels.range * at.width, at.lapse, at.guess, at.eta};
}

FitResult startResult(const FitOptions& options) {
    FitResult result;
    result.method = FitMethod::bayesian;
    result.function = options.function;
    result.scale = options.scale.value_or(ownScale(options.function));
    result.confidence = options.confidence;
    result.eta = kNotKnown;
    result.best.eta = result.mean.eta = kNotKnown;
    return result;
}

/// Goodness of fit is a property of curve and data: the Monte Carlo p of the maximum-likelihood fit of the same curve.
void addGoodnessOfFit(FitResult& result, const PsychometricData& data, FitOptions options) {
    if (options.monteCarlo <= 0) {
        return;
    }
    options.bootstrap = Bootstrap::none;
    options.profileIntervals = false;
    if (const FitResult likely = fitMaximumLikelihood(data, options); likely.fitted) {
        result.pValue = likely.pValue;
    }
}

/// Whether answers and psignifit's prior of the width disagree: most of the posterior lies where the prior falls towards its upper end; or much lies
/// where it falls towards its lower end, while a step, which it rules out, explains the answers almost as well as any curve. The three bounds
/// are such that none of the 39 published sets of psignifit's own tests is concerned (README).
bool priorDisagrees(const std::vector<DensityGrid>& parts, const PosteriorModel& model) {
    constexpr double kMostAbove = 0.8, kMuchBelow = 0.15, kStepNearlyAsLikely = 3.0;
    const FitPriors& priors = model.priors;
    if (1.0 - widthBelow(parts, priors.fullWidthTo()) > kMostAbove) {
        return true;
    }
    return widthBelow(parts, priors.fullWidthFrom()) > kMuchBelow &&
           likelihoodRatioOfStep(model.levels, model.sigmoid, model.free, model.lapse, model.guess) < kStepNearlyAsLikely;
}

/// What the priors leave open at their ends: nothing that a fit says of the answers helps there.
void warnOfPriors(FitResult& result, const std::vector<DensityGrid>& parts, const PosteriorModel& model) {
    constexpr double kMuch = 0.05, kDecided = 0.7;
    const FitPriors& priors = model.priors;
    if (thresholdBelow(parts, priors.low) > kMuch || thresholdBelow(parts, priors.high) < 1.0 - kMuch) {
        result.warnings.push_back("prior_edge: the threshold may lie outside the intensities presented, where its prior ends the interval; present others");
    }
    if (widthBelow(parts, priors.fullWidthTo()) < 1.0 - kMuch) {
        result.warnings.push_back("prior_edge: the curve may be flatter than the prior of its width allows for, which ends the interval; present a wider range");
    }
    if (const CurveParameters& influence = result.priorInfluence; influence.threshold > kDecided || influence.width > kDecided) {
        result.warnings.push_back(std::string("prior_decides: answers say hardly more of the ") + (influence.threshold > kDecided ? "threshold" : "width") +
                                  " than was assumed before them; its interval is that of the prior");
    }
}

void takeIntervals(FitResult& result, const std::vector<DensityGrid>& parts, const PosteriorModel& model, const FitOptions& options) {
    result.intervalPrior = model.priors.wide ? WidthPrior::wide : WidthPrior::psignifit;
    addIntervals(result, parts, model.priors, model.levels, options);
    if (model.priors.wide && options.widthPrior == WidthPrior::automatic) {
        result.warnings.push_back("prior_widened: the curve may well be steeper or flatter than psignifit's prior expects, so the intervals are those of a prior that "
                                  "leaves the width open; threshold and width themselves are psignifit's");
    } else if (options.widthPrior == WidthPrior::psignifit && priorDisagrees(parts, model)) {
        result.warnings.push_back("prior_edge: the curve may well be steeper or flatter than psignifit's prior expects, which then ends the interval of the width; "
                                  "fit with the wide prior");
    }
    warnOfPriors(result, parts, model);
}

} // namespace

FitResult fitBayesian(const PsychometricData& data, const FitOptions& given) {
    const FitOptions options = settled(given);
    FitResult result = startResult(options);
    std::string problem = optionsProblem(options);
    if (problem.empty() && !(options.betaPrior >= 1.0)) {
        problem = "bad_options: the beta prior must be at least 1";
    }
    if (!problem.empty()) {
        result.warnings.push_back(std::move(problem));
        return result;
    }
    const PreparedLevels levels = prepareLevels(data, result.scale);
    result.warnings = levels.warnings;
    if (!levels.usable()) {
        return result;
    }
    const FreeParameters free = freeParameters(options);
    const auto modelOf = [&](bool wide) {
        return PosteriorModel{levels, options.function, priorsFor(levels, options, result.scale, wide), free, free.lapse ? 0.0 : options.lapse.value,
                              free.guess || free.equal ? 0.0 : options.guess.value, options.overdispersion};
    };
    const PosteriorModel model = modelOf(options.widthPrior == WidthPrior::wide);
    const CurveParameters mode = posteriorMode(model, modeStarts(model, DensityGrid(model, wholeSpace(model, kStarts))));
    const std::vector<DensityGrid> parts = posteriorParts(model, kFine);
    result.fitted = true;
    result.best = fromUnitAxis(mode, levels);
    result.logPosterior = model.logDensity(mode);
    result.freeParameters = free.count();
    summarise(result, levels);
    addMeans(result, parts, levels, options);
    if (options.widthPrior == WidthPrior::automatic && priorDisagrees(parts, model)) {
        const PosteriorModel wide = modelOf(true);
        takeIntervals(result, posteriorParts(wide, kFine), wide, options);
    } else {
        takeIntervals(result, parts, model, options);
    }
    addCurve(result, levels, options);
    addGoodnessOfFit(result, data, options);
    addWarnings(result, levels, options);
    return result;
}

} // namespace chiron::psychophysics
