// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/query.h"
#include "database/repositories/chunk_store.h"

#include <algorithm>

namespace chiron::database {
namespace {

class StoredChunks final : public recording::ChunkSource {
public:
    StoredChunks(Connection& connection, SessionId session, std::size_t count)
        : m_connection(connection), m_session(session), m_count(count) {}

    core::Result<std::vector<std::uint8_t>> channelTable() override {
        auto query = Query::run(m_connection, "SELECT channel_table FROM session WHERE id = ?", {m_session});
        CHIRON_TRY(query);
        const auto row = query->next();
        CHIRON_TRY(row);
        return *row ? core::Result<std::vector<std::uint8_t>>(query->blob(0))
                    : core::fail(core::ErrorCode::notFound,
                                 "session " + std::to_string(m_session) + " is gone");
    }
    std::size_t chunkCount() const override { return m_count; }
    core::Result<recording::Chunk> chunk(std::size_t sequence) override {
        auto query = Query::run(m_connection,
                                "SELECT first_tick, frames, payload, payload_digest, force_hash FROM chunk "
                                "WHERE session_id = ? AND sequence = ?",
                                {m_session, static_cast<std::int64_t>(sequence)});
        CHIRON_TRY(query);
        const auto row = query->next();
        CHIRON_TRY(row);
        const std::string name =
            "chunk " + std::to_string(sequence) + " of session " + std::to_string(m_session);
        const Blob digest = *row ? query->blob(3) : Blob();
        const Blob hash = *row ? query->blob(4) : Blob();
        recording::Chunk chunk;
        if (digest.size() != chunk.payloadDigest.size() || hash.size() != chunk.forceHash.size()) {
            return *row ? core::fail(core::ErrorCode::storage, name + " is damaged")
                        : core::fail(core::ErrorCode::notFound, name + " is missing");
        }
        chunk.sequence = static_cast<std::uint32_t>(sequence);
        chunk.firstTick = unsignedFromStored(query->integer(0));
        chunk.frames = static_cast<std::uint32_t>(query->integer(1));
        chunk.payload = query->blob(2);
        std::copy(digest.begin(), digest.end(), chunk.payloadDigest.begin());
        std::copy(hash.begin(), hash.end(), chunk.forceHash.begin());
        return chunk;
    }

private:
    Connection& m_connection;
    SessionId m_session;
    std::size_t m_count;
};

} // namespace

core::Result<std::unique_ptr<recording::ChunkSource>> makeChunkSource(Connection& connection,
                                                                      SessionId session) {
    const auto count =
        selectInteger(connection, "SELECT count(*) FROM chunk WHERE session_id = ?", {session});
    CHIRON_TRY(count);
    return std::make_unique<StoredChunks>(connection, session, static_cast<std::size_t>(count->value_or(0)));
}

} // namespace chiron::database
