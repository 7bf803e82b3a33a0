// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/session/palpation_record.h"
#include "session/playback_track.h"

#include <cstddef>
#include <span>
#include <vector>

namespace chiron::session {

/// Indices of the trial's reports that started a finding which existed at the end and matched no lump.
std::vector<std::size_t> falseAlarmReports(const scoring::PalpationAnswer& answer);

/// Adds the events of the palpations to a track: findings marked and taken back; as a false alarm at the time
/// of its mark, a finding that existed at the trial's end and matched no lump; and, at the end of a completed
/// trial, each missed lump. Uses the same list as the scores (PalpationOutcome::answer). Marks stay in the
/// order of time. Pure function.
void addPalpationMarks(PlaybackTrack& track, std::span<const PalpationOutcome> outcomes);

} // namespace chiron::session
