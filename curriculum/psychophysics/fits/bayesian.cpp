// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit.h"

#include "psychophysics/fits/chi_square.h"
#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/likelihood_search.h"
#include "psychophysics/fits/posterior_mode.h"
#include "psychophysics/fits/posterior_region.h"
#include "psychophysics/fits/posterior_summary.h"

#include <algorithm>
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

/// Adds the goodness of fit, which is a property of curve and data: the Monte Carlo p of the
/// maximum-likelihood fit of the same curve.
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

/// The model of the answers with one of the priors of the width, and its posterior.
struct Posterior {
    PosteriorModel model;
    std::vector<DensityGrid> parts;
};

Posterior posteriorWith(const PosteriorModel& like, WidthPrior width) {
    PosteriorModel model = like;
    model.priors.ofWidth = width;
    std::vector<DensityGrid> parts = posteriorParts(model, kFine);
    return {model, std::move(parts)};
}

/// Returns whether psignifit's prior, and not the answers, limits how flat the curve may be, that is, whether
/// most of the posterior lies where the prior falls. The bound is chosen so that none of the 39 published
/// sets of psignifit's own tests is affected (README).
bool endsAbove(const Posterior& psignifit) {
    constexpr double kMostAbove = 0.8;
    return 1.0 - widthBelow(psignifit.parts, psignifit.model.priors.fullWidthTo()) > kMostAbove;
}

/// Returns whether the prior limits how steep the curve may be, that is, whether the 95 % interval of the
/// width begins at half the width or less when the prior is open there. 95 % is used whatever confidence is
/// asked for, so that intervals of less confidence lie within those of more.
bool endsBelow(const Posterior& psignifit, const Posterior& open) {
    constexpr double kHalf = 0.5, kTail = 0.025;
    return widthQuantile(open.parts, kTail) < kHalf * widthQuantile(psignifit.parts, kTail);
}

/// Returns the posterior for the intervals: with psignifit's prior, opened at each end where it would
/// determine the interval.
Posterior forIntervals(Posterior psignifit) {
    // Share of the posterior below which opening the prior never halves the lower end of a 95 % interval.
    constexpr double kNothingBelow = 0.003;
    const bool above = endsAbove(psignifit);
    if (widthBelow(psignifit.parts, psignifit.model.priors.fullWidthFrom()) > kNothingBelow) {
        if (Posterior open = posteriorWith(psignifit.model, above ? WidthPrior::wide : WidthPrior::openBelow);
            endsBelow(psignifit, open)) {
            return open;
        }
    }
    return above ? posteriorWith(psignifit.model, WidthPrior::openAbove) : psignifit;
}

/// Warns where the priors cut off the posterior at their ends, because nothing else in the result shows this.
void warnOfPriors(FitResult& result, const std::vector<DensityGrid>& parts, const PosteriorModel& model) {
    constexpr double kMuch = 0.05, kDecided = 0.7;
    const FitPriors& priors = model.priors;
    if (thresholdBelow(parts, priors.low) > kMuch || thresholdBelow(parts, priors.high) < 1.0 - kMuch) {
        result.warnings.push_back("prior_edge: the threshold may lie outside the intensities presented, "
                                  "where its prior ends the interval; present others");
    }
    if (widthBelow(parts, priors.fullWidthTo()) < 1.0 - kMuch) {
        result.warnings.push_back("prior_edge: the curve may be flatter than the prior of its width allows "
                                  "for, which ends the interval; present a wider range");
    }
    if (const CurveParameters& influence = result.priorInfluence;
        influence.threshold > kDecided || influence.width > kDecided) {
        result.warnings.push_back(std::string("prior_decides: answers say hardly more of the ") +
                                  (influence.threshold > kDecided ? "threshold" : "width") +
                                  " than was assumed before them; its interval is that of the prior");
    }
}

/// Warns where psignifit's prior, and not the answers, would end an interval.
void warnOfWidthPrior(FitResult& result, const Posterior& posterior, const FitOptions& options) {
    const FitPriors& priors = posterior.model.priors;
    if (options.widthPrior == WidthPrior::automatic && priors.ofWidth != WidthPrior::psignifit) {
        const char* as = priors.ofWidth == WidthPrior::wide ? "steeper or flatter"
                         : priors.openBelow()               ? "steeper"
                                                            : "flatter";
        result.warnings.push_back(
            std::string("prior_widened: the curve may well be ") + as +
            " than psignifit's prior expects, so the intervals are those of a prior that "
            "leaves the width open there; threshold and width themselves are psignifit's");
        return;
    }
    const bool above = !priors.openAbove() && endsAbove(posterior);
    const bool below =
        !priors.openBelow() && options.widthPrior != WidthPrior::automatic &&
        endsBelow(posterior, posteriorWith(posterior.model,
                                           priors.openAbove() ? WidthPrior::wide : WidthPrior::openBelow));
    if (above || below) {
        result.warnings.push_back(std::string("prior_edge: the curve may well be ") +
                                  (!above  ? "steeper"
                                   : below ? "steeper or flatter"
                                           : "flatter") +
                                  " than psignifit's prior expects, which then ends the interval of the "
                                  "width; fit with the wide prior");
    }
}

/// Begins the interval of the width at 0 if the prior is open towards a step and a step explains the answers
/// within chance. The lower quantile of a posterior that is highest at a step would claim that the curve is
/// less steep than that, which no answer supports.
void beginAtStep(FitResult& result, const PosteriorModel& model, const FitOptions& options) {
    if (model.priors.openBelow() &&
        likelihoodRatioOfStep(model.levels, model.sigmoid, model.free, model.lapse, model.guess) <
            chiSquareQuantileOne(options.confidence)) {
        result.ci.width.low = 0.0;
    }
}

/// Extends an interval to include another one. A prior that is open at one end may only extend an interval,
/// but by itself it also shortens the other end and the interval of the threshold.
void holdBoth(FitInterval& interval, const FitInterval& other) {
    interval.low = std::min(interval.low, other.low);
    interval.high = std::max(interval.high, other.high);
}

void takeIntervals(FitResult& result, const Posterior& posterior, const FitOptions& options) {
    result.intervalPrior = posterior.model.priors.ofWidth;
    addIntervals(result, posterior.parts, posterior.model.priors, posterior.model.levels, options);
    beginAtStep(result, posterior.model, options);
    warnOfWidthPrior(result, posterior, options);
    warnOfPriors(result, posterior.parts, posterior.model);
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
    const WidthPrior width =
        options.widthPrior == WidthPrior::automatic ? WidthPrior::psignifit : options.widthPrior;
    const PosteriorModel model{levels,
                               options.function,
                               priorsFor(levels, options, result.scale, width),
                               free,
                               free.lapse ? 0.0 : options.lapse.value,
                               free.guess || free.equal ? 0.0 : options.guess.value,
                               options.overdispersion};
    const CurveParameters mode =
        posteriorMode(model, modeStarts(model, DensityGrid(model, wholeSpace(model, kStarts))));
    Posterior posterior{model, posteriorParts(model, kFine)};
    result.fitted = true;
    result.best = fromUnitAxis(mode, levels);
    result.logPosterior = model.logDensity(mode);
    result.freeParameters = free.count();
    summarise(result, levels);
    addMeans(result, posterior.parts, levels, options);
    if (options.widthPrior == WidthPrior::automatic) {
        FitOptions endsAlone = options;
        endsAlone.draws = endsAlone.curvePoints = 0;
        addIntervals(result, posterior.parts, posterior.model.priors, posterior.model.levels, endsAlone);
        const ParameterIntervals before = result.ci;
        takeIntervals(result, forIntervals(std::move(posterior)), options);
        holdBoth(result.ci.threshold, before.threshold);
        holdBoth(result.ci.width, before.width);
    } else {
        takeIntervals(result, posterior, options);
    }
    addCurve(result, levels, options);
    addGoodnessOfFit(result, data, options);
    addWarnings(result, levels, options);
    return result;
}

} // namespace chiron::psychophysics
