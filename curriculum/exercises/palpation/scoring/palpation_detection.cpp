// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/palpation_metrics.h"

#include "curriculum/exercises/palpation/scoring/palpation_reasons.h"
#include "curriculum/exercises/palpation/scoring/palpation_samples.h"
#include "curriculum/exercises/palpation/scoring/roc_curve.h"
#include "scoring/metrics/metric_rows.h"

namespace chiron::scoring {

namespace {

Measurement measurePalpationHitsOf(const JudgedTrials& judgedTrials) {
    const auto& [answers, undefined] = judgedTrials;
    if (undefined)
        return *undefined;
    if (lumpsOf(answers) == 0)
        return Measurement::undefined(reasons::kNoLumpThere);
    int hits = 0;
    for (const PalpationAnswer& answer : answers)
        hits += answer.hits();
    return Measurement::of(hits);
}

Measurement measurePalpationHits(std::span<const PreparedTrial> trials) {
    return measurePalpationHitsOf(judged(trials));
}
Measurement measurePalpationHits2(std::span<const PreparedTrial> trials) {
    return measurePalpationHitsOf(judgedSafely(trials));
}

Measurement measurePalpationMissesOf(const JudgedTrials& judgedTrials) {
    const auto& [answers, undefined] = judgedTrials;
    if (undefined)
        return *undefined;
    if (lumpsOf(answers) == 0)
        return Measurement::undefined(reasons::kNoLumpThere);
    int misses = 0;
    for (const PalpationAnswer& answer : answers)
        misses += answer.misses();
    return Measurement::of(misses);
}

Measurement measurePalpationMisses(std::span<const PreparedTrial> trials) {
    return measurePalpationMissesOf(judged(trials));
}
Measurement measurePalpationMisses2(std::span<const PreparedTrial> trials) {
    return measurePalpationMissesOf(judgedSafely(trials));
}

Measurement measurePalpationFalseAlarms(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    int alarms = 0;
    for (const PalpationAnswer& answer : answers)
        alarms += answer.falseAlarms();
    return Measurement::of(alarms);
}

Measurement measurePalpationDPrime(std::span<const PreparedTrial> trials) {
    return ofRegions(judged(trials),
                     [](const core::DetectionCounts& counts) { return core::dPrime(counts); });
}

Measurement measurePalpationDPrime2(std::span<const PreparedTrial> trials) {
    return ofRegions(judgedSafely(trials),
                     [](const core::DetectionCounts& counts) { return core::weightedDPrime(counts); });
}

Measurement measurePalpationDPrimeLow(std::span<const PreparedTrial> trials) {
    return ofRegions(judgedSafely(trials), [](const core::DetectionCounts& counts) {
        return core::weightedDPrimeInterval(counts).low;
    });
}

Measurement measurePalpationDPrimeHigh(std::span<const PreparedTrial> trials) {
    return ofRegions(judgedSafely(trials), [](const core::DetectionCounts& counts) {
        return core::weightedDPrimeInterval(counts).high;
    });
}

Measurement measurePalpationCriterion(std::span<const PreparedTrial> trials) {
    return ofRegions(judged(trials),
                     [](const core::DetectionCounts& counts) { return core::criterion(counts); });
}

Measurement measurePalpationCriterion2(std::span<const PreparedTrial> trials) {
    return ofRegions(judgedSafely(trials),
                     [](const core::DetectionCounts& counts) { return core::weightedCriterion(counts); });
}

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
        return Measurement::undefined(reasons::kNoConfidence);
    return Measurement::of(rocOf(ratings)->area);
}

Measurement measurePalpationRocArea(std::span<const PreparedTrial> trials) {
    return measurePalpationRocAreaOf(judged(trials));
}
Measurement measurePalpationRocArea2(std::span<const PreparedTrial> trials) {
    return measurePalpationRocAreaOf(judgedSafely(trials));
}

} // namespace

std::vector<MetricDefinition> palpationDetectionMetrics() {
    MetricRows rows;
    rows.add({.id = "palpation_hits",
              .unit = "count",
              .direction = Direction::higherIsBetter,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Lumps found"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "Lumps with a finding close enough to count. A lump that was pressed harder "
                             "than the limit does not count."),
              .definition = "Lumps that were found: a finding lies within the hit radius of the lump's "
                            "place, or within the lump's radius where "
                            "that is larger; the nearest pair first, each finding and lump once.",
              .source = "models.md §6; our matching",
              .measure = measurePalpationHits});
    rows.next({.wrench = MetricWrench::tissue,
               .tools = MetricTools::all,
               .needsForces = true,
               .definition = "Lumps that were found, as in version 1, and at no time of the trial pressed "
                             "harder than the level's limit within the "
                             "same reach of their place.",
               .measure = measurePalpationHits2});
    rows.add({.id = "palpation_misses",
              .unit = "count",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Lumps missed"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "Lumps with no finding close enough to count."),
              .definition = "Lumps that no finding found (palpation_hits) by the trial's end.",
              .source = "models.md §6; our matching",
              .measure = measurePalpationMisses});
    rows.next({.wrench = MetricWrench::tissue,
               .tools = MetricTools::all,
               .needsForces = true,
               .definition = "Lumps that were not found (palpation_hits 2) by the trial's end.",
               .measure = measurePalpationMisses2});
    rows.add(
        {.id = "palpation_false_alarms",
         .unit = "count",
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "False alarms"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics", "Findings where there was no lump; a second finding of the same lump counts too."),
         .definition =
             "Findings, of those not taken back, that found no lump; a second one of the same lump is one.",
         .source = "models.md §6; our matching",
         .measure = measurePalpationFalseAlarms});
    rows.add({.id = "palpation_d_prime",
              .unit = "",
              .direction = Direction::higherIsBetter,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Sensitivity (d′)"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "How well places with a lump were told apart from places without, "
                                           "whatever the tendency to say yes or no. 0 is chance."),
              .definition = "d' = z(H) - z(F) over the regions of all trials, H = (hits + 1/2)/(regions with "
                            "a lump + 1), F = (false alarms + "
                            "1/2)/(regions without + 1); absent below 20 of either kind.",
              .source = "models.md §6; Hautus 1995; Macmillan & Creelman 2005, eq. 1.5",
              .chance = {.value = 0.0},
              .measure = measurePalpationDPrime});
    rows.next({.definition = "d' = z(H) - z(F) over the regions of all trials; with p the share of regions "
                             "with a lump, H = (hits + p)/(regions "
                             "with a lump + 2p), F = (false alarms + 1 - p)/(regions without + 2(1 - p)): 0 "
                             "for who says nothing; a trial that has "
                             "a lump because the level introduces itself with one is left out; a lump "
                             "pressed harder than the limit is not found; "
                             "absent below 20 of either kind.",
               .measure = measurePalpationDPrime2});
    rows.add({.id = "palpation_d_prime_low",
              .unit = "",
              .direction = Direction::neutral,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Sensitivity, lower bound"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "The lower end of the 95 % interval of the sensitivity. "
                                           "Below 0 the session does not show that any lump was perceived."),
              .definition = "The lower end of the 95 % interval of palpation_d_prime 2, by the delta method.",
              .source = "Gourevitch & Galanter 1967; Macmillan & Creelman 2005, eq. 13.4",
              .measure = measurePalpationDPrimeLow});
    rows.add(
        {.id = "palpation_d_prime_high",
         .unit = "",
         .direction = Direction::neutral,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Sensitivity, upper bound"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "The upper end of the 95 % interval of the sensitivity."),
         .definition = "The upper end of the 95 % interval of palpation_d_prime 2, by the delta method.",
         .source = "Gourevitch & Galanter 1967; Macmillan & Creelman 2005, eq. 13.4",
         .measure = measurePalpationDPrimeHigh});
    rows.add({.id = "palpation_criterion",
              .unit = "",
              .direction = Direction::neutral,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Criterion (c)"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics",
                  "The tendency when in doubt: to report a lump (negative) or not to report one (positive)."),
              .definition = "c = -1/2 (z(H) + z(F)) with the rates of palpation_d_prime; above 0: rather no; "
                            "absent below 20 regions of either "
                            "kind.",
              .source = "models.md §6; Hautus 1995; Macmillan & Creelman 2005, eq. 2.1",
              .measure = measurePalpationCriterion});
    rows.next({.definition = "c = -1/2 (z(H) + z(F)) with the rates of palpation_d_prime 2; above 0: rather "
                             "no; absent below 20 regions of either "
                             "kind.",
               .measure = measurePalpationCriterion2});
    rows.add({.id = "palpation_roc_area",
              .unit = "",
              .direction = Direction::higherIsBetter,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Area under the ROC curve"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How well confidence tells places with a lump from "
                                                      "places without: 0.5 is chance, 1 is perfect."),
              .definition = "Area under the ROC of the regions of all trials, straight lines between the "
                            "confidence ratings 5 to 1, unrated and "
                            "not reported; a trial that has a lump because the level introduces itself with "
                            "one is left out; 0.5 says nothing, 1 "
                            "is perfect; absent below 20 regions of either kind.",
              .source = "Macmillan & Creelman 2005, ch. 3",
              .chance = {.value = 0.5},
              .measure = measurePalpationRocArea});
    rows.next({.wrench = MetricWrench::tissue,
               .tools = MetricTools::all,
               .needsForces = true,
               .definition = "As version 1, but a lump pressed harder than the level's limit is not found "
                             "(palpation_hits 2).",
               .measure = measurePalpationRocArea2});
    return rows.take();
}

} // namespace chiron::scoring
