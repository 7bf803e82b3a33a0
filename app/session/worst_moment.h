// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/score_card.h"
#include "session/playback_track.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace chiron::session {

/// A moment that is worth reviewing: the single worst one, or the one behind a failed gate.
struct WorstMoment {
    double t_s = 0.0;         ///< on the track's time
    double intoTrial_s = 0.0; ///< since the trial began; the recording begins earlier
    int trial = 0;
    double value = 0.0;      ///< in `unit`
    std::string unit;        ///< of the metric, "N" for a force
    std::string reason;      ///< id of the metric that leads here; "force_max" for a force
    bool gateFailed = false; ///< derived from a failed gate
    /// The value is that of the trial as a whole: the metric has no moment in it, and `t_s` is the trial's
    /// end.
    bool wholeTrial = false;
    std::optional<PlaybackMark> event{}; ///< the event that happened here, if the moment is one
    std::optional<double> depth_m{};     ///< ExerciseKind::depthAt_m
};

/// Locates the worst moment behind a failed gate. Of the failed gates, broken tissue has priority, then the
/// first gate that has a moment of its own: for a force metric the largest tissue force; for others as
/// specified by the exercise (ExerciseKind::momentRules, PlaybackTrack::peaks). Only if no gate has one: as
/// specified for metrics that are spread over a trial, or the end of the trial with the worst value. Without
/// a failed gate only what is nevertheless worth a look: the largest tissue force of all trials, if it
/// reached 80 % of the level's limit (PlaybackTrack::forceLimit_N); otherwise the trial whose own value would
/// have missed a gate. Pauses and the time between trials do not count. Empty if nothing stands out, and for
/// a track without a trial. Pure function.
std::optional<WorstMoment> worstMoment(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                       std::span<const scoring::Gate> gates);

/// The moment behind each failed gate, in the order of the gates, located as for worstMoment(). A gate for
/// which the recording shows neither a moment nor a worst trial is left out. Pure function.
std::vector<WorstMoment> momentsOfFailedGates(const PlaybackTrack& track, const scoring::ScoreCard& card,
                                              std::span<const scoring::Gate> gates);

} // namespace chiron::session
