// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/boot_clock.h"

#include <memory>
#include <string>

class QSqlDatabase;
struct sqlite3;

namespace chiron::database {

class SiteKey;

/// One connection to a database. Repositories work on a connection; those that write need the writer's
/// (WriteContext). Settings: foreign_keys on, trusted_schema off, synchronous FULL, WAL.
/// Thread: used and destroyed on the thread that opened it.
class Connection {
public:
    enum class Mode { readOnly, readWrite };

    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection();

    /// Opens an existing file.
    /// Errors: storage, naming the file and SQLite's message.
    static core::Result<std::unique_ptr<Connection>> open(const std::string& file, Mode mode);
    /// Opens a file, creating it if it does not exist (new databases, snapshots); without WAL.
    static core::Result<std::unique_ptr<Connection>> create(const std::string& file);

    bool isWritable() const noexcept { return m_mode == Mode::readWrite; }
    const std::string& file() const noexcept { return m_file; }

    /// Runs SQL text with any number of statements that return no results.
    /// Errors: storage.
    core::Result<void> execute(const std::string& sql);
    core::Result<void> begin() { return execute("BEGIN IMMEDIATE"); }
    core::Result<void> commit();
    void rollback() noexcept;
    bool inTransaction() const noexcept;

    QSqlDatabase& qt() noexcept { return *m_database; }
    sqlite3* handle() noexcept { return m_handle; } ///< for backup and multi-statement text only

    /// Needed to append to the audit chain. The writer's connection has it.
    void setSite(const SiteKey* key, const IBootClock* clock) noexcept {
        m_siteKey = key;
        m_clock = clock;
    }
    const SiteKey* siteKey() const noexcept { return m_siteKey; }
    const IBootClock* clock() const noexcept { return m_clock; }

private:
    Connection(std::string file, Mode mode);
    core::Result<void> openQt(const std::string& connectOptions);
    core::Result<void> configure(bool useWal);

    std::string m_file;
    Mode m_mode;
    std::string m_name; ///< Qt's name of this connection
    std::unique_ptr<QSqlDatabase> m_database;
    sqlite3* m_handle = nullptr;
    const SiteKey* m_siteKey = nullptr;
    const IBootClock* m_clock = nullptr;
};

} // namespace chiron::database
