// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/insertion_events.h"
#include "scoring/metrics/canal_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureTraumaEvents(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += insertionEvents(*trial.trial).trauma.size();
    return Measurement::of(static_cast<double>(count));
}

} // namespace

MetricDefinition traumaEventsMetric() {
    return {.id = "trauma_events",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "How often the force across the canal was over the level's lateral limit for 20 ms or longer, to begin "
                "again only from below 80 % of it. It is the whole tissue force without its part along the centre-line's "
                "tangent at the tip: the wall's push, and of friction along a tilted shaft the part that lies across.",
            .source = "models.md §6, insertion",
            .measure = measureTraumaEvents};
}

} // namespace chiron::scoring
