// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/torque_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureTorqueMax(std::span<const PreparedTrial> trials) {
    double largest_Nm = -1.0;
    if (auto why = forEachTorque(trials, [&](double torque_Nm) { largest_Nm = std::max(largest_Nm, torque_Nm); }))
        return *why;
    return largest_Nm < 0.0 ? Measurement::undefined(UndefinedReason::noSamples) : Measurement::of(1e3 * largest_Nm);
}

} // namespace

MetricDefinition torqueMaxMetric() {
    return {.id = "torque_max",
            .version = 1,
            .unit = "mN·m",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Largest |torque| of the tissue about the tip.",
            .source = "models.md §1.2, §6; P1 eq. 4–6",
            .measure = measureTorqueMax};
}

} // namespace chiron::scoring
