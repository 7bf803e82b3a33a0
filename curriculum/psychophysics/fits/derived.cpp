// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {
namespace {

double standardPlace(const FitResult& fit, double x) {
    const SigmoidUnits units = unitsOf(fit.function);
    return units.middle + units.spread * (toScale(x, fit.scale) - fit.best.threshold) / fit.best.width;
}

} // namespace

double proportionAt(const FitResult& fit, double x) {
    const double z = standardPlace(fit, x);
    return std::isnan(z)
               ? kNotKnown
               : fit.best.guess + (1.0 - fit.best.guess - fit.best.lapse) * sigmoidAt(fit.function, z).rise;
}

double thresholdAt(const FitResult& fit, const CurveParameters& at, double proportion, bool unscaled) {
    const double s = unscaled ? proportion : (proportion - at.guess) / (1.0 - at.guess - at.lapse);
    if (!(s > 0.0 && s < 1.0) || std::isnan(at.threshold)) {
        return kNotKnown;
    }
    const SigmoidUnits units = unitsOf(fit.function);
    return fromScale(
        at.threshold + at.width * (sigmoidInverse(fit.function, s) - units.middle) / units.spread, fit.scale);
}

double thresholdAt(const FitResult& fit, double proportion, bool unscaled) {
    return thresholdAt(fit, fit.best, proportion, unscaled);
}

double slopeAt(const FitResult& fit, double x) {
    const double z = standardPlace(fit, x);
    const double reach = 1.0 - fit.best.guess - fit.best.lapse;
    return std::isnan(z)
               ? kNotKnown
               : reach * sigmoidAt(fit.function, z).slope * unitsOf(fit.function).spread / fit.best.width;
}

double pse(const FitResult& fit) {
    return thresholdAt(fit, 0.5);
}

double jnd(const FitResult& fit) {
    return 0.5 * (thresholdAt(fit, 0.75, true) - thresholdAt(fit, 0.25, true));
}

double weberFraction(const FitResult& fit, double reference) {
    return jnd(fit) / reference;
}

FitInterval intervalOf(const FitResult& fit, const std::function<double(const CurveParameters&)>& quantity) {
    std::vector<double> values;
    values.reserve(fit.draws.size());
    for (const CurveParameters& draw : fit.draws) {
        if (const double value = quantity(draw); !std::isnan(value)) {
            values.push_back(value);
        }
    }
    constexpr std::size_t kFew = 20;
    if (values.size() < kFew) {
        return {};
    }
    std::sort(values.begin(), values.end());
    const auto quantile = [&](double share) {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto at = static_cast<std::size_t>(place);
        const double next = values[std::min(at + 1, values.size() - 1)];
        return next == values[at] ? next
                                  : values[at] + (place - static_cast<double>(at)) * (next - values[at]);
    };
    const double tail = 0.5 * (1.0 - fit.confidence);
    return {quantile(tail), quantile(1.0 - tail)};
}

} // namespace chiron::psychophysics
