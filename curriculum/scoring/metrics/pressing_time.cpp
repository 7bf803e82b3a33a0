// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace chiron::scoring {

namespace {

/// Length of the union of all fingers' presses: two that press at once count once.
double pressed_s(const PreparedTrial& trial) {
    std::vector<std::pair<double, double>> spans;
    forEachPress(trial, [&](double, double begin_s, double end_s) {
        if (!spans.empty() && spans.back().second == begin_s)
            spans.back().second = end_s;
        else
            spans.emplace_back(begin_s, end_s);
    });
    std::sort(spans.begin(), spans.end());
    double sum_s = 0.0;
    double until_s = -std::numeric_limits<double>::infinity();
    for (const auto& [begin_s, end_s] : spans) {
        sum_s += std::max(0.0, end_s - std::max(begin_s, until_s));
        until_s = std::max(until_s, end_s);
    }
    return sum_s;
}

Measurement measurePressingTime(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        if (trial.tool == nullptr)
            return Measurement::undefined(UndefinedReason::noSamples);
        time_s += pressed_s(trial);
    }
    return Measurement::of(time_s);
}

} // namespace

MetricDefinition pressingTimeMetric() {
    return {.id = "pressing_time",
            .version = 1,
            .unit = "s",
            .direction = Direction::neutral,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .needsForces = true,
            .definition = "Time for which any finger pressed the tissue with more than 0.02 N, each sample held until the next.",
            .source = "models.md §6; our definition",
            .measure = measurePressingTime};
}

} // namespace chiron::scoring
