// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/handling_samples.h"

#include "core/units.h"

namespace chiron::scoring {

namespace {

Measurement measurePlacementError(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double sum_m = 0.0;
    for (const PreparedTrial& trial : trials) {
        const auto placed = answerOf(trial);
        if (!placed)
            return Measurement::undefined(UndefinedReason::noObjectsAndTarget);
        sum_m += placed->fromTarget_m;
    }
    return Measurement::of(core::mmFromM(sum_m / static_cast<double>(trials.size())));
}

} // namespace

MetricDefinition placementErrorMetric() {
    return {.id = "placement_error",
            .version = 1,
            .unit = "mm",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Distance, seen from above, between the target's middle and that of the object held last (of the nearest one where "
                "nothing was held) when the trial ended, whether it was finished or not; the mean over the trials.",
            .source = "models.md §2.2; our definition",
            .measure = measurePlacementError};
}

} // namespace chiron::scoring
