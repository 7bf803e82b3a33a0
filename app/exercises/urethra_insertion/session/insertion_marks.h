// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/score_card.h"
#include "scoring/trace.h"
#include "session/playback_track.h"

#include <span>

namespace chiron::session {

namespace mark_kinds {
/// A landmark of the bladder was inspected; value: number of landmarks seen so far.
inline constexpr PlaybackMarkKind kLandmarkSeen{"landmark_seen", "view-visible", MarkTone::success};
/// Force across the canal over the level's limit, from t_s to end_s; value: the largest force, N.
inline constexpr PlaybackMarkKind kTrauma{"trauma", "dialog-warning", MarkTone::penalty};
/// The tip moved backwards during the insertion, from t_s to end_s; value: the distance, m.
inline constexpr PlaybackMarkKind kReversal{"reversal", "edit-undo", MarkTone::penalty};
/// Farther from the centre-line than the level's gate allows, from t_s to end_s; value: the largest distance,
/// m.
inline constexpr PlaybackMarkKind kOffCentre{"off_centre", "dialog-warning", MarkTone::penalty};
/// Torque over the level's gate, from t_s to end_s; value: the largest torque, N·m.
inline constexpr PlaybackMarkKind kOverTorque{"over_torque", "dialog-warning", MarkTone::penalty};
} // namespace mark_kinds

/// Adds to a track the events that the scores of an insertion count, from the same list
/// (scoring/insertion_events.h), so that each penalty can be reviewed: trauma events, reversals, and the
/// intervals beyond the level's gates on offset_max and torque_max, with their ends and sizes. Records each
/// trial's largest offset, misalignment and torque. Adds to the existing marks which stage began and how many
/// landmarks had been seen. Marks stay in the order of time. The track is unchanged if no trial has an
/// insertion series. `traumaIsCritical`: the session's critical_errors counts trauma that is long or hard
/// (scoring::isCritical), and its marks state this.
/// Errors: a trace that cannot be scored (trace_grid.h).
core::Result<void> addInsertionMarks(PlaybackTrack& track, const scoring::SessionTrace& trace,
                                     std::span<const scoring::Gate> gates, bool traumaIsCritical = false);

} // namespace chiron::session
