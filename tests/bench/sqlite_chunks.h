// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/trial_sink.h"

#include <filesystem>
#include <sqlite3.h>
#include <vector>

namespace chiron::bench {

/// Ours on the same ground as the rows: chunks and summaries in SQLite, a transaction a batch, WAL and
/// synchronous=FULL, plain C API.
class SqliteChunks final : public recording::TrialSink, public recording::ChunkSource {
public:
    SqliteChunks(const std::filesystem::path& file, std::vector<std::uint8_t> table);
    SqliteChunks(const SqliteChunks&) = delete;
    SqliteChunks& operator=(const SqliteChunks&) = delete;
    ~SqliteChunks() override;

    core::Result<void> write(std::span<const recording::Chunk> chunks,
                             std::span<const recording::SecondSummary> summaries) override;
    core::Result<std::vector<std::uint8_t>> channelTable() override { return m_table; }
    std::size_t chunkCount() const override;
    core::Result<recording::Chunk> chunk(std::size_t sequence) override;
    void finish();

private:
    sqlite3* m_database = nullptr;
    sqlite3_stmt* m_insert = nullptr;
    sqlite3_stmt* m_summary = nullptr;
    sqlite3_stmt* m_select = nullptr;
    std::size_t m_expected = 0; ///< sequence of the row that the next step of m_select gives
    std::vector<std::uint8_t> m_table;
};

} // namespace chiron::bench
