// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/database_options.h"
#include "database/writer_thread.h"

#include <memory>
#include <string>

class QLockFile;

namespace chiron::database {

class SiteKey;

/// One database file. It needs a QCoreApplication, because Qt loads the SQLite driver as a plugin. Opened for
/// writing, it holds "<database>.lock" and owns the writer thread with the only read-write connection. Opened
/// read-only, it works beside a writer in this or another process, and never checkpoints.
/// Thread: any, except for construction and destruction; blocks.
class Database {
public:
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;
    ~Database(); ///< the writer drains its sources, runs the queued jobs, and closes

    /// Creates a new file with schema, site key and the simulated account, and opens it for writing.
    /// Errors: badInput if the file exists (it is not changed); locked; storage.
    static core::Result<std::unique_ptr<Database>> create(const std::string& file,
                                                          const DatabaseOptions& options = {});

    /// Opens an existing file; an older one is migrated, after a backup.
    /// Errors: locked within 1 s, naming program and pid; notFound; storage if it is damaged, foreign, or
    /// newer than this program (it is left unchanged, byte for byte).
    static core::Result<std::unique_ptr<Database>> openForWriting(const std::string& file,
                                                                  const DatabaseOptions& options = {});

    /// Opens an existing file of this version; it never waits for the writer.
    /// Errors: as openForWriting, but never locked.
    static core::Result<std::unique_ptr<Database>> openReadOnly(const std::string& file,
                                                                const DatabaseOptions& options = {});

    /// Opens a new read-only connection for the calling thread, which has to use and destroy it.
    core::Result<std::unique_ptr<Connection>> openReader() const;

    bool isWritable() const noexcept { return m_writer != nullptr; }
    /// Runs a job on the writer thread in one transaction and waits for it.
    /// Errors: wrongUse if opened read-only; the job's own error (everything it did is undone); storage if
    /// the commit fails.
    template <class F> auto write(F&& job) -> std::invoke_result_t<F, WriteContext&> {
        if (!m_writer) {
            return core::fail(core::ErrorCode::wrongUse, m_file + ": opened read-only, cannot write");
        }
        return m_writer->run(std::forward<F>(job));
    }
    WriterThread& writer() noexcept { return *m_writer; } ///< only when isWritable()

    const std::string& file() const noexcept { return m_file; }
    const std::string& siteFolder() const noexcept { return m_siteFolder; }
    const DatabaseOptions& options() const noexcept { return m_options; }
    int schemaVersion() const noexcept { return m_schemaVersion; }
    const std::string& uuid() const noexcept { return m_uuid; } ///< the header of the crash ring contains it
    bool isDemonstration() const noexcept { return m_demonstration; }

private:
    Database(std::string file, DatabaseOptions options);
    core::Result<void> readIdentity();
    core::Result<void> startWriter();

    std::string m_file;
    DatabaseOptions m_options;
    std::string m_siteFolder;
    int m_schemaVersion = 0;
    std::string m_uuid;
    bool m_demonstration = false;
    std::unique_ptr<QLockFile> m_lock;
    std::unique_ptr<SiteKey> m_siteKey;
    std::unique_ptr<WriterThread> m_writer;
};

} // namespace chiron::database
