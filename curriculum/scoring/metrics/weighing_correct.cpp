// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/handling_samples.h"

namespace chiron::scoring {

namespace {

constexpr double kWeigh = 1.0; ///< truth "task": simulation::HandlingTask::weigh

Measurement measureWeighingCorrect(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    std::size_t correct = 0;
    for (const PreparedTrial& trial : trials) {
        const auto heaviest = truthOf(trial, "heaviest");
        if (truthOf(trial, "task") != kWeigh || !heaviest)
            return Measurement::undefined(UndefinedReason::noWeighing);
        const auto placed = answerOf(trial);
        if (!placed)
            return Measurement::undefined(UndefinedReason::noObjectsAndTarget);
        correct += trial.trial->completed && placed->taken && placed->number == static_cast<int>(*heaviest) ? 1 : 0;
    }
    return Measurement::of(100.0 * static_cast<double>(correct) / static_cast<double>(trials.size()));
}

} // namespace

MetricDefinition weighingCorrectMetric() {
    return {.id = "weighing_correct",
            .version = 1,
            .unit = "%",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Trials that were finished and in which the object held last, the answer, was the heaviest, in % of all; one that time "
                "ended counts as wrong.",
            .source = "P2, Preliminary Validation (mass: three objects from lightest to heaviest); our definition",
            .measure = measureWeighingCorrect};
}

} // namespace chiron::scoring
