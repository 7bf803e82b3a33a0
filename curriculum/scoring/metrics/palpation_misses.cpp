// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationMisses(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    if (lumpsOf(answers) == 0)
        return Measurement::undefined("no lump was there");
    int misses = 0;
    for (const PalpationAnswer& answer : answers)
        misses += answer.misses();
    return Measurement::of(misses);
}

} // namespace

MetricDefinition palpationMissesMetric() {
    return {.id = "palpation_misses",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Lumps that no finding found (palpation_hits) by the trial's end.",
            .source = "models.md §6; our matching",
            .measure = measurePalpationMisses};
}

} // namespace chiron::scoring
