// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "report/report_data.h"
#include "session/playback_track.h"

#include <QLocale>

namespace chiron::session_report {

/// All tools of a playback track as series for plots, on screen and on paper: named by the level, with
/// hatched pauses, the trials' numbers as events, and the track's critical errors in words. Pure function.
report::SampleSeries seriesOf(const session::PlaybackTrack& track, const catalogue::ExerciseLevel& level,
                              const QLocale& locale);

} // namespace chiron::session_report
