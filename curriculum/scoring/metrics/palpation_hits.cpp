// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationHitsOf(const JudgedTrials& judgedTrials) {
    const auto& [answers, undefined] = judgedTrials;
    if (undefined)
        return *undefined;
    if (lumpsOf(answers) == 0)
        return Measurement::undefined(UndefinedReason::noLumpThere);
    int hits = 0;
    for (const PalpationAnswer& answer : answers)
        hits += answer.hits();
    return Measurement::of(hits);
}

Measurement measurePalpationHits(std::span<const PreparedTrial> trials) { return measurePalpationHitsOf(judged(trials)); }
Measurement measurePalpationHits2(std::span<const PreparedTrial> trials) { return measurePalpationHitsOf(judgedSafely(trials)); }

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

MetricDefinition palpationHitsMetric2() {
    MetricDefinition metric = palpationHitsMetric();
    metric.version = 2;
    metric.wrench = MetricWrench::tissue;
    metric.tools = MetricTools::all;
    metric.needsForces = true;
    metric.definition = "Lumps that were found, as in version 1, and at no time of the trial pressed harder than the level's limit within the same reach of their place.";
    metric.measure = measurePalpationHits2;
    return metric;
}

} // namespace chiron::scoring
