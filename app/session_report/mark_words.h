// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "session/playback_mark.h"

#include <QLocale>
#include <QString>

namespace chiron::session_report {

/// A mark of the recording in the words of its exercise: "Over the limit for 0.35 s, up to 4.82 N". The one source for playback and
/// paper, in the program's language. Pure.
QString whatHappened(const session::PlaybackMark& mark, const catalogue::ExerciseParameters& level, const QLocale& locale);
/// The same, and of a critical error that it is one.
QString markText(const session::PlaybackMark& mark, const catalogue::ExerciseParameters& level, const QLocale& locale);

} // namespace chiron::session_report
