// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/storage_facts.h"

#include "database/repositories/session_reader.h"
#include "recording/crash_ring.h"

namespace chiron::desktop {

core::Result<StorageFacts> readStorageFacts(const database::Database& database, const database::Actor& actor,
                                            const std::string& backupFolder) {
    auto reader = database.openReader();
    if (!reader)
        return tl::unexpected(reader.error());
    database::SessionFilter all;
    all.includeArchived = true;
    const auto sessions = database::SessionReader(**reader, actor).listSessions(all);
    if (!sessions)
        return tl::unexpected(sessions.error());
    StorageFacts facts;
    facts.sessions = static_cast<int>(sessions->size());
    for (const database::SessionSummary& session : *sessions)
        facts.recordings_bytes += session.recordingBytes;
    facts.room = session::storageRoom(database.file(), recording::defaultRingFolder());
    facts.backups = session::listBackups(backupFolder);
    return facts;
}

} // namespace chiron::desktop
