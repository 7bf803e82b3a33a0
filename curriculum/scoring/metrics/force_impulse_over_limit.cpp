// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureForceImpulseOverLimit(std::span<const PreparedTrial> trials) {
    double impulse_Ns = 0.0;
    bool any = false;
    const double limit_N = trials.empty() ? 0.0 : trials.front().forceLimit_N;
    forEachForce(trials, [&](double f_N, double held_s) {
        any = true;
        impulse_Ns += f_N > limit_N ? f_N * held_s : 0.0;
    });
    return any ? Measurement::of(impulse_Ns) : noSamples();
}

Measurement measureForceImpulseOverLimit2(std::span<const PreparedTrial> trials) {
    double impulse_Ns = 0.0;
    bool any = false;
    const double limit_N = trials.empty() ? 0.0 : trials.front().forceLimit_N;
    forEachLoad(trials, [&](double load_N, double held_s, bool) {
        any = true;
        impulse_Ns += load_N > limit_N ? load_N * held_s : 0.0;
    });
    return any ? Measurement::of(impulse_Ns) : noSamples();
}

} // namespace

MetricDefinition forceImpulseOverLimitMetric() {
    return {.id = "force_impulse_over_limit",
            .version = 1,
            .unit = "N·s",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::sum,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition =
                "Integral of |f| dt while |f| is over the level's force limit, each sample held until the "
                "next.",
            .source = "models.md §6",
            .measure = measureForceImpulseOverLimit};
}

MetricDefinition forceImpulseOverLimitMetric2() {
    MetricDefinition metric = forceImpulseOverLimitMetric();
    metric.version = 2;
    metric.tools = MetricTools::all;
    metric.definition = "Integral of the load |f| dt of a tool while it is over the level's force limit, all tools added; broken tissue counts with the force that broke it.";
    metric.source = "models.md §6; data.md, Range of a law";
    metric.measure = measureForceImpulseOverLimit2;
    return metric;
}

} // namespace chiron::scoring
