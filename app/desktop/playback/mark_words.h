// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/theme/theme_colour.h"
#include "session/playback_mark.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// A mark of the recording in the words of its exercise: "Over the limit for 0.35 s, up to 4.82 N". GUI thread.
QString markText(const session::PlaybackMark& mark, const catalogue::ExerciseParameters& level, const QLocale& locale);
/// Its sign (Breeze name) and colour.
QString markIcon(session::PlaybackMarkKind kind);
QString markIcon(const session::PlaybackMark& mark); ///< a critical error has the sign of an error, whatever its kind
Colour markColour(session::PlaybackMarkKind kind);

} // namespace chiron::desktop
