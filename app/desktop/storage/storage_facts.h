// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"
#include "database/upkeep/upkeep.h"
#include "session/backup_list.h"
#include "session/storage_room.h"

#include <string>
#include <vector>

namespace chiron::desktop {

/// What the storage screen shows, as it was when asked for.
struct StorageFacts {
    session::StorageRoom room;
    std::uint64_t recordings_bytes = 0;
    int sessions = 0;
    std::vector<session::BackupEntry> backups; ///< newest first
    database::BackupStanding standing;         ///< of the schedule
    std::string backupFolder;                  ///< where the plan's backups go
    bool onTheSitesDisk = false;               ///< that folder
};

/// `stationFolder`: where this station keeps backups if the plan does not say. Blocking: a worker's task. Failure: the repository's.
core::Result<StorageFacts> readStorageFacts(const database::Database& database, const database::Actor& actor,
                                            const std::string& stationFolder);

} // namespace chiron::desktop
