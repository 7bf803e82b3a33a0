// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/storage_facts.h"

#include "database/repositories/session_reader.h"
#include "recording/crash_ring.h"
#include "session/backup_schedule.h"
#include "session/same_disk.h"

namespace chiron::desktop {

core::Result<StorageFacts> readStorageFacts(const database::Database& database, const database::Actor& actor,
                                            const std::string& stationFolder) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    database::SessionFilter all;
    all.includeArchived = true;
    const auto sessions = database::SessionReader(**reader, actor).listSessions(all);
    CHIRON_TRY(sessions);
    StorageFacts facts;
    facts.sessions = static_cast<int>(sessions->size());
    for (const database::SessionSummary& session : *sessions)
        facts.recordings_bytes += session.recordingBytes;
    facts.room = session::storageRoom(database.file(), recording::defaultRingFolder());
    auto standing = database::Upkeep::backupStanding(**reader, actor);
    CHIRON_TRY(standing);
    facts.standing = std::move(*standing);
    facts.backupFolder = session::folderOfPlan(facts.standing.plan, stationFolder, database.file());
    facts.onTheSitesDisk = session::onOneDisk(facts.backupFolder, database.file());
    facts.backups = session::listBackups(facts.backupFolder);
    return facts;
}

} // namespace chiron::desktop
