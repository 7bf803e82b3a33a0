// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/roc_curve.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationRocAreaOf(const JudgedTrials& judgedTrials) {
    const auto& [answers, undefined] = judgedTrials;
    if (undefined)
        return *undefined;
    RatingCounts ratings;
    bool rated = false;
    for (const PalpationAnswer& answer : answers) {
        if (answer.truth.introduction)
            continue;
        ratings.add(answer.regions);
        for (const DetectionRegion& region : answer.regions)
            rated = rated || region.confidence > 0;
    }
    if (!core::isUsable(ratings.counts()))
        return tooFewRegions(ratings.counts());
    if (!rated)
        return Measurement::undefined(UndefinedReason::noConfidence);
    return Measurement::of(rocOf(ratings)->area);
}

Measurement measurePalpationRocArea(std::span<const PreparedTrial> trials) { return measurePalpationRocAreaOf(judged(trials)); }
Measurement measurePalpationRocArea2(std::span<const PreparedTrial> trials) { return measurePalpationRocAreaOf(judgedSafely(trials)); }

} // namespace

MetricDefinition palpationRocAreaMetric() {
    return {.id = "palpation_roc_area",
            .version = 1,
            .unit = "",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Area under the ROC of the regions of all trials, straight lines between the confidence ratings 5 to "
                          "1, unrated and not reported; a trial that has a lump because the level introduces itself with one is left out; 0.5 says nothing, 1 is perfect; absent below 20 regions of either kind.",
            .source = "Macmillan & Creelman 2005, ch. 3",
            .measure = measurePalpationRocArea};
}

MetricDefinition palpationRocAreaMetric2() {
    MetricDefinition metric = palpationRocAreaMetric();
    metric.version = 2;
    metric.wrench = MetricWrench::tissue;
    metric.tools = MetricTools::all;
    metric.needsForces = true;
    metric.definition = "As version 1, but a lump pressed harder than the level's limit is not found (palpation_hits 2).";
    metric.measure = measurePalpationRocArea2;
    return metric;
}

} // namespace chiron::scoring
