// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/metric_rows.h"
#include "scoring/metrics/recorded_values.h"

#include <cmath>

namespace chiron::scoring {

namespace {

/// Returns the root mean square in mm over the samples since an answer to a touch took effect. Each answer is
/// weighted by the number of samples for which it was in effect.
Measurement rootMeanSquare(std::span<const PreparedTrial> trials, std::string_view id) {
    double sum = 0.0;
    std::size_t count = 0;
    bool known = false;
    for (const PreparedTrial& trial : trials) {
        const QuantityTrace* predicted = quantityOf(trial, "prediction_error_m");
        const QuantityTrace* held = quantityOf(trial, "held_error_m");
        if (predicted == nullptr || held == nullptr)
            continue;
        known = true;
        const QuantityTrace& wanted = id == predicted->id ? *predicted : *held;
        for (std::size_t i = 0; i < wanted.values.size(); ++i)
            if (trial.tool->paused[i] == 0 && (predicted->values[i] > 0.0 || held->values[i] > 0.0)) {
                sum += wanted.values[i] * wanted.values[i];
                ++count;
            }
    }
    if (count == 0)
        return Measurement::undefined(known ? reasons::kNothingPredicted : reasons::kNoPrediction);
    return Measurement::of(1e3 * std::sqrt(sum / static_cast<double>(count)));
}

Measurement measurePredictionError(std::span<const PreparedTrial> trials) {
    return rootMeanSquare(trials, "prediction_error_m");
}
Measurement measureHeldError(std::span<const PreparedTrial> trials) {
    return rootMeanSquare(trials, "held_error_m");
}

} // namespace

std::vector<MetricDefinition> predictionMetrics() {
    MetricRows rows;
    rows.add(
        {.id = "prediction_error_rms",
         .unit = "mm",
         .direction = Direction::neutral,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Prediction error at 30 Hz"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How far the predicted soft surface under the tool was from "
                                                 "the result of the slow model; this rates the simulation, "
                                                 "not you."),
         .definition = "How far the soft surface under the tool, as it was shown between two updates of the "
                       "slow model, lay from what the "
                       "slow model then said; RMS over the updates.",
         .source = "P2, Haptic-Visual Graphic Integration; models.md §2.2, two rates",
         .measure = measurePredictionError});
    rows.add(
        {.id = "held_error_rms",
         .unit = "mm",
         .direction = Direction::neutral,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Error without prediction"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "The same error if the last update had been kept instead: "
                                                 "the difference shows what the prediction is worth."),
         .definition = "prediction_error_rms if the last updates had been held, and blended alike, instead "
                       "of predicted.",
         .source = "P2, Haptic-Visual Graphic Integration; models.md §2.2, two rates",
         .measure = measureHeldError});
    return rows.take();
}

} // namespace chiron::scoring
