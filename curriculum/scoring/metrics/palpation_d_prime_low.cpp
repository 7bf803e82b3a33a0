// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationDPrimeLow(std::span<const PreparedTrial> trials) {
    return ofRegions(judgedSafely(trials), [](const core::DetectionCounts& counts) { return core::weightedDPrimeInterval(counts).low; });
}

} // namespace

MetricDefinition palpationDPrimeLowMetric() {
    return {.id = "palpation_d_prime_low",
            .version = 1,
            .unit = "",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "The lower end of the 95 % interval of palpation_d_prime 2, by the delta method.",
            .source = "Gourevitch & Galanter 1967; Macmillan & Creelman 2005, eq. 13.4",
            .measure = measurePalpationDPrimeLow};
}

} // namespace chiron::scoring
