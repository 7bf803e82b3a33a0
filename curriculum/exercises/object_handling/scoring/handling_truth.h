// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace.h"

#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// The truth of one trial of object handling. A value that a trace file does not record is empty.
struct HandlingTruth {
    std::optional<double> targetX_m; ///< W
    std::optional<double> targetY_m;
    std::optional<double> targetRadius_m;
    std::optional<double> squeezeLimit_N;
    std::optional<int> task; ///< simulation::HandlingTask
    std::optional<int> objects;
    std::optional<int> heaviest;   ///< object number, from 0
    std::vector<double> masses_kg; ///< by object number

    friend bool operator==(const HandlingTruth&, const HandlingTruth&) = default;
};

/// Reads the truth from the named values of a trial.
/// Errors: badInput naming the field.
core::Result<HandlingTruth> handlingTruthOf(std::span<const NamedValue> values);
/// The same, where an impossible truth counts as not recorded: metrics and reports then say what is missing.
HandlingTruth handlingTruthIn(const TrialTrace& trial);
/// The named values of the truth, in the order in which they are stored and exported. The inverse of
/// handlingTruthOf().
std::vector<NamedValue> valuesOf(const HandlingTruth& truth);

} // namespace chiron::scoring
