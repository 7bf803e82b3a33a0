// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/tube_samples.h"

#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureTensionErrorSd(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "tension_N", "target_N"))
        return *why;
    double squares = 0.0;
    std::size_t samples = 0;
    for (const PreparedTrial& trial : trials) { // about each trial's own mean: its bias is in the RMS
        const std::span<const PreparedTrial> one(&trial, 1);
        double sum = 0.0;
        std::size_t count = 0;
        forEachTensionError(one, [&](double error_N) {
            sum += error_N;
            ++count;
        });
        if (count == 0)
            continue;
        const double mean = sum / static_cast<double>(count);
        forEachTensionError(one, [&](double error_N) { squares += (error_N - mean) * (error_N - mean); });
        samples += count;
    }
    return samples == 0 ? neverHeld() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
}

} // namespace

MetricDefinition tensionErrorSdMetric() {
    return {.id = "tension_error_sd",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "Standard deviation of the tube's tension in all holds of a trial, broken ones too, about the trial's own mean, "
                          "pooled over the trials: how unsteady, whatever the target. A trial that held nothing has none.",
            .source = "models.md §6, tube",
            .measure = measureTensionErrorSd};
}

} // namespace chiron::scoring
