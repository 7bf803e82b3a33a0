// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/canal_reach.h"
#include "scoring/metrics/canal_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureInsertionDepth(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double sum_mm = 0.0;
    for (const PreparedTrial& trial : trials) {
        double deepest_m = 0.0; // a tip that never entered
        forEachCanalSample({&trial, 1}, [&](const InsertionSeries& series, std::size_t i) {
            if (series.offset_m[i] <= core::kCanalReach_m) // beside the canal is not in it
                deepest_m = std::max(deepest_m, std::min(series.s_m[i], series.goal_m));
        });
        sum_mm += std::nearbyint(deepest_m * 1e9) / 1e6; // nearest to the decimal: a gate at the goal holds
    }
    return Measurement::of(sum_mm / static_cast<double>(trials.size()));
}

} // namespace

MetricDefinition insertionDepthMetric() {
    return {.id = "insertion_depth",
            .version = 1,
            .unit = "mm",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::mean,
            .tools = MetricTools::first,
            .definition =
                "The deepest place that the tip reached along the centre-line, no farther than 10 mm beside it, at most "
                "the level's goal; the mean over the trials.",
            .source = "models.md §1.3",
            .measure = measureInsertionDepth};
}

} // namespace chiron::scoring
