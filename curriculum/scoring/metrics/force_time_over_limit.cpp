// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureForceTimeOverLimit(std::span<const PreparedTrial> trials) {
    double time_s = 0.0;
    bool any = false;
    const double limit_N = trials.empty() ? 0.0 : trials.front().forceLimit_N;
    forEachForce(trials, [&](double f_N, double held_s) {
        any = true;
        time_s += f_N > limit_N ? held_s : 0.0;
    });
    return any ? Measurement::of(time_s) : noSamples();
}

} // namespace

MetricDefinition forceTimeOverLimitMetric() {
    return {.id = "force_time_over_limit",
            .version = 1,
            .unit = "s",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::sum,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition =
                "Time for which |f| is over the level's force limit, each sample held until the next.",
            .source = "models.md §6",
            .measure = measureForceTimeOverLimit};
}

} // namespace chiron::scoring
