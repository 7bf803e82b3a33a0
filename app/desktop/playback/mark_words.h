// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme_colour.h"
#include "session/playback_mark.h"
#include "session_report/mark_words.h"

#include <QString>

namespace chiron::desktop {

using session_report::markText;
/// A mark's sign (Breeze name) and colour.
QString markIcon(session::PlaybackMarkKind kind);
QString markIcon(const session::PlaybackMark& mark); ///< a critical error has the sign of an error, whatever its kind
Colour markColour(session::PlaybackMarkKind kind);

} // namespace chiron::desktop
