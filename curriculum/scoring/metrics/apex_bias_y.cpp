// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/apex_answer.h"

namespace chiron::scoring {

namespace {

Measurement measureApexBiasY(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    double sum = 0.0;
    for (const ApexAnswer& answer : all.answers)
        sum += answer.errorY_percent;
    return Measurement::of(sum / static_cast<double>(all.answers.size()));
}

} // namespace

MetricDefinition apexBiasYMetric() {
    return {.id = "apex_bias_y",
            .version = 1,
            .unit = "% of R",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Mean of the signed errors 100 (y - y0)/R; nearer zero is better.",
            .source = "models.md §2.3; P2, Preliminary Validation",
            .measure = measureApexBiasY};
}

} // namespace chiron::scoring
