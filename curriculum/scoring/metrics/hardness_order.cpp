// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "scoring/metrics/palpation_samples.h"

#include "scoring/detection/finding_errors.h"

#include <algorithm>

namespace chiron::scoring {

namespace {

Measurement measureHardnessOrder(std::span<const PreparedTrial> trials) { if (chiron_mutants::on(32)) {
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
    if (!asked && all.rated != 0)
        return Measurement::undefined(UndefinedReason::noHardnessAsked);
    return Measurement::undefined(all.rated < 2 ? UndefinedReason::tooFewHardnessOfATrial
                                                : UndefinedReason::equallyHard);
} else {
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
} }

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
