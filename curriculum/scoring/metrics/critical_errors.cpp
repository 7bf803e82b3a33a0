// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

namespace chiron::scoring {

namespace {

/// How often tissue gave way under one tool. It stays given way for longer than any device's packet takes, so that each time has a
/// sample; one from before the trial is none of its own.
std::size_t yieldsOf(const ToolTrace& tool) {
    std::size_t count = 0;
    bool through = !tool.contact.empty() && (tool.contact.front() & core::contact_bits::kYielded) == 0;
    for (std::size_t i = 0; i < tool.contact.size(); ++i) {
        const bool now = (tool.contact[i] & core::contact_bits::kThrough) != 0;
        if (now && !through)
            ++count;
        through = now;
    }
    return count;
}

Measurement measureCriticalErrors(std::span<const PreparedTrial> trials) {
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        for (const ToolTrace& tool : trial.trial->tools)
            count += yieldsOf(tool);
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
            .definition = "How often tissue gave way under an instrument or finger: the force passed the yield force of the content.",
            .source = "data.md, Range of a law",
            .measure = measureCriticalErrors};
}

} // namespace chiron::scoring
