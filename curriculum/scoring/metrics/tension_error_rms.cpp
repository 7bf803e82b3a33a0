// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/tube_samples.h"

#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureTensionErrorRms(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "tension_N", "target_N"))
        return *why;
    double squares = 0.0;
    std::size_t samples = 0;
    forEachTensionError(trials, [&](double error_N) {
        squares += error_N * error_N;
        ++samples;
    });
    return samples == 0 ? neverHeld() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
}

} // namespace

MetricDefinition tensionErrorRmsMetric() {
    return {.id = "tension_error_rms",
            .version = 1,
            .unit = "N",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .definition = "Root mean square of the tube's tension less its target over the samples of all holds of all trials, broken ones "
                          "too: each from when the tension first was in the band to the hold's end, in the band or not. A trial that "
                          "held nothing has none.",
            .source = "models.md §6, tube",
            .measure = measureTensionErrorRms};
}

} // namespace chiron::scoring
