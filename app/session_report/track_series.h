// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "report/report_data.h"
#include "session/playback_track.h"

#include <QLocale>

namespace chiron::session_report {

/// Every tool of a playback track as plots draw them, on screen and on paper: named by the level, pauses hatched, the trials' numbers as
/// events, the track's critical errors in words. Pure.
report::SampleSeries seriesOf(const session::PlaybackTrack& track, const catalogue::ExerciseLevel& level, const QLocale& locale);

} // namespace chiron::session_report
