// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/finding_errors.h"
#include "scoring/median.h"

#include <cmath>

namespace chiron::scoring {

namespace {

/// The median of the true radii is the answer that is best if it is always the same.
Measurement measureSizeErrorByChance(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    std::vector<double> radii_m;
    for (const PalpationAnswer& answer : answers)
        for (const double radius_m : saidSizes(answer.truth, answer.findings, answer.matches))
            radii_m.push_back(radius_m);
    if (radii_m.empty())
        return Measurement::undefined(UndefinedReason::noSizeSaid);
    const double best_m = median(radii_m);
    double sum_m = 0.0;
    for (const double radius_m : radii_m)
        sum_m += std::abs(radius_m - best_m);
    return Measurement::of(1e3 * sum_m / static_cast<double>(radii_m.size()));
}

/// Of all lumps that were there: of a few that were found, the best answer in hindsight errs by nothing and says nothing.
Measurement measureSizeErrorByChance2(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    std::vector<double> radii_m;
    bool asked = false;
    for (const PalpationAnswer& answer : answers) {
        asked = asked || answer.truth.asksSize;
        for (const LumpTruth& lump : answer.truth.lumps)
            radii_m.push_back(lump.radius_m);
    }
    if (!asked)
        return Measurement::undefined(UndefinedReason::noSizeAsked);
    if (radii_m.size() < 2)
        return Measurement::undefined(UndefinedReason::tooFewLumps);
    const double best_m = median(radii_m);
    double sum_m = 0.0;
    for (const double radius_m : radii_m)
        sum_m += std::abs(radius_m - best_m);
    return Measurement::of(1e3 * sum_m / static_cast<double>(radii_m.size()));
}

} // namespace

MetricDefinition sizeErrorByChanceMetric() {
    return {.id = "size_error_by_chance",
            .version = 1,
            .unit = "mm",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "size_error of one who says the median of the true radii of every lump whose size was said: what feeling nothing gives.",
            .source = "our definition",
            .measure = measureSizeErrorByChance};
}

MetricDefinition sizeErrorByChanceMetric2() {
    MetricDefinition metric = sizeErrorByChanceMetric();
    metric.version = 2;
    metric.definition = "size_error of one who says the median of the true radii of all lumps that were there: what feeling nothing gives.";
    metric.measure = measureSizeErrorByChance2;
    return metric;
}

} // namespace chiron::scoring
