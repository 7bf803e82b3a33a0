// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sample_rows.h"

#include "bench/sqlite_rows.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::bench {

SampleRows::SampleRows(const std::filesystem::path& file, const std::vector<Sample>& samples) : m_file(file) {
    std::filesystem::remove(m_file);
    sqlite3_open(file.c_str(), &m_database);
    sqliteExec(m_database, "PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA mmap_size=1073741824");
    std::string create = "CREATE TABLE sample(tick INTEGER PRIMARY KEY, paused INTEGER",
                insert = "INSERT INTO sample VALUES(?,?";
    for (std::size_t i = 0; i < kRowChannels; ++i) {
        create += ", c" + std::to_string(i) + " REAL";
        insert += ",?";
    }
    sqliteExec(m_database, (create + ")").c_str());
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(m_database, (insert + ")").c_str(), -1, &statement, nullptr);
    sqliteExec(m_database, "BEGIN");
    for (const Sample& sample : samples) {
        auto row = rowOf(sample.frame);
        for (int i = 0; i < 3; ++i)
            row[static_cast<std::size_t>(2 + i)] = sample.p_WT_m[i];
        sqlite3_bind_int64(statement, 1, static_cast<sqlite3_int64>(sample.frame.header.index));
        sqlite3_bind_int(statement, 2, sample.frame.header.paused);
        for (std::size_t i = 0; i < row.size(); ++i)
            sqlite3_bind_double(statement, static_cast<int>(i) + 3, row[i]);
        sqlite3_step(statement);
        sqlite3_reset(statement);
    }
    sqliteExec(m_database, "COMMIT");
    sqlite3_finalize(statement);
}

SampleRows::~SampleRows() {
    sqlite3_close(m_database);
    std::error_code ignored; // a file left behind is all that can happen
    std::filesystem::remove(m_file, ignored);
}

Totals SampleRows::ask() {
    sqlite3_stmt* select = nullptr;
    sqlite3_prepare_v2(m_database, "SELECT c2, c3, c4, c6, c7, c8 FROM sample WHERE paused = 0 ORDER BY tick",
                       -1, &select, nullptr);
    Totals totals;
    core::Vec3 last = core::Vec3::Zero();
    bool hasLast = false;
    double peak2 = 0.0;
    while (sqlite3_step(select) == SQLITE_ROW) {
        const core::Vec3 p(sqlite3_column_double(select, 0), sqlite3_column_double(select, 1),
                           sqlite3_column_double(select, 2));
        const core::Vec3 f(sqlite3_column_double(select, 3), sqlite3_column_double(select, 4),
                           sqlite3_column_double(select, 5));
        peak2 = std::max(peak2, f.squaredNorm());
        if (hasLast)
            totals.path_m += (p - last).norm();
        last = p;
        hasLast = true;
    }
    sqlite3_finalize(select);
    totals.peakForce_N = std::sqrt(peak2);
    return totals;
}

} // namespace chiron::bench
