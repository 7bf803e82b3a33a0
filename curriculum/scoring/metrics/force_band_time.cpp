// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/metrics/handling_samples.h"

namespace chiron::scoring {

namespace {

Measurement measureForceBandTime(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    double pressing_s = 0.0;
    double inBand_s = 0.0;
    for (const PreparedTrial& trial : trials) {
        const auto low_N = truthOf(trial, "band_low_N");
        const auto high_N = truthOf(trial, "band_high_N");
        if (!low_N || !high_N)
            return Measurement::undefined(UndefinedReason::noForceBand);
        forEachPress(trial, [&](double force_N, double begin_s, double end_s) {
            pressing_s += end_s - begin_s;
            inBand_s += force_N >= *low_N && force_N <= *high_N ? end_s - begin_s : 0.0;
        });
    }
    return pressing_s > 0.0 ? Measurement::of(100.0 * inBand_s / pressing_s) : Measurement::undefined(UndefinedReason::nothingPressed);
}

} // namespace

MetricDefinition forceBandTimeMetric() {
    return {.id = "force_band_time",
            .version = 1,
            .unit = "%",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::tissue,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::all,
            .needsForces = true,
            .definition = "Share of the pressing time (over 0.02 N, each finger's own, added up) for which |f| of that finger "
                          "was within the level's force band, both ends included, each sample held until the next.",
            .source = "models.md §6; our definition",
            .measure = measureForceBandTime};
}

} // namespace chiron::scoring
