// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

#include <algorithm>
#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureForcePeakRate(std::span<const PreparedTrial> trials) {
    double largest = -1.0;
    for (const PreparedTrial& trial : trials) {
        if (trial.tool == nullptr)
            continue;
        const ToolTrace& tool = *trial.tool;
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (!tool.paused[i] && !tool.paused[i + 1])
                largest = std::max(largest, std::abs(tool.tissue_N[i + 1].norm() - tool.tissue_N[i].norm()) /
                                                (tool.t_s[i + 1] - tool.t_s[i]));
    }
    return largest < 0.0 ? Measurement::undefined(UndefinedReason::tooFewSamples) : Measurement::of(largest);
}

} // namespace

MetricDefinition forcePeakRateMetric() {
    return {.id = "force_peak_rate",
            .version = 1,
            .unit = "N/s",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::maximum,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition = "Largest |d|f|/dt| between neighbouring samples as recorded.",
            .source = "models.md §6",
            .measure = measureForcePeakRate};
}

} // namespace chiron::scoring
