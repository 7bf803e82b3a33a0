// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/apex_answer.h"

namespace chiron::scoring {

namespace {

Measurement measureApexBiasX(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    double sum = 0.0;
    for (const ApexAnswer& answer : all.answers)
        sum += answer.errorX_percent;
    return Measurement::of(sum / static_cast<double>(all.answers.size()));
}

} // namespace

MetricDefinition apexBiasXMetric() {
    return {.id = "apex_bias_x",
            .version = 1,
            .unit = "% of R",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Mean of the signed errors 100 (x - x0)/R; nearer zero is better.",
            .source = "models.md §2.3; P2, Preliminary Validation",
            .measure = measureApexBiasX};
}

} // namespace chiron::scoring
