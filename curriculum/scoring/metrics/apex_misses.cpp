// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/apex_answer.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureApexMisses(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    return Measurement::of(static_cast<double>(
        std::count_if(all.answers.begin(), all.answers.end(), [](const ApexAnswer& a) { return a.miss; })));
}

} // namespace

MetricDefinition apexMissesMetric() {
    return {.id = "apex_misses",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Trials marked out of contact, marked farther than R from the apex, or not marked in time; "
                "their errors count all the same.",
            .source = "models.md §2.3; P2, Preliminary Validation",
            .measure = measureApexMisses};
}

} // namespace chiron::scoring
