// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/sub_movement_median.h"
#include "scoring/smoothness.h"

namespace chiron::scoring {

namespace {

Measurement measureSparc(std::span<const PreparedTrial> trials) {
    return subMovementMedian(trials, &PreparedTrial::motion, spectralArcLength);
}

} // namespace

MetricDefinition sparcMetric() {
    return {.id = "sparc",
            .version = 1,
            .unit = "",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Median over the sub-movements (speed over 5 % of its peak for 100 ms) of their spectral arc "
                "length.",
            .source = "models.md §6; Balasubramanian et al. 2015, J NeuroEng Rehabil 12:112",
            .measure = measureSparc};
}

} // namespace chiron::scoring
