// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/tube_samples.h"

namespace chiron::scoring {

namespace {

constexpr double kRearmShare = 0.8; // models.md §6

std::size_t overStretches(const PreparedTrial& trial) {
    const std::vector<double>& stretch = *tubeQuantity(trial, "stretch_m");
    const double limit_m = *tubeTruth(trial, "over_stretch_m");
    std::size_t count = 0;
    bool armed = true;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
        if (trial.tool->paused[i] != 0)
            continue;
        if (stretch[i] < kRearmShare * limit_m)
            armed = true;
        if (armed && stretch[i] > limit_m) {
            armed = false;
            ++count;
        }
    }
    return count;
}

Measurement measureOverStretches(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "stretch_m", "over_stretch_m"))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials)
        count += overStretches(trial);
    return Measurement::of(static_cast<double>(count));
}

} // namespace

MetricDefinition overStretchesMetric() {
    return {.id = "over_stretches",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "How often the tube was stretched beyond the level's limit, to be counted again only from below 80 % of it. A "
                          "tear is one too.",
            .source = "models.md §6, tube",
            .measure = measureOverStretches};
}

} // namespace chiron::scoring
