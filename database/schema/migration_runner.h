// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace chiron::database {

inline constexpr int kApplicationId = 0x43484952; ///< "CHIR"

/// One step of the schema.
struct Migration {
    int version = 0; ///< what the file has afterwards; steps follow on without a gap from 1
    std::string name;
    std::string sql;
};

/// Those compiled in (database/migrations/*.sql), in order.
std::vector<Migration> builtInMigrations();

/// What stands in a file's header.
struct SchemaVersion {
    int applicationId = 0;
    int version = 0;
};

/// Brings files to the newest schema. Each step is one transaction; a file with data is copied first.
class MigrationRunner {
public:
    explicit MigrationRunner(std::vector<Migration> migrations = builtInMigrations())
        : m_migrations(std::move(migrations)) {}

    int newest() const noexcept { return m_migrations.empty() ? 0 : m_migrations.back().version; }

    /// Reads the header without changing the file, also past an unfinished write-ahead log. Failure:
    /// notFound; storage if it is no SQLite file, damaged, not Chiron's, or newer than newest().
    core::Result<SchemaVersion> inspect(const std::string& file) const;

    /// Runs what is missing. Returns the copy made first ("<file>.before-v<N>"), empty where there was
    /// nothing to copy or to do. On failure the file is as it was before the failing step, and the copy
    /// stays.
    core::Result<std::string> migrate(Connection& connection) const;

    /// Called inside each step's transaction just before it commits; tests stop the program here.
    std::function<void()> beforeCommit;

private:
    core::Result<void> step(Connection& connection, const Migration& migration) const;
    std::vector<Migration> m_migrations;
};

/// A consistent copy of the database as a new file (VACUUM INTO), flushed to the disk, checked by SQLite. The
/// copy needs no write-ahead log. On failure nothing is left of it. Failure: badInput if the file exists,
/// storage, also when it broke off because `cancel` was set.
core::Result<void> copyDatabase(Connection& from, const std::string& toFile, const std::atomic<bool>* cancel = nullptr);

/// Lets the file's owner alone read and write it (0600): it holds names and results. Failure: storage.
core::Result<void> keepPrivate(const std::string& file);

/// Flushes a file (or the entries of a folder) to the disk.
core::Result<void> flushToDisk(const std::string& path);

} // namespace chiron::database
