// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationCriterion(std::span<const PreparedTrial> trials) {
    return ofRegions(judged(trials), [](const core::DetectionCounts& counts) { return core::criterion(counts); });
}

Measurement measurePalpationCriterion2(std::span<const PreparedTrial> trials) {
    return ofRegions(judgedSafely(trials), [](const core::DetectionCounts& counts) { return core::weightedCriterion(counts); });
}

} // namespace

MetricDefinition palpationCriterionMetric() {
    return {.id = "palpation_criterion",
            .version = 1,
            .unit = "",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "c = -1/2 (z(H) + z(F)) with the rates of palpation_d_prime; above 0: rather no; absent below 20 "
                          "regions of either kind.",
            .source = "models.md §6; Hautus 1995; Macmillan & Creelman 2005, eq. 2.1",
            .measure = measurePalpationCriterion};
}

MetricDefinition palpationCriterionMetric2() {
    MetricDefinition metric = palpationCriterionMetric();
    metric.version = 2;
    metric.definition = "c = -1/2 (z(H) + z(F)) with the rates of palpation_d_prime 2; above 0: rather no; absent below 20 regions of either kind.";
    metric.measure = measurePalpationCriterion2;
    return metric;
}

} // namespace chiron::scoring
