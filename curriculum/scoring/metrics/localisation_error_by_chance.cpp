// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

namespace chiron::scoring {

namespace {

/// A place drawn at random from a disc of radius r lies 2r/3 from its middle on average, and a finding farther off is no hit.
Measurement measureLocalisationErrorByChance(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    double sum_m = 0.0;
    int hits = 0;
    for (const PalpationAnswer& answer : answers)
        for (const FindingMatch& match : answer.matches)
            if (match.hit()) {
                sum_m += 2.0 / 3.0 * std::max(answer.truth.hitRadius_m, answer.truth.lumps[static_cast<std::size_t>(match.lump)].radius_m);
                ++hits;
            }
    return hits > 0 ? Measurement::of(1e3 * sum_m / hits) : Measurement::undefined(UndefinedReason::noLumpFound);
}

} // namespace

MetricDefinition localisationErrorByChanceMetric() {
    return {.id = "localisation_error_by_chance",
            .version = 1,
            .unit = "mm",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "localisation_error of findings that hit at random: 2/3 of the radius within which a finding is a hit, the mean over all hits.",
            .source = "mean distance in a uniform disc; our definition",
            .measure = measureLocalisationErrorByChance};
}

} // namespace chiron::scoring
