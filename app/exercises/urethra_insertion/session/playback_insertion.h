// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "scoring/trace.h"
#include "session/playback_track.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace chiron::session {

/// An endoscope in its canal at one sample of a track: what scoring saw (scoring::InsertionSeries). SI.
struct PlaybackInsertionMoment {
    double depth_m = std::numeric_limits<double>::quiet_NaN(); ///< arc length of the tip's foot; not a number before the trial
    double offset_m = std::numeric_limits<double>::quiet_NaN();
    double alignment_rad = std::numeric_limits<double>::quiet_NaN();
    core::ProcedureStage stage = core::ProcedureStage::outside;
};

/// The way of an endoscope through a canal over a track's time: what a track has as its own (PlaybackTrack::of). A value; any one thread.
struct PlaybackInsertion final : PlaybackOfExercise {
    double length_m = 0.0; ///< L
    double bend_m = 0.0;   ///< s_B
    double goal_m = 0.0;   ///< depth that ends the insertion
    std::vector<double> landmarkSeen_s; ///< on the track's time, not a number where it was not seen; empty: none to be seen
    std::vector<PlaybackInsertionMoment> moments; ///< one a moment of the track

    std::uint32_t landmarksSeenAt(double t_s) const noexcept; ///< one bit each
    int landmarksSeen() const noexcept;                       ///< in all
};

/// Of a session's trials, at the times of a track. Where several trials have a series, facts are the first one's. A time before
/// a trial's first sample holds nothing, one after its last sample that sample's stage. Pure.
PlaybackInsertion playbackInsertionOf(const scoring::SessionTrace& trace, std::span<const double> times_s);

/// Puts it into a track with moments, as its own and as its canal. Nothing where no trial has a series: the device could not be turned, or
/// nothing was begun.
void addInsertion(PlaybackTrack& track, const scoring::SessionTrace& trace);

/// At a time of the track, clamped to it; nothing where it has none.
std::optional<PlaybackInsertionMoment> insertionAt(const PlaybackTrack& track, double t_s);

} // namespace chiron::session
