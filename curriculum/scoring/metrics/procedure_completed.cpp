// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/canal_samples.h"

namespace chiron::scoring {

namespace {

Measurement measure(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    std::size_t done = 0;
    for (const PreparedTrial& trial : trials)
        done += trial.trial->completed ? 1 : 0;
    return Measurement::of(100.0 * static_cast<double>(done) / static_cast<double>(trials.size()));
}

} // namespace

MetricDefinition procedureCompletedMetric() {
    return {.id = "procedure_completed",
            .version = 1,
            .unit = "%",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Procedures done to their end, withdrawal included, in % of those begun: one that time ended is not done.",
            .source = "models.md §1.3; data.md",
            .measure = measure};
}

} // namespace chiron::scoring
