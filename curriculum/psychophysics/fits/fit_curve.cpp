// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/fit_summary.h"

#include <algorithm>

namespace chiron::psychophysics {
namespace {

/// Returns percentiles of ψ over all draws at one position.
FitInterval bandAt(const FitResult& result, double axis, std::vector<double>& values) {
    const SigmoidUnits units = unitsOf(result.function);
    values.clear();
    for (const CurveParameters& draw : result.draws) {
        const double z = units.middle + units.spread * (axis - draw.threshold) / draw.width;
        values.push_back(draw.guess + (1.0 - draw.guess - draw.lapse) * sigmoidAt(result.function, z).rise);
    }
    const double tail = 0.5 * (1.0 - result.confidence), last = static_cast<double>(values.size() - 1);
    const auto at = [&](double share) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * last + 0.5);
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    return {at(tail), at(1.0 - tail)};
}

} // namespace

void addCurve(FitResult& result, const PreparedLevels& levels, const FitOptions& options) {
    if (options.curvePoints < 2 || !result.fitted) {
        return;
    }
    constexpr double kBeyond = 0.1;
    const double low = levels.centre - (0.5 + kBeyond) * levels.range,
                 length = (1.0 + 2.0 * kBeyond) * levels.range;
    const UnitCurve curve = toUnit(result.best, levels, result.function);
    std::vector<double> values;
    constexpr std::size_t kFewest = 100;
    for (int i = 0; i < options.curvePoints; ++i) {
        const double axis = low + length * i / (options.curvePoints - 1);
        CurveSample sample{fromScale(axis, result.scale),
                           proportionOf(result.function, curve, (axis - levels.centre) / levels.range)};
        if (result.draws.size() >= kFewest) {
            const FitInterval band = bandAt(result, axis, values);
            sample.low = band.low;
            sample.high = band.high;
        }
        result.curve.push_back(sample);
    }
}

} // namespace chiron::psychophysics
