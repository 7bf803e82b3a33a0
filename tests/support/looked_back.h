// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/session_view.h"

namespace chiron::tests {

/// Trace and track of a stored session as values of the test's own.
inline core::Result<scoring::SessionTrace> traceOf(session::SessionView& view) {
    const auto trace = view.trace();
    return trace ? core::Result<scoring::SessionTrace>(**trace) : tl::unexpected(trace.error());
}

inline core::Result<session::PlaybackTrack> trackOf(session::SessionView& view,
                                                    const session::ReadProgress& progress = {}) {
    const auto track = view.track(progress);
    return track ? core::Result<session::PlaybackTrack>(**track) : tl::unexpected(track.error());
}

} // namespace chiron::tests
