// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/playback_track.h"
#include "session/stored_session.h"

#include <functional>

namespace chiron::session {

/// Hears how much of the recording is read, 0..1; false stops the work.
using PlaybackProgress = std::function<bool(double)>;

/// Reads the whole recording once. Blocking (about a second for a session of ten minutes): on a worker, on the thread of the
/// session's connection. A session without frames gives an empty track. Failure: the reader's, doesNotHold naming the
/// damaged chunk; cancelled.
core::Result<PlaybackTrack> buildPlaybackTrack(StoredSession& session, const PlaybackProgress& progress = {});

} // namespace chiron::session
