// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_mark.h"

namespace chiron::session::mark_kinds {

/// The answer missed the sphere: it was beside it, or in the air.
inline constexpr PlaybackMarkKind kMissed{"missed", "dialog-close", MarkTone::penalty};

} // namespace chiron::session::mark_kinds
