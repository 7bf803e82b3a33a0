// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

namespace chiron::scoring {

namespace {

Measurement measureProcedureCompleted(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined("no trials");
    for (const PreparedTrial& trial : trials) // where a mark ends a trial there is no procedure to complete
        if (trial.tool == nullptr || (!trial.trial->insertion && trial.trial->quantities.empty()))
            return Measurement::undefined("the trace has no procedure");
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
                "Procedures done to their end, in % of those begun: one that time ended, or that could not be done any more, is not "
                "done.",
            .source = "models.md §1.3, §2.2, §2.4; data.md",
            .measure = measureProcedureCompleted};
}

} // namespace chiron::scoring
