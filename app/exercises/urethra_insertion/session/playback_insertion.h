// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "session/playback_track.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::session {

/// The position of an endoscope in its canal at one sample of a track, as the scoring used it
/// (scoring::InsertionSeries).
/// Unit: SI.
struct PlaybackInsertionMoment {
    /// Arc length of the tip's foot; NaN before the trial.
    double depth_m = std::numeric_limits<double>::quiet_NaN();
    double offset_m = std::numeric_limits<double>::quiet_NaN();
    double alignment_rad = std::numeric_limits<double>::quiet_NaN();
    simulation::ProcedureStage stage = simulation::ProcedureStage::outside;
};

/// The course of an endoscope through a canal over a track's time: the exercise-specific data of the track
/// (PlaybackTrack::of). A plain value.
/// Thread: any one.
struct PlaybackInsertion final : PlaybackOfExercise {
    double length_m = 0.0; ///< L: length of the canal
    double bend_m = 0.0;   ///< s_B: arc length of the bend
    double goal_m = 0.0;   ///< depth that ends the insertion
    /// Track time at which each landmark was seen, NaN if it was not; empty if there are no landmarks.
    std::vector<double> landmarkSeen_s;
    std::vector<PlaybackInsertionMoment> moments; ///< one per moment of the track

    std::uint32_t landmarksSeenAt(double t_s) const noexcept; ///< one bit per landmark
    int landmarksSeen() const noexcept;                       ///< total
};

/// The insertion data of a session's trials at the times of a track. If several trials have a series, the
/// fixed values (length, bend, goal, landmarks) are those of the first one. A time before a trial's first
/// sample holds nothing, one after its last sample that sample's stage. Pure function.
PlaybackInsertion playbackInsertionOf(const scoring::SessionTrace& trace, std::span<const double> times_s);

/// The ids of the series that addInsertion() derives: the tip's distance from the centre-line, and the angle
/// between endoscope and canal.
inline constexpr std::string_view kOffsetSeries = "offset_m";
inline constexpr std::string_view kAlignmentSeries = "alignment_rad";

/// Adds the insertion data to a track that has moments, as its exercise-specific data and as derived series.
/// Does nothing if no trial has a series, because the device could not be turned or no trial was started.
void addInsertion(PlaybackTrack& track, const scoring::SessionTrace& trace);

/// The insertion data at a time of the track, clamped to it; empty if the track has none.
std::optional<PlaybackInsertionMoment> insertionAt(const PlaybackTrack& track, double t_s);

} // namespace chiron::session
