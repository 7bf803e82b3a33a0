// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit_summary.h"

#include "psychophysics/fits/chi_square.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

void summarise(FitResult& result, const PreparedLevels& levels) {
    summarise(result, levels, toUnit(result.best, levels, result.function));
}

void summarise(FitResult& result, const PreparedLevels& levels, const UnitCurve& curve) {
    const CurveParameters& best = result.best;
    result.threshold = fromScale(best.threshold, result.scale);
    result.width = best.width;
    result.lapse = best.lapse;
    result.guess = best.guess;
    result.eta = best.eta;
    result.levels.resize(levels.size());
    result.deviance = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const SigmoidValue s = sigmoidAt(result.function, curve.alpha + curve.beta * levels.unit[i]);
        const double reach = 1.0 - curve.guess - curve.lapse;
        const double psi = curve.guess + reach * s.rise, rest = curve.lapse + reach * s.rest;
        const double right = levels.right[i], of = levels.of[i];
        const double here = levelLogLikelihood(right, of, psi, rest);
        const double share =
            std::max(0.0, 2.0 * (levelLogLikelihood(right, of, right / of, (of - right) / of) - here));
        result.levels[i] = {levels.given[i], right, of, psi,
                            std::copysign(std::sqrt(share), right - of * psi)};
        result.deviance += share;
        sum += here;
    }
    result.logLikelihood = sum + levels.logCoefficients;
    result.aic = 2.0 * result.freeParameters - 2.0 * result.logLikelihood;
    result.degreesOfFreedom = static_cast<int>(levels.size()) - result.freeParameters;
    result.chiSquareP = chiSquareTail(result.deviance, result.degreesOfFreedom);
    result.pValue = result.chiSquareP;
}

std::string optionsProblem(const FitOptions& options) {
    const auto rate = [](const Asymptote& asymptote) {
        return asymptote.rule != Asymptote::Rule::fixed || (asymptote.value >= 0.0 && asymptote.value < 1.0);
    };
    if (!rate(options.guess) || !rate(options.lapse)) {
        return "bad_options: guess and lapse must be at least 0 and less than 1";
    }
    const bool bothFixed =
        options.guess.rule == Asymptote::Rule::fixed && options.lapse.rule == Asymptote::Rule::fixed;
    if (bothFixed && !(options.guess.value + options.lapse.value < 1.0)) {
        return "bad_options: guess and lapse together must be less than 1";
    }
    if (!(options.confidence > 0.0 && options.confidence < 1.0)) {
        return "bad_options: the confidence must lie between 0 and 1";
    }
    if (!(options.largestAsymptote > 0.0 && options.largestAsymptote <= 1.0)) {
        return "bad_options: the largest lapse must lie between 0 and 1";
    }
    return {};
}

} // namespace chiron::psychophysics
