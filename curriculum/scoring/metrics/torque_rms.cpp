// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/torque_samples.h"

#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureTorqueRms(std::span<const PreparedTrial> trials) {
    double squares = 0.0;
    std::size_t samples = 0;
    const auto why = forEachTorque(trials, [&](double torque_Nm) {
        squares += torque_Nm * torque_Nm;
        ++samples;
    });
    if (why)
        return *why;
    return samples == 0 ? Measurement::undefined(UndefinedReason::noSamples)
                        : Measurement::of(1e3 * std::sqrt(squares / static_cast<double>(samples)));
}

} // namespace

MetricDefinition torqueRmsMetric() {
    return {.id = "torque_rms",
            .version = 1,
            .unit = "mN·m",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Square root of the mean of |torque|^2 of the tissue about the tip over all samples.",
            .source = "models.md §1.2, §6; P1 eq. 4–6",
            .measure = measureTorqueRms};
}

} // namespace chiron::scoring
