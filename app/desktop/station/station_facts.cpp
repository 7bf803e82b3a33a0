// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/station_facts.h"

#include "database/repositories/session_reader.h"
#include "recording/crash_ring.h"

namespace chiron::desktop {

core::Result<StationFacts> readStationFacts(const database::Database& database, const database::Actor& actor) {
    constexpr int kLookedAt = 20; // scripted sessions ran as fast as they could and say nothing of the station
    auto connection = database.openReader();
    if (!connection)
        return tl::unexpected(connection.error());
    database::SessionReader reader(**connection, actor);
    database::SessionFilter filter;
    filter.newestFirst = true;
    filter.includeArchived = true;
    filter.limit = kLookedAt;
    const auto newest = reader.listSessions(filter);
    if (!newest)
        return tl::unexpected(newest.error());
    StationFacts facts;
    facts.room = session::storageRoom(database.file(), recording::defaultRingFolder());
    for (const database::SessionSummary& summary : *newest) {
        const auto record = reader.session(summary.id);
        if (!record || !record->setup.realtime)
            continue;
        const auto loop = session::loopReportFrom(record->loopJson);
        if (!loop || !loop->realtime)
            continue; // still running, or broken off
        facts.last = LastLoop{summary.id, summary.startedUtc, *loop};
        break;
    }
    return facts;
}

} // namespace chiron::desktop
