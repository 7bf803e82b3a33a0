// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_track.h"

#include <optional>
#include <vector>

namespace chiron::session {

/// A second session of the same exercise and level beside the first: each of its trials starts when the first's trial
/// of the same number starts. Where the objects of the two trials differ (other seeds), the ghost is moved with its
/// object, so that both hands are seen at the same place of the ball.
struct GhostTool {
    PlaybackTool tool;
    double ownTime_s = 0.0; ///< on the ghost's own track
};

/// The ghost's tool 0 at `t_s` of `track`; nothing before the first trial, after the ghost's trial has ended, and in a
/// trial that the ghost does not have. Pure.
std::optional<GhostTool> ghostAt(const PlaybackTrack& track, const PlaybackTrack& ghost, double t_s);

/// What the ghost did over the first track's time, for a second line in a plot; a gap (not a number) between trials.
struct GhostSeries {
    std::vector<double> t_s;
    std::vector<double> tissue_N;
    std::vector<double> speed_m_per_s;
    std::vector<double> offset_m;      ///< empty without an endoscope
    std::vector<double> alignment_rad; ///< the same
};
GhostSeries ghostSeries(const PlaybackTrack& track, const PlaybackTrack& ghost);

} // namespace chiron::session
