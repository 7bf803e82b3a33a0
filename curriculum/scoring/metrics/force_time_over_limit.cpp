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

Measurement measureForceTimeOverLimit2(std::span<const PreparedTrial> trials) {
    double time_s = 0.0;
    bool any = false;
    const double limit_N = trials.empty() ? 0.0 : trials.front().forceLimit_N;
    forEachLoad(trials, [&](double load_N, double held_s, bool) {
        any = true;
        time_s += load_N > limit_N ? held_s : 0.0;
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

MetricDefinition forceTimeOverLimitMetric2() {
    MetricDefinition metric = forceTimeOverLimitMetric();
    metric.version = 2;
    metric.tools = MetricTools::all;
    metric.definition = "Time for which the load |f| of a tool is over the level's force limit, all tools added; broken tissue counts with the force that broke it.";
    metric.source = "models.md §6; data.md, Range of a law";
    metric.measure = measureForceTimeOverLimit2;
    return metric;
}

} // namespace chiron::scoring
