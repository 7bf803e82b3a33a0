// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/elastic_tube/scoring/tube_truth.h"

#include "scoring/truth_reader.h"

#include <string_view>

namespace chiron::scoring {

namespace {

struct TubeNumber {
    std::string_view id;
    std::optional<double> TubeTruth::*value;
};

/// In the order in which they are stored; the task follows.
constexpr TubeNumber kTubeNumbers[] = {
    {"target_N", &TubeTruth::target_N},
    {"band_N", &TubeTruth::band_N},
    {"mark_m", &TubeTruth::mark_m},
    {"mark_tolerance_m", &TubeTruth::markTolerance_m},
    {"retraction_low_N", &TubeTruth::retractionLow_N},
    {"retraction_high_N", &TubeTruth::retractionHigh_N},
    {"over_stretch_m", &TubeTruth::overStretch_m},
    {"tear_m", &TubeTruth::tear_m},
    {"hold_s", &TubeTruth::hold_s},
};
constexpr std::string_view kTubeTask = "task";
constexpr int kMostTubeTasks = 1000; ///< a later version may have tasks that this one does not know

} // namespace

core::Result<TubeTruth> tubeTruthOf(std::span<const NamedValue> values) {
    TruthReader read(values);
    TubeTruth truth;
    for (const TubeNumber& number : kTubeNumbers)
        truth.*number.value = read.optional(number.id);
    truth.task = read.optionalCount(kTubeTask, 0, kMostTubeTasks);
    CHIRON_TRY(read.done());
    return truth;
}

TubeTruth tubeTruthIn(const TrialTrace& trial) {
    return tubeTruthOf(trial.truth).value_or(TubeTruth{});
}

std::vector<NamedValue> valuesOf(const TubeTruth& truth) {
    std::vector<NamedValue> values;
    for (const TubeNumber& number : kTubeNumbers)
        addRecorded(values, number.id, truth.*number.value);
    addRecorded(values, kTubeTask, truth.task);
    return values;
}

} // namespace chiron::scoring
