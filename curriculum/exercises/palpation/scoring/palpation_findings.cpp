// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/palpation_metrics.h"

#include "curriculum/exercises/palpation/scoring/finding_errors.h"
#include "curriculum/exercises/palpation/scoring/palpation_reasons.h"
#include "curriculum/exercises/palpation/scoring/palpation_samples.h"
#include "scoring/median.h"
#include "scoring/metrics/metric_rows.h"

#include <algorithm>
#include <cmath>

namespace chiron::scoring {

namespace {

Measurement measureLocalisationError(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    ErrorSum all;
    for (const PalpationAnswer& answer : answers) {
        const ErrorSum errors = localisationErrors(answer.matches);
        all.sum += errors.sum;
        all.count += errors.count;
    }
    return all.count > 0 ? Measurement::of(1e3 * all.sum / all.count)
                         : Measurement::undefined(reasons::kNoLumpFound);
}

/// A position drawn at random from a disc of radius r is on average 2r/3 from its centre, and a finding
/// farther away than r is not a hit.
Measurement measureLocalisationErrorByChance(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    double sum_m = 0.0;
    int hits = 0;
    for (const PalpationAnswer& answer : answers)
        for (const FindingMatch& match : answer.matches)
            if (match.hit()) {
                sum_m += 2.0 / 3.0 *
                         std::max(answer.truth.hitRadius_m,
                                  answer.truth.lumps[static_cast<std::size_t>(match.lump)].radius_m);
                ++hits;
            }
    return hits > 0 ? Measurement::of(1e3 * sum_m / hits) : Measurement::undefined(reasons::kNoLumpFound);
}

Measurement measureSizeError(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    ErrorSum all;
    bool asked = false;
    for (const PalpationAnswer& answer : answers) {
        const ErrorSum errors = sizeErrors(answer.truth, answer.findings, answer.matches);
        all.sum += errors.sum;
        all.count += errors.count;
        asked = asked || answer.truth.asksSize;
    }
    if (all.count > 0)
        return Measurement::of(1e3 * all.sum / all.count);
    return Measurement::undefined(asked ? reasons::kNoSizeSaid : reasons::kNoSizeAsked);
}

/// The median of the true radii is the best constant answer.
Measurement measureSizeErrorByChance(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    std::vector<double> radii_m;
    for (const PalpationAnswer& answer : answers)
        for (const double radius_m : saidSizes(answer.truth, answer.findings, answer.matches))
            radii_m.push_back(radius_m);
    if (radii_m.empty())
        return Measurement::undefined(reasons::kNoSizeSaid);
    const double best_m = median(radii_m);
    double sum_m = 0.0;
    for (const double radius_m : radii_m)
        sum_m += std::abs(radius_m - best_m);
    return Measurement::of(1e3 * sum_m / static_cast<double>(radii_m.size()));
}

/// Uses all lumps that were present. If only a few were found, the best constant answer in hindsight has
/// almost no error and is no baseline.
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
        return Measurement::undefined(reasons::kNoSizeAsked);
    if (radii_m.size() < 2)
        return Measurement::undefined(reasons::kTooFewLumps);
    const double best_m = median(radii_m);
    double sum_m = 0.0;
    for (const double radius_m : radii_m)
        sum_m += std::abs(radius_m - best_m);
    return Measurement::of(1e3 * sum_m / static_cast<double>(radii_m.size()));
}

Measurement measureHardnessOrder(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    HardnessPairs all;
    bool asked = false;
    for (const PalpationAnswer& answer : answers) {
        const HardnessPairs pairs = hardnessPairs(answer.truth, answer.findings, answer.matches);
        all.right += pairs.right;
        all.pairs += pairs.pairs;
        all.rated = std::max(all.rated, pairs.rated);
        asked = asked || answer.truth.asksHardness;
    }
    if (all.pairs > 0)
        return Measurement::of(100.0 * all.right / all.pairs);
    if (!asked && all.rated == 0)
        return Measurement::undefined(reasons::kNoHardnessAsked);
    return Measurement::undefined(all.rated < 2 ? reasons::kTooFewHardnessOfATrial : reasons::kEquallyHard);
}

/// Pools all rated hits of the session, because they were rated on one scale.
Measurement measureHardnessOrder2(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    std::vector<std::pair<int, int>> rated;
    bool asked = false;
    for (const PalpationAnswer& answer : answers) {
        const auto ofTrial = ratedHits(answer.truth, answer.findings, answer.matches);
        rated.insert(rated.end(), ofTrial.begin(), ofTrial.end());
        asked = asked || answer.truth.asksHardness;
    }
    const HardnessPairs all = hardnessPairs(rated);
    if (all.pairs > 0)
        return Measurement::of(100.0 * all.right / all.pairs);
    if (!asked && all.rated == 0)
        return Measurement::undefined(reasons::kNoHardnessAsked);
    return Measurement::undefined(all.rated < 2 ? reasons::kTooFewHardness : reasons::kEquallyHard);
}

Measurement measureHardnessOrderByChance(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    std::vector<std::pair<int, int>> rated;
    for (const PalpationAnswer& answer : answers) {
        const auto ofTrial = ratedHits(answer.truth, answer.findings, answer.matches);
        rated.insert(rated.end(), ofTrial.begin(), ofTrial.end());
    }
    const HardnessPairs all = hardnessPairs(rated);
    return all.pairs > 0 ? Measurement::of(100.0 * all.rightByChance)
                         : Measurement::undefined(reasons::kNoUnequalPair);
}

} // namespace

std::vector<MetricDefinition> palpationFindingsMetrics() {
    MetricRows rows;
    rows.add({.id = "localisation_error",
              .unit = "mm",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Localisation error"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How far, on the surface, each finding was from the "
                                                      "lump that it found; the mean over all lumps found."),
              .definition = "Distance of a finding from the place on the surface above the lump that it "
                            "found, straight; the mean over all hits.",
              .source = "models.md §6",
              .measure = measureLocalisationError});
    rows.add(
        {.id = "localisation_error_by_chance",
         .unit = "mm",
         .direction = Direction::neutral,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Localisation error by chance"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "How far findings would be from a lump if they hit it at "
                                                 "random. A localisation error that is not smaller shows no "
                                                 "skill."),
         .definition = "localisation_error of findings that hit at random: 2/3 of the radius within which a "
                       "finding is a hit, the mean over "
                       "all hits.",
         .source = "mean distance in a uniform disc; our definition",
         .measure = measureLocalisationErrorByChance});
    rows.add({.id = "size_error",
              .unit = "mm",
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Size error"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "How far the stated radius was from the true one; the "
                                                      "mean over all lumps found with a stated size."),
              .definition = "|reported - true radius|, the mean over all hits whose size was said.",
              .source = "models.md §6; our definition",
              .chance = {.metric = "size_error_by_chance"},
              .measure = measureSizeError});
    rows.add({.id = "size_error_by_chance",
              .unit = "mm",
              .direction = Direction::neutral,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Size error by chance"),
              .meaning =
                  QT_TRANSLATE_NOOP("Metrics", "The size error of somebody who perceives nothing and always "
                                               "states the middle size. A size error that is not smaller "
                                               "shows no skill."),
              .definition =
                  "size_error of one who says the median of the true radii of every lump whose size was "
                  "said: what feeling nothing gives.",
              .source = "our definition",
              .measure = measureSizeErrorByChance});
    rows.next({.definition = "size_error of one who says the median of the true radii of all lumps that were "
                             "there: what feeling nothing gives.",
               .measure = measureSizeErrorByChance2});
    rows.add({.id = "hardness_order",
              .unit = "%",
              .direction = Direction::higherIsBetter,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Hardness order"),
              .meaning = QT_TRANSLATE_NOOP(
                  "Metrics", "How often the harder of two lumps found in a trial was also rated harder, in "
                             "% of all such pairs. Guessing gives 50 % or less."),
              .definition =
                  "Share of the pairs of lumps found in one trial whose harder one was called harder; "
                  "pairs truly alike are left out, "
                  "called alike is not right; all trials pooled.",
              .source = "models.md §6 (hardness-rank correctness); our definition",
              .chance = {.value = 50.0}, // of two lumps, a guess names the harder one half of the time
              .measure = measureHardnessOrder});
    rows.next(
        {.definition = "Share of the pairs of lumps found in the session whose harder one was called harder, "
                       "on one scale from 1 to 5; pairs "
                       "truly alike are left out, called alike is not right.",
         .source = "models.md §6 (hardness-rank correctness); probability of concordance; our definition",
         .measure = measureHardnessOrder2});
    rows.add({.id = "hardness_order_by_chance",
              .unit = "%",
              .direction = Direction::neutral,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Hardness order by chance"),
              .meaning =
                  QT_TRANSLATE_NOOP("Metrics", "The hardness order of somebody who assigns the same hardness "
                                               "ratings to the lumps at random. A share that is not "
                                               "larger shows no skill."),
              .definition = "hardness_order of the same words given to the lumps that were found in random "
                            "order: half of the pairs that were "
                            "called differently, none of those called alike.",
              .source = "expectation over all permutations of the answers; our definition",
              .measure = measureHardnessOrderByChance});
    return rows.take();
}

} // namespace chiron::scoring
