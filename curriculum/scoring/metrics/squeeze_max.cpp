// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/handling_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureSqueezeMax(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double largest_N = 0.0;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* squeeze = quantityOf(trial, "squeeze_N");
        if (squeeze == nullptr)
            return Measurement::undefined(UndefinedReason::noSqueeze);
        for (std::size_t i = 0; i < squeeze->values.size(); ++i)
            if (trial.tool->paused[i] == 0)
                largest_N = std::max(largest_N, squeeze->values[i]);
    }
    return Measurement::of(largest_N);
}

} // namespace

MetricDefinition squeezeMaxMetric() {
    return {.id = "squeeze_max",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Largest grip force of each jaw on what it held; 0 where nothing was held.",
            .source = "models.md §2.2; P2, Object Orientated Modeling",
            .measure = measureSqueezeMax};
}

} // namespace chiron::scoring
