// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationCriterion(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    const core::DetectionCounts counts = countsOf(answers);
    return core::isUsable(counts) ? Measurement::of(core::criterion(counts)) : tooFewRegions(counts);
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

} // namespace chiron::scoring
