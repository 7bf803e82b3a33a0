// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "database/repositories/session_types.h"
#include "scoring/score_card.h"

#include <cstdint>
#include <optional>

namespace chiron::session {

/// What the run knew of its own end that the recording does not show.
struct RunEnding {
    std::uint64_t dropped = 0;    ///< frames lost to a full ring
    bool interrupted = false;     ///< the program died; found by recovery
    bool stopped = false;         ///< asked to stop from outside (signal, window closed)
    std::string loopJson = "{}";
};

/// After the last frame is stored: derives trials, events and state from the stored frames, ends the session and stores
/// its scores. One path for a session that just ended and for one that a crash left open. Blocking; a worker's task.
/// Failure: storage, or the reader's.
core::Result<scoring::ScoreCard> concludeSession(database::Database& database, const database::Actor& actor,
                                                 database::SessionId session, const RunEnding& ending);

} // namespace chiron::session
