// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/tube_samples.h"

namespace chiron::scoring {

namespace {

using Step = core::LaparoscopyStep;

bool isHeldStep(double step) {
    return isTubeStep(step, Step::stretch) || isTubeStep(step, Step::hold) || isTubeStep(step, Step::handOver) ||
           isTubeStep(step, Step::carry);
}

Measurement measureDrops(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "grip_1"))
        return *why;
    std::size_t count = 0;
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& step = *tubeQuantity(trial, "step");
        bool held = false;
        for (std::size_t i = 0; i < step.size(); ++i) {
            const bool counts = trial.tool->paused[i] == 0;
            if (counts && held && (isTubeStep(step[i], Step::grasp) || isTubeStep(step[i], Step::retract)))
                ++count;
            held = counts && isHeldStep(step[i]);
        }
    }
    return Measurement::of(static_cast<double>(count));
}

} // namespace

MetricDefinition dropsMetric() {
    return {.id = "drops",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "How often the tube, once held as the task needs it, was let go of before the task was done, so that it had to "
                          "be grasped again. What is let go in a pause does not count.",
            .source = "models.md §2.4, §6",
            .measure = measureDrops};
}

} // namespace chiron::scoring
