// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureForceMax(std::span<const PreparedTrial> trials) {
    double largest_N = -1.0;
    forEachForce(trials, [&](double f_N, double) { largest_N = std::max(largest_N, f_N); });
    return largest_N < 0.0 ? noSamples() : Measurement::of(largest_N);
}

Measurement measureForceMax2(std::span<const PreparedTrial> trials) {
    double largest_N = -1.0;
    forEachLoad(trials, [&](double load_N, double, bool) { largest_N = std::max(largest_N, load_N); });
    return largest_N < 0.0 ? noSamples() : Measurement::of(largest_N);
}

} // namespace

MetricDefinition forceMaxMetric() {
    return {.id = "force_max",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::maximum,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition = "Largest |f|.",
            .source = "models.md §6",
            .measure = measureForceMax};
}

MetricDefinition forceMaxMetric2() {
    MetricDefinition metric = forceMaxMetric();
    metric.version = 2;
    metric.tools = MetricTools::all;
    metric.definition = "Largest |f| of any tool.";
    metric.measure = measureForceMax2;
    return metric;
}

} // namespace chiron::scoring
