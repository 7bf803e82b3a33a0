// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/object_handling/scoring/handling_truth.h"

#include "scoring/truth_reader.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace chiron::scoring {

namespace {

struct HandlingNumber {
    std::string_view id;
    std::optional<double> HandlingTruth::*value;
};
struct HandlingCount {
    std::string_view id;
    std::optional<int> HandlingTruth::*value;
};

/// In the order in which they are stored; the counts follow, and then the masses.
constexpr HandlingNumber kHandlingNumbers[] = {
    {"target_x_m", &HandlingTruth::targetX_m},
    {"target_y_m", &HandlingTruth::targetY_m},
    {"target_radius_m", &HandlingTruth::targetRadius_m},
    {"squeeze_limit_N", &HandlingTruth::squeezeLimit_N},
};
constexpr HandlingCount kHandlingCounts[] = {
    {"task", &HandlingTruth::task},
    {"objects", &HandlingTruth::objects},
    {"heaviest", &HandlingTruth::heaviest},
};
constexpr int kMostHandlingCount = 1000; ///< far more objects than fit on the bed

std::string massId(std::size_t object) {
    return "mass_" + std::to_string(object) + "_kg";
}

} // namespace

core::Result<HandlingTruth> handlingTruthOf(std::span<const NamedValue> values) {
    TruthReader read(values);
    HandlingTruth truth;
    for (const HandlingNumber& number : kHandlingNumbers)
        truth.*number.value = read.optional(number.id);
    for (const HandlingCount& count : kHandlingCounts)
        truth.*count.value = read.optionalCount(count.id, 0, kMostHandlingCount);
    while (const auto mass_kg = read.optional(massId(truth.masses_kg.size())))
        truth.masses_kg.push_back(*mass_kg);
    CHIRON_TRY(read.done());
    return truth;
}

HandlingTruth handlingTruthIn(const TrialTrace& trial) {
    return handlingTruthOf(trial.truth).value_or(HandlingTruth{});
}

std::vector<NamedValue> valuesOf(const HandlingTruth& truth) {
    std::vector<NamedValue> values;
    for (const HandlingNumber& number : kHandlingNumbers)
        addRecorded(values, number.id, truth.*number.value);
    for (const HandlingCount& count : kHandlingCounts)
        addRecorded(values, count.id, truth.*count.value);
    for (std::size_t object = 0; object < truth.masses_kg.size(); ++object)
        addRecorded(values, massId(object), truth.masses_kg[object]);
    return values;
}

} // namespace chiron::scoring
