// SPDX-License-Identifier: GPL-3.0-or-later
// How long, how much and how hard the wall of a canal was pressed aside: what a count of events does not say.
#include "scoring/insertion_events.h"
#include "scoring/metrics/canal_samples.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureTraumaTime(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double time_s = 0.0;
    for (const PreparedTrial& trial : trials)
        for (const InsertionEvent& event : insertionEvents(*trial.trial).trauma)
            time_s += event.end_s - event.begin_s;
    return Measurement::of(time_s);
}

Measurement measureTraumaImpulse(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double impulse_Ns = 0.0;
    for (const PreparedTrial& trial : trials) {
        const ToolTrace& tool = *trial.tool;
        const InsertionSeries& series = *trial.trial->insertion;
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (tool.paused[i] == 0 && series.lateral_N[i] > series.lateralLimit_N)
                impulse_Ns += series.lateral_N[i] * (tool.t_s[i + 1] - tool.t_s[i]);
    }
    return Measurement::of(impulse_Ns);
}

Measurement measureLateralMax(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    double most_N = 0.0;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) { most_N = std::max(most_N, series.lateral_N[i]); });
    return Measurement::of(most_N);
}

MetricDefinition ofTheWall(std::string_view id, std::string_view unit, std::string_view definition) {
    return {.id = id,
            .version = 1,
            .unit = unit,
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = definition,
            .source = "models.md §6, insertion"};
}

} // namespace

MetricDefinition traumaTimeMetric() {
    MetricDefinition metric = ofTheWall("trauma_time", "s",
                                        "How long the trauma events lasted in all, each from the first sample over the lateral limit until the "
                                        "force across the canal was below 80 % of it.");
    metric.measure = measureTraumaTime;
    return metric;
}

MetricDefinition traumaImpulseMetric() {
    MetricDefinition metric = ofTheWall("trauma_impulse", "N·s",
                                        "Integral of the force across the canal while it is over the lateral limit, each sample held until the next.");
    metric.measure = measureTraumaImpulse;
    return metric;
}

MetricDefinition lateralMaxMetric() {
    MetricDefinition metric = ofTheWall("lateral_max", "N", "The largest force across the canal of any sample.");
    metric.measure = measureLateralMax;
    return metric;
}

} // namespace chiron::scoring
