// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/metrics/handling_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureCoverage(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* coverage = quantityOf(trial, "coverage");
        if (coverage == nullptr || coverage->values.empty())
            return Measurement::undefined(UndefinedReason::noCoverage);
        sum += coverage->values.back();
    }
    return Measurement::of(100.0 * sum / static_cast<double>(trials.size()));
}

} // namespace

MetricDefinition coverageMetric() {
    return {.id = "coverage",
            .version = 1,
            .unit = "%",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "Share of the search area that was pressed with at least the level's cover force by the trial's end, "
                          "as recorded; the mean over the trials.",
            .source = "models.md §6 (area covered)",
            .measure = measureCoverage};
}

} // namespace chiron::scoring
