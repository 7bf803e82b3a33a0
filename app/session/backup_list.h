// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database_options.h"
#include "database/integrity/verifier.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::session {

/// One backup in a folder of backups, as its manifest tells (which is signed, but not checked by listing it).
struct BackupEntry {
    std::string folder;
    std::string createdUtc;
    std::uint64_t bytes = 0; ///< of the database's copy
    bool automatic = false;  ///< the schedule made it
};

/// The backups in `folder`, newest first; none where the folder is not there. Exports and half-written ones are left out.
/// Blocking, short.
std::vector<BackupEntry> listBackups(const std::string& folder);

/// Whether a backup still is what was written: signature, every file's digest, then everything that verify checks in a
/// database, scores too. `databaseFile` names the site whose key signed it. Blocking and long: a worker's task.
database::VerifyReport verifyBackup(const std::string& folder, const std::string& databaseFile,
                                    const database::DatabaseOptions& options, const database::VerifyWatch& watch = {});

/// The short check of a backup: signed with this site's key, every file's digest, and the copy opens. Blocking; reads the files once.
core::Result<void> looksWhole(const std::string& folder, const std::string& databaseFile, const database::DatabaseOptions& options);

/// "<databaseFile's folder>/backups": where backups go unless somebody chooses another place.
std::string defaultBackupFolder(const std::string& databaseFile);

} // namespace chiron::session
