// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/canal_samples.h"

#include "core/units.h"

namespace chiron::scoring {

namespace {

Measurement measureAlignmentRms(std::span<const PreparedTrial> trials) {
    if (auto why = withoutCanal(trials))
        return *why;
    RootMeanSquare angle_rad;
    forEachCanalSample(trials, [&](const InsertionSeries& series, std::size_t i) {
        if (isInUrethra(series, i))
            angle_rad.add(series.alignment_rad[i]);
    });
    return angle_rad.empty() ? neverInUrethra() : Measurement::of(core::degFromRad(angle_rad.value()));
}

} // namespace

MetricDefinition alignmentRmsMetric() {
    return {.id = "alignment_rms",
            .version = 1,
            .unit = "°",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition =
                "Root mean square of the angle between the instrument's axis and the centre-line's tangent over the "
                "samples in the urethra (0 <= s <= L), on the way in and out.",
            .source = "models.md §6, insertion",
            .measure = measureAlignmentRms};
}

} // namespace chiron::scoring
