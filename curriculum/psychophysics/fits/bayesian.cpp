// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit.h"

#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/posterior_mode.h"
#include "psychophysics/fits/posterior_region.h"
#include "psychophysics/fits/posterior_summary.h"

#include <cmath>

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
    const PosteriorModel model{levels, options.function, priorsFor(levels, options, result.scale), free, free.lapse ? 0.0 : options.lapse.value,
                               free.guess || free.equal ? 0.0 : options.guess.value, options.overdispersion};
    const CurveParameters mode = posteriorMode(model, modeStarts(model, DensityGrid(model, wholeSpace(model, kStarts))));
    const std::vector<DensityGrid> parts = posteriorParts(model, kFine);
    result.fitted = true;
    result.best = fromUnitAxis(mode, levels);
    result.logPosterior = model.logDensity(mode);
    result.freeParameters = free.count();
    summarise(result, levels);
    addPosterior(result, parts, levels, options);
    addCurve(result, levels, options);
    addGoodnessOfFit(result, data, options);
    addWarnings(result, levels, options);
    return result;
}

} // namespace chiron::psychophysics
