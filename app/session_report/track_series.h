// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_data.h"
#include "session/playback_track.h"

namespace chiron::session_report {

/// Tool 0 of a playback track as plots draw it: pauses hatched, the trials' numbers as events. Pure.
report::SampleSeries seriesOf(const session::PlaybackTrack& track);

} // namespace chiron::session_report
