// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/finding_errors.h"

namespace chiron::scoring {

namespace {

Measurement measureSizeError(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    ErrorSum all;
    bool asked = false;
    for (const PalpationAnswer& answer : answers) {
        const ErrorSum errors = sizeErrors(answer.truth, answer.findings, answer.matches);
        all.sum += errors.sum;
        all.count += errors.count;
        asked = asked || answer.truth.asksSize;
    }
    if (all.count > 0)
        return Measurement::of(1e3 * all.sum / all.count);
    return Measurement::undefined(asked ? UndefinedReason::noSizeSaid : UndefinedReason::noSizeAsked);
}

} // namespace

MetricDefinition sizeErrorMetric() {
    return {.id = "size_error",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "|reported - true radius|, the mean over all hits whose size was said.",
            .source = "models.md §6; our definition",
            .measure = measureSizeError};
}

} // namespace chiron::scoring
