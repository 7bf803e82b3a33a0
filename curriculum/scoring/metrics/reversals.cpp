// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/insertion_events.h"
#include "scoring/metrics/canal_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureReversals(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += insertionEvents(*trial.trial).reversals.size();
    return Measurement::of(static_cast<double>(count));
}

} // namespace

MetricDefinition reversalsMetric() {
    return {.id = "reversals",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "How often the tip went back by 1 mm or more along the centre-line during the insertion; a way back "
                "ends where the tip has turned forward by 1 mm.",
            .source = "models.md §6, insertion",
            .measure = measureReversals};
}

} // namespace chiron::scoring
