// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_mark.h"
#include "session_report/exercise_reporter.h"

#include <QLocale>
#include <QString>
#include <string_view>

namespace chiron::session_report {

/// Parts of the words for a mark. "0.35 s": how long it lasted.
QString markSpan(const session::PlaybackMark& mark, const QLocale& locale);
/// Its value, which is in this unit.
QString markValue(const session::PlaybackMark& mark, const QString& unit, const QLocale& locale);
/// Its value in thousandths of the unit in which it is stored: metres as mm.
QString markThousandths(const session::PlaybackMark& mark, const QString& unit, const QLocale& locale);
/// Its value as a whole number.
QString markNumber(const session::PlaybackMark& mark, const QLocale& locale);

/// The words for the steps of tasks with graspers (core::LaparoscopyStep).
std::span<const StageWords> laparoscopySteps() noexcept;

/// A mark of the recording in the words of its exercise (an id): "Over the limit for 0.35 s, up to 4.82 N".
/// Playback and paper use the same text, in the program's language. Pure function.
QString whatHappened(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale);
/// The same, and for a critical error also the statement that it is one.
QString markText(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale);

} // namespace chiron::session_report
