// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include <algorithm>
#include <limits>

namespace chiron::scoring {

namespace {

double doneAt_s(const std::vector<TimedReport>& reports) {
    for (const TimedReport& report : reports)
        if (report.field == core::ReportField::done)
            return report.t_s;
    return std::numeric_limits<double>::infinity();
}

double searched_s(const ToolTrace& tool, double until_s) {
    double sum_s = 0.0;
    for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
        if (tool.paused[i] == 0)
            sum_s += std::max(0.0, std::min(tool.t_s[i + 1], until_s) - tool.t_s[i]);
    return sum_s;
}

Measurement measureSearchingTime(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        const auto told = reportsOf(*trial.trial);
        if (!told || trial.tool == nullptr)
            return Measurement::undefined(UndefinedReason::noReports);
        time_s += searched_s(*trial.tool, doneAt_s(told->reports));
    }
    return Measurement::of(time_s);
}

} // namespace

MetricDefinition searchingTimeMetric() {
    return {.id = "searching_time",
            .version = 1,
            .unit = "s",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Time of the trials from their start until done was reported, or until they ended, without pauses.",
            .source = "models.md §6; our definition",
            .measure = measureSearchingTime};
}

} // namespace chiron::scoring
