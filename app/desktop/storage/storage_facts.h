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

/// The contents of the storage screen, as they were at the time of the request.
struct StorageFacts {
    session::StorageRoom room;
    std::uint64_t recordings_bytes = 0;
    int sessions = 0;
    std::vector<session::BackupEntry> backups; ///< newest first
    database::BackupStanding standing;         ///< of the backup schedule
    std::string backupFolder;                  ///< folder for the plan's backups
    bool onTheSitesDisk = false;               ///< whether that folder is on the site's disk
};

/// Reads these contents. `stationFolder` is this station's backup folder, which is used if the plan names
/// none.
/// Thread: worker; blocks.
/// Errors: those of the repository.
core::Result<StorageFacts> readStorageFacts(const database::Database& database, const database::Actor& actor,
                                            const std::string& stationFolder);

} // namespace chiron::desktop
