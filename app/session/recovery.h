// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"

#include <filesystem>
#include <string>
#include <vector>

namespace chiron::session {

struct RecoveredSession {
    database::SessionId session = 0;
    std::uint64_t frames = 0;         ///< total number now stored; 0 for a sealed study session
    std::uint64_t framesFromRing = 0; ///< of these, frames recovered from the crash ring
    /// What could not be recovered, and why; empty if everything was. A session that remains *running* is
    /// tried again at the next start.
    std::string problem;
    bool sealed = false; ///< a session of a blinded study: its number of frames would reveal the condition
};

/// Recovers the data that a crash left behind: sessions still marked running become *interrupted*, with the
/// frames that their ring still held, and with trials, events and scores. Call it once after opening a
/// database for writing (only the holder of its lock may). The ring of a program that is still alive is left
/// alone. Problems with one session or its ring are reported in its entry and do not prevent the recovery of
/// others. Blocks.
/// Errors: the list of sessions cannot be read.
core::Result<std::vector<RecoveredSession>> recoverSessions(database::Database& database,
                                                            const std::filesystem::path& ringFolder);

} // namespace chiron::session
