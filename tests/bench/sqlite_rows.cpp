// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sqlite_rows.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace chiron::bench {

void sqliteExec(sqlite3* database, const char* sql) {
    if (sqlite3_exec(database, sql, nullptr, nullptr, nullptr) == SQLITE_OK)
        return;
    std::fprintf(stderr, "%s: %s\n", sql, sqlite3_errmsg(database));
    std::exit(1);
}

std::array<double, kRowChannels> rowOf(const core::HapticFrame& frame) {
    const core::ToolFrame& tool = frame.tool[0];
    std::array<double, kRowChannels> row{1e-9 * static_cast<double>(frame.header.now_ns),
                                         1e-6 * static_cast<double>(tool.deviceTime_us),
                                         1e-5 * tool.counts[0],
                                         1e-5 * tool.counts[1],
                                         1e-5 * tool.counts[2],
                                         1e-4 * tool.counts[3]};
    for (std::size_t i = 0; i < 6; ++i) {
        row[6 + i] = tool.tissue[i];
        row[12 + i] = tool.commanded[i];
        row[18 + i] = tool.measured[i];
    }
    return row;
}

SqliteRows::SqliteRows(const std::filesystem::path& file) {
    sqlite3_open(file.c_str(), &m_database);
    sqliteExec(m_database, "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA mmap_size=268435456");
    std::string create = "CREATE TABLE IF NOT EXISTS sample(tick INTEGER PRIMARY KEY";
    std::string insert = "INSERT INTO sample VALUES(?";
    for (std::size_t i = 0; i < kRowChannels; ++i) {
        create += ", c" + std::to_string(i) + " REAL";
        insert += ",?";
    }
    sqliteExec(m_database, (create + ")").c_str());
    sqlite3_prepare_v2(m_database, (insert + ")").c_str(), -1, &m_insert, nullptr);
}

SqliteRows::~SqliteRows() {
    sqlite3_finalize(m_insert);
    sqlite3_close(m_database);
}

void SqliteRows::append(const core::HapticFrame& frame) {
    if (m_rows % 1000 == 0)
        sqliteExec(m_database, "BEGIN");
    sqlite3_bind_int64(m_insert, 1, static_cast<sqlite3_int64>(frame.header.index));
    const auto row = rowOf(frame);
    for (std::size_t i = 0; i < row.size(); ++i)
        sqlite3_bind_double(m_insert, static_cast<int>(i) + 2, row[i]);
    sqlite3_step(m_insert);
    sqlite3_reset(m_insert);
    if (++m_rows % 1000 == 0)
        sqliteExec(m_database, "COMMIT");
}

void SqliteRows::finish() {
    if (m_rows % 1000 != 0)
        sqliteExec(m_database, "COMMIT");
    sqliteExec(m_database, "PRAGMA wal_checkpoint(TRUNCATE)");
}

double SqliteRows::readSpan(std::uint64_t firstTick, std::uint64_t frames) {
    sqlite3_stmt* select = nullptr;
    sqlite3_prepare_v2(m_database, "SELECT * FROM sample WHERE tick >= ? ORDER BY tick LIMIT ?", -1, &select,
                       nullptr);
    sqlite3_bind_int64(select, 1, static_cast<sqlite3_int64>(firstTick));
    sqlite3_bind_int64(select, 2, static_cast<sqlite3_int64>(frames));
    double sum = 0.0;
    while (sqlite3_step(select) == SQLITE_ROW)
        for (int i = 0; i < static_cast<int>(kRowChannels); ++i)
            sum += sqlite3_column_double(select, i + 1);
    sqlite3_finalize(select);
    return sum;
}

double SqliteRows::scanOne() {
    sqlite3_stmt* select = nullptr;
    sqlite3_prepare_v2(m_database, "SELECT c8 FROM sample ORDER BY tick", -1, &select, nullptr);
    double sum = 0.0;
    while (sqlite3_step(select) == SQLITE_ROW)
        sum += sqlite3_column_double(select, 0);
    sqlite3_finalize(select);
    return sum;
}

} // namespace chiron::bench
