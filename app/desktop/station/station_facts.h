// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"
#include "session/loop_report.h"
#include "session/storage_room.h"

#include <optional>
#include <string>

namespace chiron::desktop {

/// The newest session that ran in real time.
struct LastLoop {
    database::SessionId session = 0;
    std::string startedUtc;
    session::LoopReport loop;
};

/// The contents of the station screen that need no measurement.
struct StationFacts {
    session::StorageRoom room;
    std::optional<LastLoop> last; ///< among the newest sessions that the person may see
};

/// Reads these contents.
/// Thread: worker; blocks.
/// Errors: those of the repository.
core::Result<StationFacts> readStationFacts(const database::Database& database, const database::Actor& actor);

} // namespace chiron::desktop
