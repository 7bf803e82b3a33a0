// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/canal_samples.h"

#include "core/units.h"

namespace chiron::scoring {

namespace {

Measurement measureOffsetRms(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare offset_m;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isInUrethra(series, i))
            offset_m.add(series.offset_m[i]);
    });
    return offset_m.empty() ? neverInUrethra() : Measurement::of(core::mmFromM(offset_m.value()));
}

} // namespace

MetricDefinition offsetRmsMetric() {
    return {.id = "offset_rms",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Root mean square of the tip's distance from the centre-line over the samples in the urethra "
                "(0 <= s <= L), on the way in and out.",
            .source = "models.md §6, insertion",
            .measure = measureOffsetRms};
}

} // namespace chiron::scoring
