// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/urethra_insertion/scoring/insertion_moments.h"

#include "core/units.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

/// Returns none if the quantity's metrics leave the sample out.
std::optional<double> valueAt(const TrialTrace& trial, InsertionQuantity quantity, std::size_t i) {
    const ToolTrace& tool = trial.tools.front();
    const InsertionSeries& series = *insertionOf(trial);
    if (tool.paused[i] != 0)
        return std::nullopt;
    switch (quantity) {
    case InsertionQuantity::offset:
        return isInUrethra(series, i) ? std::optional(series.offset_m[i]) : std::nullopt;
    case InsertionQuantity::alignment:
        return isInUrethra(series, i) ? std::optional(series.alignment_rad[i]) : std::nullopt;
    case InsertionQuantity::bendAlignment:
        return isStage(series, i, simulation::ProcedureStage::insertion) && isAtBend(series, i)
                   ? std::optional(series.alignment_rad[i])
                   : std::nullopt;
    case InsertionQuantity::curveAlignment:
        return isStage(series, i, simulation::ProcedureStage::insertion) && isInCurve(series, i)
                   ? std::optional(series.alignment_rad[i])
                   : std::nullopt;
    case InsertionQuantity::torque:
        return i < tool.tissueTorque_Nm.size() ? std::optional(tool.tissueTorque_Nm[i].norm()) : std::nullopt;
    }
    return std::nullopt;
}

std::size_t samplesOf(const TrialTrace& trial) {
    return insertionOf(trial) != nullptr && !trial.tools.empty() ? trial.tools.front().t_s.size() : 0;
}

} // namespace

std::span<const InsertionQuantity> insertionQuantities() noexcept {
    using enum InsertionQuantity;
    static constexpr InsertionQuantity kAll[] = {offset, alignment, bendAlignment, curveAlignment, torque};
    return kAll;
}

std::span<const std::string_view> metricsOf(InsertionQuantity quantity) noexcept {
    static constexpr std::string_view kOffset[] = {"offset_rms", "offset_max"},
                                      kAlignment[] = {"alignment_rms"}, kBend[] = {"bend_alignment"},
                                      kCurve[] = {"curve_alignment"},
                                      kTorque[] = {"torque_max", "torque_rms"};
    switch (quantity) {
    case InsertionQuantity::offset:
        return kOffset;
    case InsertionQuantity::alignment:
        return kAlignment;
    case InsertionQuantity::bendAlignment:
        return kBend;
    case InsertionQuantity::curveAlignment:
        return kCurve;
    case InsertionQuantity::torque:
        return kTorque;
    }
    return {};
}

std::optional<InsertionQuantity> insertionQuantityOf(std::string_view metric) noexcept {
    for (const InsertionQuantity quantity : insertionQuantities())
        if (const auto metrics = metricsOf(quantity);
            std::find(metrics.begin(), metrics.end(), metric) != metrics.end())
            return quantity;
    return std::nullopt;
}

double inMetricUnit(InsertionQuantity quantity, double value) noexcept {
    switch (quantity) {
    case InsertionQuantity::offset:
        return core::mmFromM(value);
    case InsertionQuantity::alignment:
    case InsertionQuantity::bendAlignment:
    case InsertionQuantity::curveAlignment:
        return core::degFromRad(value);
    case InsertionQuantity::torque:
        return 1e3 * value;
    }
    return value;
}

const char* metricUnitOf(InsertionQuantity quantity) noexcept {
    switch (quantity) {
    case InsertionQuantity::offset:
        return "mm";
    case InsertionQuantity::alignment:
    case InsertionQuantity::bendAlignment:
    case InsertionQuantity::curveAlignment:
        return "°";
    case InsertionQuantity::torque:
        return "mN·m";
    }
    return "";
}

std::optional<InsertionEvent> largestOf(const TrialTrace& trial, InsertionQuantity quantity) {
    std::optional<InsertionEvent> largest;
    for (std::size_t i = 0; i < samplesOf(trial); ++i) {
        const std::optional<double> value = valueAt(trial, quantity, i);
        const double t_s = trial.tools.front().t_s[i];
        if (value && (!largest || *value > largest->value))
            largest = InsertionEvent{t_s, t_s, *value};
    }
    return largest;
}

std::vector<InsertionEvent> stretchesOver(const TrialTrace& trial, InsertionQuantity quantity, double limit) {
    std::vector<InsertionEvent> stretches;
    bool open = false;
    for (std::size_t i = 0; i < samplesOf(trial); ++i) {
        const std::optional<double> value = valueAt(trial, quantity, i);
        const double t_s = trial.tools.front().t_s[i];
        if (open)
            stretches.back().end_s = t_s;
        const bool over = value && inMetricUnit(quantity, *value) > limit;
        if (over && !open)
            stretches.push_back({t_s, t_s, *value});
        if (over)
            stretches.back().value = std::max(stretches.back().value, *value);
        open = over;
    }
    return stretches;
}

} // namespace chiron::scoring
