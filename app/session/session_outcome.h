// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "database/repositories/session_types.h"
#include "scoring/score_card.h"

#include <cstdint>
#include <optional>

namespace chiron::session {

/// Facts about the end of a run that the recording does not contain.
struct RunEnding {
    std::uint64_t dropped = 0; ///< frames lost to a full ring
    bool interrupted = false;  ///< the program died; detected by recovery
    bool stopped = false;      ///< stopped from outside (signal, window closed)
    std::string loopJson = "{}";
};

/// Call it after the last frame is stored: derives trials, events and state from the stored frames, ends the
/// session and stores its scores. A session that has just ended and one that a crash left open are handled in
/// the same way. Blocks; call it on a worker.
/// Errors: storage; those of the reader.
core::Result<scoring::ScoreCard> concludeSession(database::Database& database, const database::Actor& actor,
                                                 database::SessionId session, const RunEnding& ending);

} // namespace chiron::session
