// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/handling_samples.h"

namespace chiron::scoring {

namespace {

/// Who chooses one of n objects without lifting any is right once in n times.
Measurement measureWeighingCorrectByChance(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const auto objects = truthOf(trial, "objects");
        if (!truthOf(trial, "heaviest") || !objects || !(*objects >= 1.0))
            return Measurement::undefined(UndefinedReason::noWeighing);
        sum += 1.0 / *objects;
    }
    return Measurement::of(100.0 * sum / static_cast<double>(trials.size()));
}

} // namespace

MetricDefinition weighingCorrectByChanceMetric() {
    return {.id = "weighing_correct_by_chance",
            .version = 1,
            .unit = "%",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "weighing_correct of one who chooses without feeling: 100/n of n objects, the mean over the trials.",
            .source = "our definition",
            .measure = measureWeighingCorrectByChance};
}

} // namespace chiron::scoring
