// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit_priors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace chiron::psychophysics {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

double logHalfCosine(double turn) noexcept { // ln(½ + ½cos)
    const double value = 0.5 + 0.5 * std::cos(turn);
    return value > 0.0 ? std::log(value) : kImpossible;
}

} // namespace

double FitPriors::logThreshold(double threshold) const noexcept {
    const double beyond = std::max({low - threshold, threshold - high, 0.0});
    if (beyond <= 0.0) {
        return 0.0;
    }
    return beyond < 0.5 * range() ? logHalfCosine(2.0 * std::numbers::pi * beyond / range()) : kImpossible;
}

double FitPriors::logWidth(double width) const noexcept {
    if (!(width >= spacing) || width > largestWidth()) {
        return kImpossible;
    }
    if (width >= range()) {
        return logHalfCosine(0.5 * std::numbers::pi * (width - range()) / range());
    }
    return width <= 2.0 * spacing ? logHalfCosine(std::numbers::pi * (2.0 * spacing - width) / spacing) : 0.0;
}

double FitPriors::logShare(double share) const noexcept { return (beta - 1.0) * std::log1p(-share); }

FitPriors priorsFor(const PreparedLevels& levels, const FitOptions& options, StimulusScale scale) noexcept {
    FitPriors priors;
    priors.beta = options.betaPrior;
    const auto unit = [&](double x) { return (toScale(x, scale) - levels.centre) / levels.range; };
    if (options.lowest && options.highest) {
        const double low = unit(*options.lowest), high = unit(*options.highest);
        if (std::isfinite(low) && std::isfinite(high) && low < high) {
            priors.low = low;
            priors.high = high;
        }
    }
    priors.spacing = std::min(levels.spacing / levels.range, priors.range());
    return priors;
}

} // namespace chiron::psychophysics
