// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement shareDone(std::span<const PreparedTrial> trials, std::size_t of) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    for (const PreparedTrial& trial : trials) // where a mark ends a trial there is no procedure to complete
        if (trial.tool == nullptr || (!trial.trial->insertion && trial.trial->quantities.empty()))
            return Measurement::undefined(UndefinedReason::noProcedure);
    std::size_t done = 0;
    for (const PreparedTrial& trial : trials)
        done += trial.trial->completed ? 1 : 0;
    return Measurement::of(100.0 * static_cast<double>(done) / static_cast<double>(of));
}

Measurement measureProcedureCompleted(std::span<const PreparedTrial> trials) { return shareDone(trials, trials.size()); }

Measurement measureProcedureCompleted2(std::span<const PreparedTrial> trials) {
    const std::size_t planned = trials.empty() ? 0 : static_cast<std::size_t>(trials.front().plannedTrials);
    return shareDone(trials, std::max(planned, trials.size()));
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

MetricDefinition procedureCompletedMetric2() {
    MetricDefinition metric = procedureCompletedMetric();
    metric.version = 2;
    metric.definition = "Procedures done to their end, in % of those that the level asks for (of those that ended, where that is not known): one that "
                        "time ended, that could not be done any more or that was never begun is not done.";
    metric.measure = measureProcedureCompleted2;
    return metric;
}

} // namespace chiron::scoring
