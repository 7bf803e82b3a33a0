// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "scoring/critical_error_catalogue.h"
#include "scoring/metric.h"
#include "scoring/metrics/metric_rows.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <vector>

namespace chiron::scoring {

namespace {

Measurement shareDone(std::span<const PreparedTrial> trials, std::size_t of) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    // An exercise in which a mark ends the trial has no procedure to complete.
    for (const PreparedTrial& trial : trials)
        if (trial.tool == nullptr || (!trial.trial->own && trial.trial->quantities.empty()))
            return Measurement::undefined(reasons::kNoProcedure);
    std::size_t done = 0;
    for (const PreparedTrial& trial : trials)
        done += trial.trial->completed ? 1 : 0;
    return Measurement::of(100.0 * static_cast<double>(done) / static_cast<double>(of));
}

Measurement measureProcedureCompleted(std::span<const PreparedTrial> trials) {
    return shareDone(trials, trials.size());
}

Measurement measureProcedureCompleted2(std::span<const PreparedTrial> trials) {
    const std::size_t planned = trials.empty() ? 0 : static_cast<std::size_t>(trials.front().plannedTrials);
    return shareDone(trials, std::max(planned, trials.size()));
}

/// Returns when tissue gave way under one tool. The state lasts longer than a packet of any device, so that
/// every such event has a sample. An event from before the trial does not count.
std::vector<double> yieldsOf(const ToolTrace& tool) {
    std::vector<double> times_s;
    bool through = !tool.contact.empty() && (tool.contact.front() & core::contact_bits::kYielded) == 0;
    for (std::size_t i = 0; i < tool.contact.size(); ++i) {
        const bool now = (tool.contact[i] & core::contact_bits::kThrough) != 0;
        if (now && !through)
            times_s.push_back(tool.t_s[i]);
        through = now;
    }
    return times_s;
}

Measurement measureCriticalErrors(std::span<const PreparedTrial> trials) {
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        for (const ToolTrace& tool : trial.trial->tools)
            count += yieldsOf(tool).size();
    return Measurement::of(static_cast<double>(count));
}

/// Returns the number of critical spans plus the number of times that tissue gave way outside of them.
std::size_t errorsOf(const TrialTrace& trial) {
    const std::vector<CriticalSpan> spans = criticalSpans(trial);
    std::size_t count = spans.size();
    for (const ToolTrace& tool : trial.tools)
        for (const double t_s : yieldsOf(tool))
            count += std::none_of(spans.begin(), spans.end(), [&](const CriticalSpan& span) {
                return span.begin_s <= t_s && t_s <= span.end_s;
            });
    return count;
}

Measurement measureCriticalErrors2(std::span<const PreparedTrial> trials) {
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += errorsOf(*trial.trial);
    return Measurement::of(static_cast<double>(count));
}

} // namespace

std::vector<MetricDefinition> outcomeMetrics() {
    MetricRows rows;
    rows.add(
        {.id = "procedure_completed",
         .unit = "%",
         .direction = Direction::higherIsBetter,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Procedure completed"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics",
             "How many of the trials were completed in time, with everything that the level asks for, in %."),
         .wholly = QT_TRANSLATE_NOOP("Metrics", "The procedure is completed"),
         .definition = "Procedures done to their end, in % of those begun: one that time ended, or that "
                       "could not be done any more, is not "
                       "done.",
         .source = "models.md §1.3, §2.2, §2.4; data.md",
         .measure = measureProcedureCompleted});
    rows.next(
        {.definition =
             "Procedures done to their end, in % of those that the level asks for (of those that ended, "
             "where that is not known): "
             "one that time ended, that could not be done any more or that was never begun is not done.",
         .measure = measureProcedureCompleted2});
    rows.add({.id = "critical_errors",
              .unit = "count",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .tools = MetricTools::all,
              .title = QT_TRANSLATE_NOOP("Metrics", "Critical errors"),
              .meaning =
                  QT_TRANSLATE_NOOP("Metrics", "How often the tissue gave way because it was pushed or "
                                               "turned too hard, or was pressed sideways too hard or for too "
                                               "long."),
              .definition = "How often tissue gave way under an instrument or finger: the force passed the "
                            "yield force of the content, or the "
                            "torque its yield torque.",
              .source = "data.md, Range of a law",
              .measure = measureCriticalErrors});
    rows.next({.definition = "How often tissue gave way under an instrument or finger (the force passed the "
                             "yield force of the content, or the "
                             "torque its yield torque), or was pressed aside in a canal, over the lateral "
                             "limit, for more than 1 s or with more "
                             "than 4 N.",
               .measure = measureCriticalErrors2});
    static_assert(kCriticalSpansCountFrom == 2); // the row above: playback marks critical spans from this
                                                 // version on
    return rows.take();
}

} // namespace chiron::scoring
