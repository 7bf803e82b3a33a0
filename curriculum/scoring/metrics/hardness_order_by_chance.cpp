// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/finding_errors.h"

namespace chiron::scoring {

namespace {

Measurement measureHardnessOrderByChance(std::span<const PreparedTrial> trials) {
    const auto [answers, undefined] = judged(trials);
    if (undefined)
        return *undefined;
    double right = 0.0;
    int pairs = 0;
    for (const PalpationAnswer& answer : answers) {
        const HardnessPairs all = hardnessPairs(answer.truth, answer.findings, answer.matches);
        right += all.pairs * all.rightByChance;
        pairs += all.pairs;
    }
    return pairs > 0 ? Measurement::of(100.0 * right / pairs) : Measurement::undefined("no two lumps of different hardness were found and rated in one trial");
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
            .definition = "hardness_order of the same words given to the lumps of each trial in random order: half of the pairs that were called "
                          "differently, none of those called alike.",
            .source = "expectation over all permutations of the answers; our definition",
            .measure = measureHardnessOrderByChance};
}

} // namespace chiron::scoring
