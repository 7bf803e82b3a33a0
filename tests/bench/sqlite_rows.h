// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <array>
#include <filesystem>
#include <sqlite3.h>
#include <vector>

namespace chiron::bench {

inline constexpr std::size_t kRowChannels = 24;
/// One frame as 24 numbers: clock and device time (s), four coordinates (m, rad), three wrenches of
/// six components (N, N·m).
std::array<double, kRowChannels> rowOf(const core::HapticFrame& frame);

/// The peer: one SQLite row of 24 REAL columns a sample, prepared statements, a transaction a second, WAL and
/// synchronous=FULL as the product's own database.
class SqliteRows {
public:
    explicit SqliteRows(const std::filesystem::path& file);
    SqliteRows(const SqliteRows&) = delete;
    SqliteRows& operator=(const SqliteRows&) = delete;
    ~SqliteRows();

    void append(const core::HapticFrame& frame); ///< begins and commits by itself
    void finish();
    double readSpan(std::uint64_t firstTick,
                    std::uint64_t frames); ///< all columns; returns a sum, so that it is done
    double scanOne();                      ///< tissue fz over the whole table; sum

private:
    sqlite3* m_database = nullptr;
    sqlite3_stmt* m_insert = nullptr;
    std::uint64_t m_rows = 0;
};

void sqliteExec(sqlite3* database, const char* sql);

} // namespace chiron::bench
