// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/retraction_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureRetractionMax(std::span<const PreparedTrial> trials) {
    if (auto why = withoutFold(trials))
        return *why;
    double most_N = 0.0;
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& pull = *tubeQuantity(trial, "retraction_N");
        for (std::size_t i = 0; i < pull.size(); ++i)
            if (trial.tool->paused[i] == 0)
                most_N = std::max(most_N, pull[i]);
    }
    return Measurement::of(most_N);
}

} // namespace

MetricDefinition retractionMaxMetric() {
    return {.id = "retraction_max",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "The largest pull on the fold that lies over the tube, in all trials.",
            .source = "ours: what is pulled at too hard is bruised or torn",
            .measure = measureRetractionMax};
}

} // namespace chiron::scoring
