// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/canal_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureLandmarksSeen(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    std::size_t asked = 0;
    std::size_t seen = 0;
    for (const PreparedTrial& trial : trials)
        for (const double seen_s : trial.trial->insertion->landmarkSeen_s) {
            ++asked;
            seen += std::isnan(seen_s) ? 0 : 1;
        }
    return asked == 0 ? Measurement::undefined(UndefinedReason::noLandmarks)
                      : Measurement::of(100.0 * static_cast<double>(seen) / static_cast<double>(asked));
}

} // namespace

MetricDefinition landmarksSeenMetric() {
    return {.id = "landmarks_seen",
            .version = 1,
            .unit = "%",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Landmarks of the bladder that were inspected, in % of those that the level asks for.",
            .source = "models.md §1.3, §6",
            .measure = measureLandmarksSeen};
}

} // namespace chiron::scoring
