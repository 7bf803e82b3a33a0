// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_mark.h"

#include <QLocale>
#include <QString>
#include <string_view>

namespace chiron::session_report {

/// A mark of the recording in the words of its exercise (an id): "Over the limit for 0.35 s, up to 4.82 N".
/// Playback and paper use the same text, in the program's language. Pure function.
QString whatHappened(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale);
/// The same, and for a critical error also the statement that it is one.
QString markText(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale);

} // namespace chiron::session_report
