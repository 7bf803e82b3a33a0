// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/object_handling/scoring/handling_metrics.h"

#include "core/units.h"
#include "curriculum/exercises/object_handling/scoring/handling_reasons.h"
#include "curriculum/exercises/object_handling/scoring/handling_samples.h"
#include "scoring/metrics/metric_rows.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureSqueezeMax(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double largest_N = 0.0;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* squeeze = quantityOf(trial, "squeeze_N");
        if (squeeze == nullptr)
            return Measurement::undefined(reasons::kNoSqueeze);
        for (std::size_t i = 0; i < squeeze->values.size(); ++i)
            if (trial.tool->paused[i] == 0)
                largest_N = std::max(largest_N, squeeze->values[i]);
    }
    return Measurement::of(largest_N);
}

Measurement measureSqueezeTimeOverLimit(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* squeeze = quantityOf(trial, "squeeze_N");
        if (squeeze == nullptr)
            return Measurement::undefined(reasons::kNoSqueeze);
        const auto limit_N = handlingTruthIn(*trial.trial).squeezeLimit_N;
        if (!limit_N)
            return Measurement::undefined(reasons::kNoSqueezeLimit);
        const std::vector<double>& t_s = trial.tool->t_s;
        for (std::size_t i = 0; i + 1 < t_s.size(); ++i)
            if (trial.tool->paused[i] == 0 && squeeze->values[i] > *limit_N)
                time_s += t_s[i + 1] - t_s[i];
    }
    return Measurement::of(time_s);
}

Measurement measurePlacementError(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double sum_m = 0.0;
    for (const PreparedTrial& trial : trials) {
        const auto placed = answerOf(trial);
        if (!placed)
            return Measurement::undefined(reasons::kNoObjectsAndTarget);
        sum_m += placed->fromTarget_m;
    }
    return Measurement::of(core::mmFromM(sum_m / static_cast<double>(trials.size())));
}

constexpr int kWeigh = 1; ///< simulation::HandlingTask::weigh, as HandlingTruth::task stores it

Measurement measureWeighingCorrect(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    std::size_t correct = 0;
    for (const PreparedTrial& trial : trials) {
        const HandlingTruth truth = handlingTruthIn(*trial.trial);
        if (truth.task != kWeigh || !truth.heaviest)
            return Measurement::undefined(reasons::kNoWeighing);
        const auto placed = answerOf(trial);
        if (!placed)
            return Measurement::undefined(reasons::kNoObjectsAndTarget);
        correct += trial.trial->completed && placed->taken && placed->number == *truth.heaviest ? 1 : 0;
    }
    return Measurement::of(100.0 * static_cast<double>(correct) / static_cast<double>(trials.size()));
}

/// A person who chooses one of n objects without lifting any is right with a probability of 1/n.
Measurement measureWeighingCorrectByChance(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    double sum = 0.0;
    for (const PreparedTrial& trial : trials) {
        const HandlingTruth truth = handlingTruthIn(*trial.trial);
        if (!truth.heaviest || truth.objects.value_or(0) < 1)
            return Measurement::undefined(reasons::kNoWeighing);
        sum += 1.0 / *truth.objects;
    }
    return Measurement::of(100.0 * sum / static_cast<double>(trials.size()));
}

} // namespace

std::vector<MetricDefinition> handlingMetrics() {
    MetricRows rows;
    rows.add({.id = "squeeze_max",
              .unit = "N",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Largest squeeze"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "The largest force with which the jaws squeezed what they held."),
              .definition = "Largest grip force of each jaw on what it held; 0 where nothing was held.",
              .source = "models.md §2.2; P2, Object Orientated Modeling",
              .measure = measureSqueezeMax});
    rows.add(
        {.id = "squeeze_time_over_limit",
         .unit = "s",
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Time squeezing too hard"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How long the squeeze was over the limit of this level."),
         .definition = "Time for which the grip force of a jaw was over the level's squeeze limit, each "
                       "sample held until the next.",
         .source = "models.md §2.2, §6",
         .measure = measureSqueezeTimeOverLimit});
    rows.add({.id = "placement_error",
              .unit = "mm",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Placement error"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How far from the middle of the target the object lay "
                                                      "at the end of each trial; the mean over the trials."),
              .definition = "Distance, seen from above, between the target's middle and that of the object "
                            "held last (of the nearest one where "
                            "nothing was held) when the trial ended, whether it was finished or not; the "
                            "mean over the trials.",
              .source = "models.md §2.2; our definition",
              .measure = measurePlacementError});
    rows.add(
        {.id = "weighing_correct",
         .unit = "%",
         .direction = Direction::higherIsBetter,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Heaviest found"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics", "How often the heaviest object was put into the target, in % of the trials."),
         .definition = "Trials that were finished and in which the object held last, the answer, was the "
                       "heaviest, in % of all; one that time "
                       "ended counts as wrong.",
         .source =
             "P2, Preliminary Validation (mass: three objects from lightest to heaviest); our definition",
         .chance = {.value = 100.0 / 3.0}, // three objects (P2, Preliminary Validation)
         .measure = measureWeighingCorrect});
    rows.add({.id = "weighing_correct_by_chance",
              .unit = "%",
              .direction = Direction::neutral,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Heaviest found by chance"),
              .meaning =
                  QT_TRANSLATE_NOOP("Metrics", "How often somebody who perceives nothing would choose the "
                                               "heaviest object. A share that is not larger shows no skill."),
              .definition = "weighing_correct of one who chooses without feeling: 100/n of n objects, the "
                            "mean over the trials.",
              .source = "our definition",
              .measure = measureWeighingCorrectByChance});
    return rows.take();
}

} // namespace chiron::scoring
