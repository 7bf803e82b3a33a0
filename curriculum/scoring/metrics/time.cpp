// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <limits>

namespace chiron::scoring {

namespace {

Measurement measureTime(std::span<const PreparedTrial> trials) {
    double total_s = 0.0;
    bool any = false;
    for (const PreparedTrial& trial : trials) {
        if (!trial.movementStart_s && !trial.contactStart_s)
            continue;
        any = true;
        constexpr double kNever = std::numeric_limits<double>::infinity();
        const double start_s =
            std::min(trial.movementStart_s.value_or(kNever), trial.contactStart_s.value_or(kNever));
        const ToolTrace& tool = *trial.tool;
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (!tool.paused[i] && tool.t_s[i + 1] > start_s)
                total_s += tool.t_s[i + 1] - std::max(tool.t_s[i], start_s);
    }
    return any ? Measurement::of(total_s) : Measurement::undefined(UndefinedReason::neitherMovementNorContact);
}

} // namespace

MetricDefinition timeMetric() {
    return {.id = "time",
            .version = 1,
            .unit = "s",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::sum,
            .tools = MetricTools::first,
            .definition =
                "From the first movement (50 ms above 5 mm/s) or contact (0.02 N), whichever is earlier, to "
                "the trial's end, without pauses.",
            .source = "models.md §6",
            .measure = measureTime};
}

} // namespace chiron::scoring
