// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/station_facts.h"

#include "database/repositories/session_reader.h"
#include "recording/crash_ring.h"

namespace chiron::desktop {

core::Result<StationFacts> readStationFacts(const database::Database& database,
                                            const database::Actor& actor) {
    // This many sessions are searched, because scripted ones ran faster than real time and say nothing about
    // the station.
    constexpr int kLookedAt = 20;
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    database::SessionReader reader(**connection, actor);
    database::SessionFilter filter;
    filter.newestFirst = true;
    filter.includeArchived = true;
    filter.limit = kLookedAt;
    const auto newest = reader.listSessions(filter);
    CHIRON_TRY(newest);
    StationFacts facts;
    facts.room = session::storageRoom(database.file(), recording::defaultRingFolder());
    for (const database::SessionSummary& summary : *newest) {
        const auto record = reader.session(summary.id);
        if (!record || !record->setup.realtime)
            continue;
        const auto loop = session::loopReportFrom(record->loopJson);
        if (!loop || !loop->realtime)
            continue; // still running, or ended before its report was stored
        facts.last = LastLoop{summary.id, summary.startedUtc, *loop};
        break;
    }
    return facts;
}

} // namespace chiron::desktop
