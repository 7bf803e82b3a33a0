// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/apex_answer.h"

#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureApexErrorMean(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    double sum = 0.0;
    for (const ApexAnswer& answer : all.answers)
        sum += std::abs(answer.errorX_percent) + std::abs(answer.errorY_percent);
    return Measurement::of(sum / (2.0 * static_cast<double>(all.answers.size())));
}

Measurement measureApexErrorMean2(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    double sum = 0.0;
    for (const ApexAnswer& answer : all.answers)
        sum += answer.countedX_percent() + answer.countedY_percent();
    return Measurement::of(sum / (2.0 * static_cast<double>(all.answers.size())));
}

} // namespace

MetricDefinition apexErrorMeanMetric() {
    return {.id = "apex_error_mean",
            .version = 1,
            .unit = "% of R",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Mean of |100 (x - x0)/R| and |100 (y - y0)/R| pooled over both axes and all trials, misses "
                "included.",
            .source = "models.md §2.3; P2, Preliminary Validation",
            .measure = measureApexErrorMean};
}

MetricDefinition apexErrorMeanMetric2() {
    MetricDefinition metric = apexErrorMeanMetric();
    metric.version = 2;
    metric.definition = "Mean of |100 (x - x0)/R| and |100 (y - y0)/R| pooled over both axes and all trials; a miss counts as an error of R at least.";
    metric.measure = measureApexErrorMean2;
    return metric;
}

} // namespace chiron::scoring
