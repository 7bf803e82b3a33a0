// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace.h"

#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// The truth of one trial with an elastic tube. A value that its task does not have, or that a trace file
/// does not record, is empty.
struct TubeTruth {
    std::optional<double> target_N; ///< tension to be held
    std::optional<double> band_N;   ///< how far from it the tension may be
    std::optional<double> mark_m;   ///< stretch to be held, beyond the rest length
    std::optional<double> markTolerance_m;
    std::optional<double> retractionLow_N; ///< pull on the fold
    std::optional<double> retractionHigh_N;
    std::optional<double> overStretch_m; ///< beyond the rest length
    std::optional<double> tear_m;        ///< likewise
    std::optional<double> hold_s;
    std::optional<int> task; ///< simulation::TubeTask

    friend bool operator==(const TubeTruth&, const TubeTruth&) = default;
};

/// Reads the truth from the named values of a trial.
/// Errors: badInput naming the field.
core::Result<TubeTruth> tubeTruthOf(std::span<const NamedValue> values);
/// The same, where an impossible truth counts as not recorded: metrics and reports then say what is missing.
TubeTruth tubeTruthIn(const TrialTrace& trial);
/// The named values of the truth, in the order in which they are stored and exported. The inverse of
/// tubeTruthOf().
std::vector<NamedValue> valuesOf(const TubeTruth& truth);

} // namespace chiron::scoring
