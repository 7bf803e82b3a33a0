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
    return samples == 0 ? Measurement::undefined("no contact")
                        : Measurement::of(sum_N / static_cast<double>(samples));
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

} // namespace chiron::scoring
