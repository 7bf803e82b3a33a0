// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metrics/tube_samples.h"

namespace chiron::scoring {

/// The samples of a trial from which on the fold is to be kept back: from when it first was, to the trial's end, pauses left out. Empty where it never
/// was. Only where the trial has `fold_open`.
inline std::vector<std::size_t> sinceFoldOpened(const PreparedTrial& trial) {
    const std::vector<double>& open = *tubeQuantity(trial, "fold_open");
    std::vector<std::size_t> since;
    for (std::size_t i = 0; i < open.size(); ++i)
        if (trial.tool->paused[i] == 0 && (open[i] > 0.5 || !since.empty()))
            since.push_back(i);
    return since;
}

/// Why there is no retraction to measure, if there is none.
inline std::optional<Measurement> withoutFold(std::span<const PreparedTrial> trials) {
    if (auto why = withoutTube(trials, "tension_N"))
        return why;
    for (const PreparedTrial& trial : trials)
        if (!tubeQuantity(trial, "retraction_N") || !tubeQuantity(trial, "fold_open") || !tubeTruth(trial, "retraction_low_N") || !tubeTruth(trial, "retraction_high_N"))
            return Measurement::undefined(UndefinedReason::noSuchTarget);
    return std::nullopt;
}

} // namespace chiron::scoring
