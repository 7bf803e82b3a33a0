// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/finding_errors.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

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
        return Measurement::undefined(UndefinedReason::noHardnessAsked);
    return Measurement::undefined(all.rated < 2 ? UndefinedReason::tooFewHardnessOfATrial
                                                : UndefinedReason::equallyHard);
}

/// All rated hits of the session: they were rated on one scale.
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
        return Measurement::undefined(UndefinedReason::noHardnessAsked);
    return Measurement::undefined(all.rated < 2 ? UndefinedReason::tooFewHardness : UndefinedReason::equallyHard);
}

} // namespace

MetricDefinition hardnessOrderMetric() {
    return {.id = "hardness_order",
            .version = 1,
            .unit = "%",
            .direction = Direction::higherIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::pooled,
            .tools = MetricTools::first,
            .definition = "Share of the pairs of lumps found in one trial whose harder one was called harder; pairs truly alike "
                          "are left out, called alike is not right; all trials pooled.",
            .source = "models.md §6 (hardness-rank correctness); our definition",
            .measure = measureHardnessOrder};
}

MetricDefinition hardnessOrderMetric2() {
    MetricDefinition metric = hardnessOrderMetric();
    metric.version = 2;
    metric.definition = "Share of the pairs of lumps found in the session whose harder one was called harder, on one scale from 1 to 5; pairs truly "
                        "alike are left out, called alike is not right.";
    metric.source = "models.md §6 (hardness-rank correctness); probability of concordance; our definition";
    metric.measure = measureHardnessOrder2;
    return metric;
}

} // namespace chiron::scoring
