// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/session/palpation_record.h"
#include "session/playback_track.h"

#include <cstddef>
#include <span>
#include <vector>

namespace chiron::session {

namespace mark_kinds {
/// A finding was reported; value: its number, from 1.
inline constexpr PlaybackMarkKind kFound{"found", "flag", MarkTone::event, true};
/// A finding was taken back; value: its number, from 1.
inline constexpr PlaybackMarkKind kTakenBack{"taken_back", "edit-undo"};
/// A finding without a lump; value: its number, from 1.
inline constexpr PlaybackMarkKind kFalseAlarm{"false_alarm", "dialog-close", MarkTone::penalty};
/// At the trial's end, a lump that no finding was close enough to.
inline constexpr PlaybackMarkKind kLumpMissed{"lump_missed", "dialog-close", MarkTone::penalty};
} // namespace mark_kinds

/// Indices of the trial's reports that started a finding which existed at the end and matched no lump.
std::vector<std::size_t> falseAlarmReports(const scoring::PalpationAnswer& answer);

/// Adds the events of the palpations to a track: findings marked and taken back; as a false alarm at the time
/// of its mark, a finding that existed at the trial's end and matched no lump; and, at the end of a completed
/// trial, each missed lump. Uses the same list as the scores (PalpationOutcome::answer). Marks stay in the
/// order of time. Pure function.
void addPalpationMarks(PlaybackTrack& track, std::span<const PalpationOutcome> outcomes);

} // namespace chiron::session
