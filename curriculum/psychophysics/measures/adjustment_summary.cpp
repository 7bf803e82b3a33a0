// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/adjustment_summary.h"

#include "core/normal_distribution.h"
#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/sample_moments.h"

#include <cmath>

namespace chiron::psychophysics {

namespace {

constexpr int kFewSettings = 5;

void warnOfAdjustment(AdjustmentSummary& result, std::size_t given) {
    const int leftOut = static_cast<int>(given) - result.settings;
    if (leftOut > 0)
        result.warnings.push_back({WarningKind::leftOutSettings, leftOut});
    if (result.settings == 0)
        result.warnings.push_back({WarningKind::noSettings});
    else if (result.settings < kFewSettings)
        result.warnings.push_back({WarningKind::fewSettings, result.settings});
    if (result.settings > 1 && result.sdLog10 <= 0.0)
        result.warnings.push_back({WarningKind::noSpread});
}

} // namespace

AdjustmentSummary summariseSettings(double reference, const std::vector<double>& settings) {
    AdjustmentSummary result;
    if (!(reference > 0.0) || !std::isfinite(reference)) {
        result.warnings.push_back({WarningKind::noSettingReference});
        return result;
    }
    std::vector<double> ratios;
    for (const double value : settings)
        if (value > 0.0 && std::isfinite(value))
            ratios.push_back(std::log10(value / reference));
    const SampleMoments moments = momentsOf(ratios);
    result.settings = moments.count;
    result.constantErrorLog10 = moments.mean;
    result.pse = reference * std::pow(10.0, moments.mean);
    if (moments.count > 1) {
        const double degrees = moments.count - 1.0;
        const double half =
            studentQuantile(0.975, degrees) * moments.sd / std::sqrt(static_cast<double>(moments.count));
        result.pseLow = reference * std::pow(10.0, moments.mean - half);
        result.pseHigh = reference * std::pow(10.0, moments.mean + half);
        result.sdLog10 = moments.sd;
        result.sdLow = moments.sd * std::sqrt(degrees / chiSquareQuantile(0.975, degrees));
        result.sdHigh = moments.sd * std::sqrt(degrees / chiSquareQuantile(0.025, degrees));
        result.jndLog10 = core::normalQuantile(0.75) * moments.sd;
    }
    warnOfAdjustment(result, settings.size());
    return result;
}

} // namespace chiron::psychophysics
