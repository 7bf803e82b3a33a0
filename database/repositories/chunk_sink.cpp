// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/digested_row.h"
#include "database/repositories/chunk_store.h"

namespace chiron::database {
namespace {

Blob blobOf(const recording::Digest& digest) {
    return Blob(digest.begin(), digest.end());
}

class ChunkSink final : public recording::TrialSink {
public:
    ChunkSink(Connection& connection, SessionId session, std::int64_t next)
        : m_connection(connection), m_session(session), m_next(next) {}
    ChunkSink(const ChunkSink&) = delete;
    ChunkSink& operator=(const ChunkSink&) = delete;

    core::Result<void> write(std::span<const recording::Chunk> chunks,
                             std::span<const recording::SecondSummary> summaries) override {
        const bool nested =
            m_connection.inTransaction(); // inside a job's transaction, a savepoint undoes only our part
        CHIRON_TRY(nested ? m_connection.execute("SAVEPOINT chunks") : m_connection.begin());
        const std::int64_t before = m_next;
        auto done = store(chunks, summaries);
        if (done) {
            done = nested ? m_connection.execute("RELEASE chunks") : m_connection.commit();
        } else if (nested) {
            (void)m_connection.execute("ROLLBACK TO chunks; RELEASE chunks");
        } else {
            m_connection.rollback();
        }
        m_next = done ? m_next : before;
        return done;
    }

private:
    core::Result<void> store(std::span<const recording::Chunk> chunks,
                             std::span<const recording::SecondSummary> summaries) {
        for (const recording::Chunk& chunk : chunks) {
            CHIRON_TRY(storeChunk(chunk));
        }
        for (const recording::SecondSummary& summary : summaries) {
            CHIRON_TRY(storeSummary(summary));
        }
        return {};
    }

    core::Result<void> storeChunk(const recording::Chunk& chunk) {
        if (std::int64_t{chunk.sequence} != m_next) {
            return core::fail(core::ErrorCode::wrongUse, "chunk " + std::to_string(chunk.sequence) +
                                                             " of session " + std::to_string(m_session) +
                                                             ": expected " + std::to_string(m_next));
        }
        const auto last = selectInteger(m_connection, "SELECT max(id) FROM chunk");
        CHIRON_TRY(last);
        const auto row = insertRow(m_connection, "chunk",
                                   {{"id", last->value_or(0) + 1},
                                    {"session_id", m_session},
                                    {"sequence", m_next},
                                    {"first_tick", storedFromUnsigned(chunk.firstTick)},
                                    {"frames", std::int64_t{chunk.frames}},
                                    {"payload", chunk.payload},
                                    {"payload_hash", toBlob(bytesDigest(chunk.payload))},
                                    {"payload_digest", blobOf(chunk.payloadDigest)},
                                    {"force_hash", blobOf(chunk.forceHash)}});
        CHIRON_TRY(row);
        ++m_next;
        return {};
    }

    // A second that continues after a batch (or is drained again in recovery) replaces its earlier summary.
    core::Result<void> storeSummary(const recording::SecondSummary& s) {
        const std::vector<Column> key{
            {"session_id", m_session}, {"second", std::int64_t{s.second}}, {"tool", std::int64_t{s.tool}}};
        std::vector<Column> rest{
            {"frames", std::int64_t{s.frames}},    {"path_length_m", s.pathLength_m},
            {"maximum_force_n", s.maximumForce_N}, {"mean_force_n", s.meanForce_N},
            {"impulse_ns", s.impulse_Ns},          {"time_over_limit_s", s.timeOverLimit_s},
            {"events", std::int64_t{s.events}}};
        const auto known = selectInteger(
            m_connection, "SELECT 1 FROM second_summary WHERE session_id = ? AND second = ? AND tool = ?",
            {m_session, std::int64_t{s.second}, std::int64_t{s.tool}});
        CHIRON_TRY(known);
        if (!*known) {
            rest.insert(rest.begin(), key.begin(), key.end());
        }
        const auto row = *known ? updateRow(m_connection, "second_summary", key, std::move(rest))
                                : insertRow(m_connection, "second_summary", std::move(rest));
        CHIRON_TRY(row);
        return {};
    }

    Connection& m_connection;
    SessionId m_session;
    std::int64_t m_next;
};

} // namespace

core::Result<std::unique_ptr<recording::TrialSink>> makeChunkSink(Connection& connection, SessionId session) {
    const auto last =
        selectInteger(connection, "SELECT max(sequence) FROM chunk WHERE session_id = ?", {session});
    CHIRON_TRY(last);
    return std::make_unique<ChunkSink>(connection, session, last->value_or(-1) + 1);
}

} // namespace chiron::database
