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

/// One step of the schema migration.
struct Migration {
    int version = 0; ///< version after this step; steps follow one another from 1 without a gap
    std::string name;
    std::string sql;
};

/// Returns the compiled-in migrations (database/migrations/*.sql), in order.
std::vector<Migration> builtInMigrations();

/// The ids in a file's header.
struct SchemaVersion {
    int applicationId = 0;
    int version = 0;
};

/// Migrates files to the newest schema. Each step is one transaction; a file with data is copied first.
class MigrationRunner {
public:
    explicit MigrationRunner(std::vector<Migration> migrations = builtInMigrations())
        : m_migrations(std::move(migrations)) {}

    int newest() const noexcept { return m_migrations.empty() ? 0 : m_migrations.back().version; }

    /// Reads the header without changing the file, also if there is an unfinished write-ahead log.
    /// Errors: notFound; storage if it is not a SQLite file, damaged, not Chiron's, or newer than newest().
    core::Result<SchemaVersion> inspect(const std::string& file) const;

    /// Runs the missing steps. Returns the name of the copy that was made first ("<file>.before-v<N>"); empty
    /// if there was nothing to copy or to do. On failure the file is as it was before the failing step, and
    /// the copy remains.
    core::Result<std::string> migrate(Connection& connection) const;

    /// Called inside each step's transaction just before it commits; tests stop the program here.
    std::function<void()> beforeCommit;

private:
    core::Result<void> step(Connection& connection, const Migration& migration) const;
    std::vector<Migration> m_migrations;
};

/// Makes a consistent copy of the database in a new file (VACUUM INTO), flushed to the disk and checked by
/// SQLite. The copy needs no write-ahead log. On failure nothing of it remains.
/// Errors: badInput if the file exists; storage, also if it was interrupted because `cancel` was set.
core::Result<void> copyDatabase(Connection& from, const std::string& toFile,
                                const std::atomic<bool>* cancel = nullptr);

/// Restricts access to the file's owner (0600), because it contains names and results.
/// Errors: storage.
core::Result<void> keepPrivate(const std::string& file);

/// Flushes a file (or the entries of a folder) to the disk.
core::Result<void> flushToDisk(const std::string& path);

} // namespace chiron::database
