// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/apex_answer.h"

#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureApexErrorSd(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    if (all.answers.size() < 2)
        return Measurement::undefined(UndefinedReason::needsTwoTrials);
    const double n = 2.0 * static_cast<double>(all.answers.size());
    double sum = 0.0;
    for (const ApexAnswer& answer : all.answers)
        sum += std::abs(answer.errorX_percent) + std::abs(answer.errorY_percent);
    double squares = 0.0;
    for (const ApexAnswer& answer : all.answers)
        squares += std::pow(std::abs(answer.errorX_percent) - sum / n, 2) +
                   std::pow(std::abs(answer.errorY_percent) - sum / n, 2);
    return Measurement::of(std::sqrt(squares / (n - 1.0)));
}

Measurement measureApexErrorSd2(std::span<const PreparedTrial> trials) {
    const ApexAnswers all = apexAnswers(trials);
    if (all.undefined)
        return *all.undefined;
    if (all.answers.size() < 2)
        return Measurement::undefined(UndefinedReason::needsTwoTrials);
    const double n = 2.0 * static_cast<double>(all.answers.size());
    double sum = 0.0, squares = 0.0;
    for (const ApexAnswer& answer : all.answers)
        sum += answer.countedX_percent() + answer.countedY_percent();
    for (const ApexAnswer& answer : all.answers)
        squares += std::pow(answer.countedX_percent() - sum / n, 2) + std::pow(answer.countedY_percent() - sum / n, 2);
    return Measurement::of(std::sqrt(squares / (n - 1.0)));
}

} // namespace

MetricDefinition apexErrorSdMetric() {
    return {.id = "apex_error_sd",
            .version = 1,
            .unit = "% of R",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Sample standard deviation (n - 1) of the absolute errors pooled over both axes and all "
                "trials.",
            .source = "models.md §2.3; P2, Preliminary Validation",
            .measure = measureApexErrorSd};
}

MetricDefinition apexErrorSdMetric2() {
    MetricDefinition metric = apexErrorSdMetric();
    metric.version = 2;
    metric.direction = Direction::neutral; // a hand that always misses by R has none
    metric.definition = "Sample standard deviation (n - 1) of the absolute errors pooled over both axes and all trials; a miss counts as an error of R at least.";
    metric.measure = measureApexErrorSd2;
    return metric;
}

} // namespace chiron::scoring
