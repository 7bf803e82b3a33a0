// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/force_samples.h"

#include <algorithm>
#include <utility>
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

/// The load below which 95 % of the time of touching lies.
Measurement measureForceP95Of2(std::span<const PreparedTrial> trials) {
    std::vector<std::pair<double, double>> loads; // N, s
    double time_s = 0.0;
    forEachLoad(trials, [&](double load_N, double held_s, bool touched) {
        if (touched && held_s > 0.0) {
            loads.emplace_back(load_N, held_s);
            time_s += held_s;
        }
    });
    if (loads.empty())
        return Measurement::undefined(UndefinedReason::noContact);
    std::sort(loads.begin(), loads.end());
    double below_s = 0.0;
    for (const auto& [load_N, held_s] : loads)
        if ((below_s += held_s) >= 0.95 * time_s)
            return Measurement::of(load_N);
    return Measurement::of(loads.back().first);
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

MetricDefinition forceP95Metric2() {
    MetricDefinition metric = forceP95Metric();
    metric.version = 2;
    metric.tools = MetricTools::all;
    metric.definition = "Load |f| under which 95 % of the time lies for which a tool touches (over 0.02 N); broken tissue counts with the force that broke it.";
    metric.source = "models.md §6; data.md, Range of a law";
    metric.measure = measureForceP95Of2;
    return metric;
}

} // namespace chiron::scoring
