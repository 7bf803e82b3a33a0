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
    std::uint64_t frames = 0;       ///< stored in all, now; 0 of a sitting that is sealed
    std::uint64_t framesFromRing = 0; ///< of them, saved from the crash ring
    /// What could not be brought in, and why; empty where all was. A session that stays *running* is tried again at the
    /// next start.
    std::string problem;
    bool sealed = false; ///< a sitting of a blinded study: how many frames there are tells its conditions apart
};

/// Brings in what a crash left behind: sessions still marked running become *interrupted*, with the frames that their
/// ring still held, trials, events and scores. Called once after a database was opened for writing (only the holder of
/// its lock may). A ring whose program lives is left alone. What is wrong with one session or its ring is told in its entry
/// and keeps neither the others nor the site from going on. Failure: the list of sessions cannot be read. Blocking.
core::Result<std::vector<RecoveredSession>> recoverSessions(database::Database& database,
                                                            const std::filesystem::path& ringFolder);

} // namespace chiron::session
