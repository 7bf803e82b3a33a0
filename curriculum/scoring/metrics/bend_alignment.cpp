// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/canal_samples.h"

#include "core/units.h"

namespace chiron::scoring {

namespace {

Measurement measureBendAlignment(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare angle_rad;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isStage(series, i, core::ProcedureStage::insertion) && isAtBend(series, i))
            angle_rad.add(series.alignment_rad[i]);
    });
    return angle_rad.empty() ? Measurement::undefined(UndefinedReason::neverAtBend)
                             : Measurement::of(core::degFromRad(angle_rad.value()));
}

Measurement measureCurveAlignment(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare angle_rad;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isStage(series, i, core::ProcedureStage::insertion) && isInCurve(series, i))
            angle_rad.add(series.alignment_rad[i]);
    });
    return angle_rad.empty() ? Measurement::undefined(UndefinedReason::neverAtBend)
                             : Measurement::of(core::degFromRad(angle_rad.value()));
}

} // namespace

MetricDefinition bendAlignmentMetric() {
    return {.id = "bend_alignment",
            .version = 1,
            .unit = "°",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Root mean square of the angle between the instrument's axis and the centre-line's tangent over the "
                "samples of the insertion within 10 mm of the bend (s_B), where the orientation has to change.",
            .source = "models.md §6, insertion; P1, point B",
            .measure = measureBendAlignment};
}

MetricDefinition curveAlignmentMetric() {
    MetricDefinition metric = bendAlignmentMetric();
    metric.id = "curve_alignment";
    metric.definition = "Root mean square of the angle between the instrument's axis and the centre-line's tangent over the samples of the "
                        "insertion from the bend B to 30 mm past it, where the canal is curved most.";
    metric.source = "models.md §6, insertion, and §8; P1, point B";
    metric.measure = measureCurveAlignment;
    return metric;
}

} // namespace chiron::scoring
