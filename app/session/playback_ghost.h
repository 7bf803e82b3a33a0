// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_track.h"

#include <optional>
#include <vector>

namespace chiron::session {

/// A second session of the same exercise and level for comparison with the first. Each of its trials starts
/// when the first session's trial of the same number starts. If the objects of the two trials differ (other
/// seeds), the ghost is moved with its object, so that both hands are seen relative to the same object.
struct GhostTool {
    PlaybackTool tool;
    double ownTime_s = 0.0; ///< time on the ghost's own track
};

/// The ghost's tool 0 at `t_s` of `track`; empty before the first trial, after the end of the ghost's trial,
/// and in a trial that the ghost does not have. Pure function.
std::optional<GhostTool> ghostAt(const PlaybackTrack& track, const PlaybackTrack& ghost, double t_s);

/// The ghost's values over the first track's time, for a second line in a plot; NaN between trials.
struct GhostSeries {
    std::vector<double> t_s;
    std::vector<double> tissue_N;
    std::vector<double> speed_m_per_s;
    std::vector<PlaybackQuantity> derived; ///< PlaybackTrack::derived
};
GhostSeries ghostSeries(const PlaybackTrack& track, const PlaybackTrack& ghost);

} // namespace chiron::session
