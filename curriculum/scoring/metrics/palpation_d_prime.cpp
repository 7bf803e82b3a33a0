// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationDPrime(std::span<const PreparedTrial> trials) {
    return ofRegions(judged(trials), [](const core::DetectionCounts& counts) { return core::dPrime(counts); });
}

Measurement measurePalpationDPrime2(std::span<const PreparedTrial> trials) {
    return ofRegions(judgedSafely(trials), [](const core::DetectionCounts& counts) { return core::weightedDPrime(counts); });
}

} // namespace

MetricDefinition palpationDPrimeMetric() {
    return {.id = "palpation_d_prime",
            .version = 1,
            .unit = "",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "d' = z(H) - z(F) over the regions of all trials, H = (hits + 1/2)/(regions with a lump + 1), F = "
                          "(false alarms + 1/2)/(regions without + 1); absent below 20 of either kind.",
            .source = "models.md §6; Hautus 1995; Macmillan & Creelman 2005, eq. 1.5",
            .measure = measurePalpationDPrime};
}

MetricDefinition palpationDPrimeMetric2() {
    MetricDefinition metric = palpationDPrimeMetric();
    metric.version = 2;
    metric.definition = "d' = z(H) - z(F) over the regions of all trials; with p the share of regions with a lump, H = (hits + p)/(regions with a lump + 2p), F = "
                        "(false alarms + 1 - p)/(regions without + 2(1 - p)): 0 for who says nothing; a trial that has a lump because the level introduces itself with one is left out; a lump pressed harder than the limit is not found; absent below 20 of either kind.";
    metric.measure = measurePalpationDPrime2;
    return metric;
}

} // namespace chiron::scoring
