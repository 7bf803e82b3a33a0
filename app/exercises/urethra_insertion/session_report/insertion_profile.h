// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/report/insertion_report.h"
#include "scoring/trace.h"
#include "session/playback_track.h"

#include <optional>

namespace chiron::session_report {

/// The deviation of an endoscope from its canal, by depth: the largest distance and angle in each millimetre,
/// beginning one centimetre before the entrance, for the stages before the goal and for the withdrawal.
/// Pauses do not count. Empty for exercises without a canal. Pure function.
std::optional<report::InsertionProfile> insertionProfileOf(const scoring::SessionTrace& trace);
std::optional<report::InsertionProfile> insertionProfileOf(const session::PlaybackTrack& track);

} // namespace chiron::session_report
