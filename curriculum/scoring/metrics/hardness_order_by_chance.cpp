// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/finding_errors.h"

namespace chiron::scoring {

namespace {

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
    return all.pairs > 0 ? Measurement::of(100.0 * all.rightByChance) : Measurement::undefined(UndefinedReason::noUnequalPair);
}

} // namespace

MetricDefinition hardnessOrderByChanceMetric() {
    return {.id = "hardness_order_by_chance",
            .version = 1,
            .unit = "%",
            .direction = Direction::neutral,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "hardness_order of the same words given to the lumps that were found in random order: half of the pairs that were called "
                          "differently, none of those called alike.",
            .source = "expectation over all permutations of the answers; our definition",
            .measure = measureHardnessOrderByChance};
}

} // namespace chiron::scoring
