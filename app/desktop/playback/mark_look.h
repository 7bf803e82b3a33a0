// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme_colour.h"
#include "session/playback_mark.h"

#include <QString>

namespace chiron::desktop {

/// Icon (Breeze name) and colour of a mark.
QString markIcon(const session::PlaybackMarkKind& kind);
/// A critical error has the icon of an error, whatever its kind.
QString markIcon(const session::PlaybackMark& mark);
Colour markColour(const session::PlaybackMarkKind& kind);

} // namespace chiron::desktop
