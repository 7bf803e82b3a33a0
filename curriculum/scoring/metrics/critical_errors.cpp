// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "scoring/insertion_events.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <vector>

namespace chiron::scoring {

namespace {

/// When tissue gave way under one tool. It stays given way for longer than any device's packet takes, so that each time has a
/// sample; one from before the trial is none of its own.
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

/// Trauma that is no slip any more, and tissue that gave way outside of such.
std::size_t errorsOf(const TrialTrace& trial) {
    std::vector<InsertionEvent> grave = insertionEvents(trial).trauma;
    std::erase_if(grave, [](const InsertionEvent& e) { return !isCritical(e); });
    std::size_t count = grave.size();
    for (const ToolTrace& tool : trial.tools)
        for (const double t_s : yieldsOf(tool))
            count += std::none_of(grave.begin(), grave.end(), [&](const InsertionEvent& e) { return e.begin_s <= t_s && t_s <= e.end_s; });
    return count;
}

Measurement measureCriticalErrors2(std::span<const PreparedTrial> trials) {
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += errorsOf(*trial.trial);
    return Measurement::of(static_cast<double>(count));
}

} // namespace

MetricDefinition criticalErrorsMetric() {
    return {.id = "critical_errors",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "How often tissue gave way under an instrument or finger: the force passed the yield force of the content, or the torque its yield torque.",
            .source = "data.md, Range of a law",
            .measure = measureCriticalErrors};
}

MetricDefinition criticalErrorsMetric2() {
    MetricDefinition metric = criticalErrorsMetric();
    metric.version = kTraumaIsCriticalFrom;
    metric.definition = "How often tissue gave way under an instrument or finger (the force passed the yield force of the content, or the torque its yield torque), or was pressed "
                        "aside in a canal, over the lateral limit, for more than 1 s or with more than 4 N.";
    metric.measure = measureCriticalErrors2;
    return metric;
}

} // namespace chiron::scoring
