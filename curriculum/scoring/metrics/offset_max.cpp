// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/canal_samples.h"

#include "core/units.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureOffsetMax(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double largest_m = -1.0;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isInUrethra(series, i))
            largest_m = std::max(largest_m, series.offset_m[i]);
    });
    return largest_m < 0.0 ? neverInUrethra() : Measurement::of(core::mmFromM(largest_m));
}

} // namespace

MetricDefinition offsetMaxMetric() {
    return {.id = "offset_max",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Largest distance of the tip from the centre-line in the urethra (0 <= s <= L), on the way in and out.",
            .source = "models.md §6, insertion",
            .measure = measureOffsetMax};
}

} // namespace chiron::scoring
