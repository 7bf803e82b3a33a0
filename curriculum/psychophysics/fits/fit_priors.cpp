// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit_priors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace chiron::psychophysics {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

double logHalfCosine(double turn) noexcept { // ln(½ + ½cos)
    const double value = 0.5 + 0.5 * std::cos(turn);
    return value > 0.0 ? std::log(value) : kImpossible;
}

/// Returns the standard deviation of value(x) under the density exp(logDensity(x)) over low..high, by the
/// midpoint rule.
template <class Density, class Value>
double standardDeviation(double low, double high, Density&& logDensity, Value&& value) noexcept {
    constexpr int kPieces = 2000;
    double total = 0.0, sum = 0.0, squares = 0.0;
    for (int i = 0; i < kPieces; ++i) {
        const double x = low + (high - low) * (i + 0.5) / kPieces, mass = std::exp(logDensity(x)),
                     v = value(x);
        total += mass;
        sum += mass * v;
        squares += mass * v * v;
    }
    return std::sqrt(std::max(0.0, squares / total - sum * sum / (total * total)));
}

constexpr std::pair<std::string_view, WidthPrior> kTokens[] = {{"auto", WidthPrior::automatic},
                                                               {"psignifit", WidthPrior::psignifit},
                                                               {"open_below", WidthPrior::openBelow},
                                                               {"open_above", WidthPrior::openAbove},
                                                               {"wide", WidthPrior::wide}};

} // namespace

std::string_view widthPriorToken(WidthPrior prior) noexcept {
    return std::find_if(std::begin(kTokens), std::end(kTokens) - 1,
                        [prior](const auto& one) { return one.second == prior; })
        ->first;
}

std::optional<WidthPrior> widthPriorFromToken(std::string_view token) noexcept {
    for (const auto& [name, prior] : kTokens) {
        if (name == token) {
            return prior;
        }
    }
    return std::nullopt;
}

double priorThresholdSd(const FitPriors& priors) noexcept {
    return standardDeviation(
        priors.lowestThreshold(), priors.highestThreshold(), [&](double x) { return priors.logThreshold(x); },
        [](double x) { return x; });
}

double priorLogWidthSd(const FitPriors& priors) noexcept { // over ln width, where the density is multiplied
                                                           // by the width
    return standardDeviation(
        std::log(priors.lowestWidth()), std::log(priors.largestWidth()),
        [&](double x) { return priors.logWidth(std::exp(x)) + x; }, [](double x) { return x; });
}

double priorShareSd(const FitPriors& priors, double largest) noexcept {
    return standardDeviation(
        0.0, largest, [&](double x) { return priors.logShare(x); }, [](double x) { return x; });
}

double FitPriors::logThreshold(double threshold) const noexcept {
    const double beyond = std::max({low - threshold, threshold - high, 0.0});
    if (beyond <= 0.0) {
        return 0.0;
    }
    return beyond < 0.5 * range() ? logHalfCosine(2.0 * std::numbers::pi * beyond / range()) : kImpossible;
}

double FitPriors::logWidth(double width) const noexcept {
    if (!(width >= lowestWidth()) || width > largestWidth()) {
        return kImpossible;
    }
    if (width >= fullWidthTo()) {
        return logHalfCosine(0.5 * std::numbers::pi * (width - fullWidthTo()) /
                             (0.5 * (largestWidth() - fullWidthTo())));
    }
    return width < fullWidthFrom() ? logHalfCosine(std::numbers::pi * (fullWidthFrom() - width) / spacing)
                                   : 0.0;
}

double FitPriors::logShare(double share) const noexcept {
    return (beta - 1.0) * std::log1p(-share);
}

FitPriors priorsFor(const PreparedLevels& levels, const FitOptions& options, StimulusScale scale,
                    WidthPrior width) noexcept {
    FitPriors priors;
    priors.ofWidth = width;
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
