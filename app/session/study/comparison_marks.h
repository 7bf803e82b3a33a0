// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_mark.h"

namespace chiron::session::mark_kinds {

/// A lifted object was pressed onto its bed so hard that it came off the tool; value: the force, N.
inline constexpr PlaybackMarkKind kCameOff{"came_off", "object-unlocked"};

} // namespace chiron::session::mark_kinds
