// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationFalseAlarms(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    int alarms = 0;
    for (const PalpationAnswer& answer : answers)
        alarms += answer.falseAlarms();
    return Measurement::of(alarms);
}

} // namespace

MetricDefinition palpationFalseAlarmsMetric() {
    return {.id = "palpation_false_alarms",
            .version = 1,
            .unit = "count",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Findings, of those not taken back, that found no lump; a second one of the same lump is one.",
            .source = "models.md §6; our matching",
            .measure = measurePalpationFalseAlarms};
}

} // namespace chiron::scoring
