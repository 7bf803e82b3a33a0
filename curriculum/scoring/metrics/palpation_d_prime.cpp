// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationDPrime(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    const core::DetectionCounts counts = countsOf(answers);
    return core::isUsable(counts) ? Measurement::of(core::dPrime(counts)) : tooFewRegions(counts);
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

} // namespace chiron::scoring
