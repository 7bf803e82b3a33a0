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

} // namespace chiron::scoring
