// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recovery.h"

#include "database/repositories/session_reader.h"
#include "database/repositories/session_repository.h"
#include "database/repositories/study_blinding.h"
#include "recording/recorder.h"
#include "recording/ring_recovery.h"
#include "session/channels.h"
#include "session/live_recording.h"
#include "session/session_outcome.h"

#include <optional>

namespace chiron::session {

namespace {

/// The ring that a dead program left of a session, if there is one. An unreadable ring is an error, because
/// it may hold data that exist nowhere else. Only the session's own ring is examined: damage to another one
/// does not concern it.
core::Result<std::optional<recording::RecoveredRing>> ringOf(const std::vector<std::filesystem::path>& rings,
                                                             const recording::DatabaseId& id,
                                                             database::SessionId session) {
    const std::string name = recording::ringFilePrefix(id) + std::to_string(session) + recording::kRingSuffix;
    for (const auto& path : rings) {
        if (path.filename() != name)
            continue;
        auto ring = recording::recoverRing(path);
        if (!ring) {
            if (ring.error().code == core::ErrorCode::locked)
                continue;
            return tl::unexpected(ring.error());
        }
        if (ring->session() == session)
            return std::optional<recording::RecoveredRing>(std::move(*ring));
    }
    return std::optional<recording::RecoveredRing>();
}

core::Result<std::uint64_t> storeRingFrames(database::Database& database,
                                            const database::SessionRecord& record,
                                            const recording::RecoveredRing& ring) {
    auto setup = setupFromStored(record.setup);
    CHIRON_TRY(setup);
    auto positions = ToolPositions::create(*setup);
    auto table = channelTableFor(*setup);
    CHIRON_TRY(positions);
    CHIRON_TRY(table);
    return database.write([&](database::WriteContext& context) -> core::Result<std::uint64_t> {
        const database::Actor maintenance = database::Actor::maintenance();
        auto sink =
            database::SessionRepository(context.connection(), maintenance).openSink(record.summary.id);
        CHIRON_TRY(sink);
        auto stored =
            database::SessionReader(context.connection(), maintenance).openChunks(record.summary.id);
        CHIRON_TRY(stored);
        recording::Recorder recorder(std::move(*table), **positions, **sink,
                                     {.forceLimit_N = record.setup.forceLimit_N});
        CHIRON_TRY(recorder.resume(**stored));
        CHIRON_TRY(recorder.add(ring.frames()));
        CHIRON_TRY(recorder.finish());
        return recorder.framesCommitted();
    });
}

core::Result<RecoveredSession> recoverOne(database::Database& database, const database::SessionRecord& record,
                                          const std::vector<std::filesystem::path>& rings,
                                          const recording::DatabaseId& id) {
    RecoveredSession recovered;
    recovered.session = record.summary.id;
    auto ring = ringOf(rings, id, record.summary.id);
    if (!ring && ring.error().code == core::ErrorCode::badInput) {
        // A later try would not succeed either: the session ends with its committed data, and the file stays
        // for an expert.
        recovered.problem = ring.error().message;
        ring = std::optional<recording::RecoveredRing>();
    }
    CHIRON_TRY(ring);
    RunEnding ending;
    ending.interrupted = true;
    if (*ring) {
        auto stored = storeRingFrames(database, record, **ring);
        CHIRON_TRY(stored);
        recovered.framesFromRing = *stored;
        ending.dropped = (*ring)->dropped();
    }
    auto card = concludeSession(database, database::Actor::maintenance(), record.summary.id, ending);
    CHIRON_TRY(card);
    if (*ring) {
        CHIRON_TRY((*ring)->remove());
    }
    return recovered;
}

/// The possible locations of a session's ring: the current program's folder, and the one that the session's
/// own program used.
std::vector<std::filesystem::path> ringsFor(const database::SessionRecord& record,
                                            const std::filesystem::path& ringFolder,
                                            const recording::DatabaseId& id) {
    auto rings = recording::listRings(ringFolder, id);
    const std::filesystem::path own = record.setup.ringFile;
    if (!own.empty() && own != ringFolder) {
        recording::removeUnfinishedRings(own, id);
        const auto more = recording::listRings(own, id);
        rings.insert(rings.end(), more.begin(), more.end());
    }
    return rings;
}

/// A program killed between the end of its session and the removal of its ring leaves a ring whose frames are
/// all stored. Rings of sessions that this database does not know (after restoring a backup) are left alone.
void removeRingsOfEndedSessions(database::SessionReader reader, const std::filesystem::path& ringFolder,
                                const recording::DatabaseId& id) {
    for (const auto& path : recording::listRings(ringFolder, id)) {
        auto ring = recording::recoverRing(path);
        if (!ring)
            continue;
        const auto record = reader.session(ring->session());
        if (record && record->summary.state != database::SessionState::running)
            (void)ring->remove(); // if this fails, the next start tries again
    }
}

} // namespace

core::Result<std::vector<RecoveredSession>> recoverSessions(database::Database& database,
                                                            const std::filesystem::path& ringFolder) {
    auto id = ringIdOf(database);
    CHIRON_TRY(id);
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    auto unfinished = database::SessionReader(**connection, database::Actor::maintenance()).listUnfinished();
    CHIRON_TRY(unfinished);
    std::vector<RecoveredSession> all;
    recording::removeUnfinishedRings(ringFolder, *id);
    for (const database::SessionRecord& record : *unfinished) {
        auto recovered = recoverOne(database, record, ringsFor(record, ringFolder, *id), *id);
        if (!recovered) {
            all.push_back({record.summary.id, 0, 0, recovered.error().message});
            continue;
        }
        auto summary =
            database::SessionReader(**connection, database::Actor::maintenance()).session(record.summary.id);
        recovered->sealed =
            database::isSealedSitting(**connection, database::Actor::anonymous(), record.summary.id)
                .value_or(true);
        if (recovered->sealed)
            recovered->framesFromRing = 0;
        else if (summary)
            recovered->frames = summary->summary.frames;
        all.push_back(*recovered);
    }
    removeRingsOfEndedSessions(database::SessionReader(**connection, database::Actor::maintenance()),
                               ringFolder, *id);
    return all;
}

} // namespace chiron::session
