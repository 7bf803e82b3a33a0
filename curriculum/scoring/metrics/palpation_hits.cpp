// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationHits(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    if (lumpsOf(answers) == 0)
        return Measurement::undefined("no lump was there");
    int hits = 0;
    for (const PalpationAnswer& answer : answers)
        hits += answer.hits();
    return Measurement::of(hits);
}

} // namespace

MetricDefinition palpationHitsMetric() {
    return {.id = "palpation_hits",
            .version = 1,
            .unit = "count",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Lumps that were found: a finding lies within the hit radius of the lump's place, or within the "
                          "lump's radius where that is larger; the nearest pair first, each finding and lump once.",
            .source = "models.md §6; our matching",
            .measure = measurePalpationHits};
}

} // namespace chiron::scoring
