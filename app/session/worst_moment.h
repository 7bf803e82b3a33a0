// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/score_card.h"
#include "session/playback_track.h"

#include <optional>
#include <span>
#include <string>

namespace chiron::session {

/// The one moment worth looking at first.
struct WorstMoment {
    double t_s = 0.0;         ///< on the track's time
    double intoTrial_s = 0.0; ///< since the trial began: the recording begins before it
    int trial = 0;
    double value = 0.0;     ///< in `unit`
    std::string unit;       ///< of the metric, "N" for a force
    std::string reason;     ///< id of the metric that failed, or "force_max" where none did
    bool gateFailed = false; ///< a gate that did not hold led here
};

/// Where what failed was worst. Of the gates that did not hold, broken tissue goes first, then the first one that has a moment of its
/// own: for a force metric the largest tissue force; for others as the exercise says (ExerciseKind::momentRules, PlaybackTrack::peaks).
/// Only where none has one: the trial that tore, or the end of the trial with the worst value. Without a failed gate the largest tissue force
/// of all trials. Pauses and the time between trials do not count. Nothing on a track without a trial, and where
/// nothing was touched and no gate has a moment. Pure.
std::optional<WorstMoment> worstMoment(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                       std::span<const scoring::Gate> gates);

} // namespace chiron::session
