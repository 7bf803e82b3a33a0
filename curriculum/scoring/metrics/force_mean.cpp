// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureForceMean(std::span<const PreparedTrial> trials) {
    double sum_N = 0.0;
    std::size_t samples = 0;
    forEachForce(trials, [&](double f_N, double) {
        if (f_N > kContactForce_N) {
            sum_N += f_N;
            ++samples;
        }
    });
    return samples == 0 ? Measurement::undefined(UndefinedReason::noContact)
                        : Measurement::of(sum_N / static_cast<double>(samples));
}

Measurement measureForceMean2(std::span<const PreparedTrial> trials) {
    double impulse_Ns = 0.0, time_s = 0.0;
    forEachLoad(trials, [&](double load_N, double held_s, bool touched) {
        impulse_Ns += touched ? load_N * held_s : 0.0;
        time_s += touched ? held_s : 0.0;
    });
    return time_s > 0.0 ? Measurement::of(impulse_Ns / time_s) : Measurement::undefined(UndefinedReason::noContact);
}

} // namespace

MetricDefinition forceMeanMetric() {
    return {.id = "force_mean",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition = "Mean of |f| over the samples above 0.02 N.",
            .source = "models.md §6",
            .measure = measureForceMean};
}

MetricDefinition forceMeanMetric2() {
    MetricDefinition metric = forceMeanMetric();
    metric.version = 2;
    metric.tools = MetricTools::all;
    metric.definition = "Mean over time of the load |f| of every tool while it touches (over 0.02 N); broken tissue counts with the force that broke it.";
    metric.source = "models.md §6; data.md, Range of a law";
    metric.measure = measureForceMean2;
    return metric;
}

} // namespace chiron::scoring
