// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureForceRms(std::span<const PreparedTrial> trials) {
    double squares = 0.0;
    std::size_t samples = 0;
    forEachForce(trials, [&](double f_N, double) {
        squares += f_N * f_N;
        ++samples;
    });
    return samples == 0 ? noSamples() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
}

Measurement measureForceRms2(std::span<const PreparedTrial> trials) {
    double squares_N2s = 0.0, time_s = 0.0;
    forEachLoad(trials, [&](double load_N, double held_s, bool touched) {
        squares_N2s += touched ? load_N * load_N * held_s : 0.0;
        time_s += touched ? held_s : 0.0;
    });
    return time_s > 0.0 ? Measurement::of(std::sqrt(squares_N2s / time_s)) : Measurement::undefined(UndefinedReason::noContact);
}

} // namespace

MetricDefinition forceRmsMetric() {
    return {.id = "force_rms",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition = "Square root of the mean of |f|^2 over all samples.",
            .source = "models.md §6",
            .measure = measureForceRms};
}

MetricDefinition forceRmsMetric2() {
    MetricDefinition metric = forceRmsMetric();
    metric.version = 2;
    metric.tools = MetricTools::all;
    metric.definition = "Square root of the mean over time of the squared load |f|^2 of every tool while it touches (over 0.02 N); broken tissue counts with the force that broke it.";
    metric.source = "models.md §6; data.md, Range of a law";
    metric.measure = measureForceRms2;
    return metric;
}

} // namespace chiron::scoring
