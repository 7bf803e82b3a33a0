// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

#include <algorithm>
#include <vector>

namespace chiron::scoring {

namespace {

Measurement measureForceP95(std::span<const PreparedTrial> trials) {
    std::vector<double> forces_N;
    forEachForce(trials, [&](double f_N, double) { forces_N.push_back(f_N); });
    if (forces_N.empty())
        return noSamples();
    std::sort(forces_N.begin(), forces_N.end());
    const double place = 0.95 * static_cast<double>(forces_N.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, forces_N.size() - 1);
    return Measurement::of(forces_N[below] +
                           (place - static_cast<double>(below)) * (forces_N[above] - forces_N[below]));
}

} // namespace

MetricDefinition forceP95Metric() {
    return {.id = "force_p95",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .needsForces = true,
            .definition = "95th percentile of |f| over all samples, linear between order statistics.",
            .source = "models.md §6; Hyndman & Fan 1996, definition 7",
            .measure = measureForceP95};
}

} // namespace chiron::scoring
