// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/session/palpation_record.h"
#include "session/playback_track.h"

#include <cstddef>
#include <span>
#include <vector>

namespace chiron::session {

/// Which of a trial's reports, by index, began a finding that was there at the end and found no lump.
std::vector<std::size_t> falseAlarmReports(const scoring::PalpationAnswer& answer);

/// Adds to a track what happened in its palpations: findings marked and taken back, a finding that is there at the trial's end and
/// found no lump as a false alarm where it was marked, and at the end of a trial that came to one each lump that was missed. The
/// same list as the scores' (PalpationOutcome::answer). Marks stay in the order of time. Pure.
void addPalpationMarks(PlaybackTrack& track, std::span<const PalpationOutcome> outcomes);

} // namespace chiron::session
