// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/roc_curve.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationRocArea(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    RatingCounts ratings;
    bool rated = false;
    for (const PalpationAnswer& answer : answers) {
        ratings.add(answer.regions);
        for (const DetectionRegion& region : answer.regions)
            rated = rated || region.confidence > 0;
    }
    if (!core::isUsable(ratings.counts()))
        return tooFewRegions(ratings.counts());
    if (!rated)
        return Measurement::undefined("nobody said how sure a finding is");
    return Measurement::of(rocOf(ratings)->area);
}

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
                          "1, unrated and not reported; 0.5 says nothing, 1 is perfect; absent below 20 regions of either kind.",
            .source = "Macmillan & Creelman 2005, ch. 3",
            .measure = measurePalpationRocArea};
}

} // namespace chiron::scoring
