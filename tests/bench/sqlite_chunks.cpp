// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sqlite_chunks.h"

#include "bench/sqlite_rows.h"

#include <cstring>

namespace chiron::bench {

SqliteChunks::SqliteChunks(const std::filesystem::path& file, std::vector<std::uint8_t> table)
    : m_table(std::move(table)) {
    sqlite3_open(file.c_str(), &m_database);
    sqliteExec(
        m_database,
        "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA mmap_size=268435456;"
        "CREATE TABLE IF NOT EXISTS chunk(sequence INTEGER PRIMARY KEY, first_tick INTEGER, frames INTEGER,"
        " digest BLOB, force_hash BLOB, payload BLOB);"
        "CREATE TABLE IF NOT EXISTS second(tool INTEGER, second INTEGER, frames INTEGER, path REAL, maximum "
        "REAL,"
        " mean REAL, impulse REAL, over REAL, events INTEGER, PRIMARY KEY(tool, second)) WITHOUT ROWID");
    sqlite3_prepare_v2(m_database, "INSERT INTO chunk VALUES(?,?,?,?,?,?)", -1, &m_insert, nullptr);
    sqlite3_prepare_v2(m_database, "INSERT OR REPLACE INTO second VALUES(?,?,?,?,?,?,?,?,?)", -1, &m_summary,
                       nullptr);
    sqlite3_prepare_v2(m_database,
                       "SELECT first_tick, frames, digest, force_hash, payload FROM chunk WHERE sequence >= "
                       "? ORDER BY sequence",
                       -1, &m_select, nullptr);
}

SqliteChunks::~SqliteChunks() {
    for (sqlite3_stmt* statement : {m_insert, m_summary, m_select})
        sqlite3_finalize(statement);
    sqlite3_close(m_database);
}

core::Result<void> SqliteChunks::write(std::span<const recording::Chunk> chunks,
                                       std::span<const recording::SecondSummary> summaries) {
    sqliteExec(m_database, "BEGIN");
    for (const recording::Chunk& c : chunks) {
        sqlite3_bind_int64(m_insert, 1, c.sequence);
        sqlite3_bind_int64(m_insert, 2, static_cast<sqlite3_int64>(c.firstTick));
        sqlite3_bind_int64(m_insert, 3, c.frames);
        sqlite3_bind_blob(m_insert, 4, c.payloadDigest.data(), static_cast<int>(c.payloadDigest.size()),
                          SQLITE_STATIC);
        sqlite3_bind_blob(m_insert, 5, c.forceHash.data(), static_cast<int>(c.forceHash.size()),
                          SQLITE_STATIC);
        sqlite3_bind_blob(m_insert, 6, c.payload.data(), static_cast<int>(c.payload.size()), SQLITE_STATIC);
        sqlite3_step(m_insert);
        sqlite3_reset(m_insert);
    }
    for (const recording::SecondSummary& s : summaries) {
        sqlite3_bind_int64(m_summary, 1, s.tool);
        sqlite3_bind_int64(m_summary, 2, s.second);
        sqlite3_bind_int64(m_summary, 3, s.frames);
        sqlite3_bind_double(m_summary, 4, s.pathLength_m);
        sqlite3_bind_double(m_summary, 5, s.maximumForce_N);
        sqlite3_bind_double(m_summary, 6, s.meanForce_N);
        sqlite3_bind_double(m_summary, 7, s.impulse_Ns);
        sqlite3_bind_double(m_summary, 8, s.timeOverLimit_s);
        sqlite3_bind_int64(m_summary, 9, s.events);
        sqlite3_step(m_summary);
        sqlite3_reset(m_summary);
    }
    sqliteExec(m_database, "COMMIT");
    return {};
}

std::size_t SqliteChunks::chunkCount() const {
    sqlite3_stmt* count = nullptr;
    sqlite3_prepare_v2(m_database, "SELECT coalesce(max(sequence) + 1, 0) FROM chunk", -1, &count, nullptr);
    sqlite3_step(count);
    const auto chunks = static_cast<std::size_t>(sqlite3_column_int64(count, 0));
    sqlite3_finalize(count);
    return chunks;
}

core::Result<recording::Chunk> SqliteChunks::chunk(std::size_t sequence) {
    if (sequence != m_expected || sequence == 0) { // one after the other is one statement
        sqlite3_reset(m_select);
        sqlite3_bind_int64(m_select, 1, static_cast<sqlite3_int64>(sequence));
    }
    m_expected = sequence + 1;
    if (sqlite3_step(m_select) != SQLITE_ROW)
        return core::fail(core::ErrorCode::notFound, "chunk " + std::to_string(sequence));
    recording::Chunk c;
    c.sequence = static_cast<std::uint32_t>(sequence);
    c.firstTick = static_cast<std::uint64_t>(sqlite3_column_int64(m_select, 0));
    c.frames = static_cast<std::uint32_t>(sqlite3_column_int64(m_select, 1));
    std::memcpy(c.payloadDigest.data(), sqlite3_column_blob(m_select, 2), c.payloadDigest.size());
    std::memcpy(c.forceHash.data(), sqlite3_column_blob(m_select, 3), c.forceHash.size());
    const auto* bytes = static_cast<const std::uint8_t*>(sqlite3_column_blob(m_select, 4));
    c.payload.assign(bytes, bytes + sqlite3_column_bytes(m_select, 4));
    return c;
}

void SqliteChunks::finish() {
    sqliteExec(m_database, "PRAGMA wal_checkpoint(TRUNCATE)");
}

} // namespace chiron::bench
