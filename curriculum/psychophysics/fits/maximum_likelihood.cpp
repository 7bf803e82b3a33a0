// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/bootstrap.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/likelihood_search.h"
#include "psychophysics/fits/profile_interval.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {
namespace {

/// Returns the standard errors of threshold and width from a covariance of (alpha, beta, lapse, guess), by
/// the chain rule.
CurveParameters errorsFrom(const Matrix4& covariance, const UnitCurve& curve, const PreparedLevels& levels,
                           Sigmoid sigmoid, const FreeParameters& free, double& thresholdWidth) {
    const SigmoidUnits units = unitsOf(sigmoid);
    const double byAlpha = -levels.range / curve.beta;
    const double thresholdByBeta = -levels.range * (units.middle - curve.alpha) / (curve.beta * curve.beta);
    const double widthByBeta = -units.spread * levels.range / (curve.beta * curve.beta);
    const double alpha = covariance[0][0], beta = covariance[1][1], both = covariance[0][1];
    thresholdWidth = widthByBeta * (byAlpha * both + thresholdByBeta * beta);
    CurveParameters error;
    error.threshold = std::sqrt(byAlpha * byAlpha * alpha + 2.0 * byAlpha * thresholdByBeta * both +
                                thresholdByBeta * thresholdByBeta * beta);
    error.width = std::abs(widthByBeta) * std::sqrt(beta);
    error.lapse = covariance[2][2] > 0.0 ? std::sqrt(covariance[2][2]) : kNotKnown;
    error.guess = free.equal ? error.lapse : covariance[3][3] > 0.0 ? std::sqrt(covariance[3][3]) : kNotKnown;
    return error;
}

void addErrors(FitResult& result, const PreparedLevels& levels, const FreeParameters& free,
               const UnitCurve& curve) {
    const auto inside = [](double value, double most) { return value > 1e-9 && value < most - 1e-9; };
    const std::array<bool, 4> used{true, true, free.lapse && inside(curve.lapse, free.largestLapse),
                                   free.guess && inside(curve.guess, free.largestGuess)};
    const Information information = informationAt(result.function, viewOf(levels), curve, free.equal);
    Matrix4 covariance;
    double ignored = 0.0;
    if (invertPositive(information.observed, used, covariance)) {
        result.error =
            errorsFrom(covariance, curve, levels, result.function, free, result.thresholdWidthCovariance);
    }
    if (invertPositive(information.expected, used, covariance)) {
        result.expectedError = errorsFrom(covariance, curve, levels, result.function, free, ignored);
    }
}

/// Reports a fit in which no rise is best or all answers are alike: only the log-likelihood and what follows
/// from it.
void reportFlat(FitResult& result, const PreparedLevels& levels, double height) {
    result.logLikelihood = height + levels.logCoefficients;
    result.deviance = 2.0 * (saturatedLogLikelihood(viewOf(levels)) - height);
    if (levels.totalRight > 0.0 && levels.totalRight < levels.total) {
        result.warnings.push_back(
            "no_rise: answers do not get better as the intensity grows, so there is no threshold to find");
    }
}

FitResult emptyResult(const FitOptions& options) {
    FitResult result;
    result.method = FitMethod::maximumLikelihood;
    result.function = options.function;
    result.scale = options.scale.value_or(ownScale(options.function));
    result.confidence = options.confidence;
    result.eta = kNotKnown;
    result.best.eta = kNotKnown;
    return result;
}

} // namespace

FitResult fitMaximumLikelihood(const PsychometricData& data, const FitOptions& given) {
    const FitOptions options = settled(given);
    FitResult result = emptyResult(options);
    if (std::string problem = optionsProblem(options); !problem.empty()) {
        result.warnings.push_back(std::move(problem));
        return result;
    }
    const PreparedLevels levels = prepareLevels(data, result.scale);
    result.warnings = levels.warnings;
    if (!levels.usable()) {
        return result;
    }
    const FreeParameters free = freeParameters(options);
    const double lapse = free.lapse ? 0.0 : options.lapse.value,
                 guess = free.guess || free.equal ? 0.0 : options.guess.value;
    // These options take milliseconds anyway, so the thorough search costs little.
    const bool read =
        options.profileIntervals || options.bootstrap != Bootstrap::none || options.monteCarlo > 0;
    const SearchResult found =
        (read ? searchThoroughly : searchMaximum)(options.function, viewOf(levels), free, lapse, guess);
    result.freeParameters = free.count();
    const bool oneSided = levels.totalRight == 0.0 || levels.totalRight == levels.total;
    if (found.kind == SearchResult::Kind::flat || oneSided) {
        reportFlat(result, levels, flatLogLikelihood(viewOf(levels), free, lapse, guess));
        addWarnings(result, levels, options);
        return result;
    }
    result.fitted = true;
    result.best = fromUnit(found.curve, levels, options.function);
    summarise(result, levels, found.curve);
    if (found.kind == SearchResult::Kind::curve) {
        addErrors(result, levels, free, found.curve);
    }
    if (options.profileIntervals && options.bootstrap == Bootstrap::none) {
        result.ci = profileIntervals(levels, options, found);
    }
    addSimulations(result, levels, options);
    addCurve(result, levels, options);
    addWarnings(result, levels, options);
    return result;
}

} // namespace chiron::psychophysics
