// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationMissesOf(const JudgedTrials& judgedTrials) {
    const auto& [answers, undefined] = judgedTrials;
    if (undefined)
        return *undefined;
    if (lumpsOf(answers) == 0)
        return Measurement::undefined(UndefinedReason::noLumpThere);
    int misses = 0;
    for (const PalpationAnswer& answer : answers)
        misses += answer.misses();
    return Measurement::of(misses);
}

Measurement measurePalpationMisses(std::span<const PreparedTrial> trials) { return measurePalpationMissesOf(judged(trials)); }
Measurement measurePalpationMisses2(std::span<const PreparedTrial> trials) { return measurePalpationMissesOf(judgedSafely(trials)); }

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

MetricDefinition palpationMissesMetric2() {
    MetricDefinition metric = palpationMissesMetric();
    metric.version = 2;
    metric.wrench = MetricWrench::tissue;
    metric.tools = MetricTools::all;
    metric.needsForces = true;
    metric.definition = "Lumps that were not found (palpation_hits 2) by the trial's end.";
    metric.measure = measurePalpationMisses2;
    return metric;
}

} // namespace chiron::scoring
