// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database_options.h"
#include "database/integrity/verifier.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::session {

/// One backup in a folder of backups, according to its manifest. The manifest is signed, but listing does not
/// check the signature.
struct BackupEntry {
    std::string folder;
    std::string createdUtc;
    std::uint64_t bytes = 0; ///< size of the database's copy
    bool automatic = false;  ///< made by the schedule
};

/// Lists the backups in `folder`, newest first; empty if the folder does not exist. Skips exports and
/// half-written backups. Blocks for a short time.
std::vector<BackupEntry> listBackups(const std::string& folder);

/// Checks whether a backup is unchanged: its signature, the digest of every file, and everything that verify
/// checks in a database, including scores. `databaseFile` names the site whose key signed the backup. Blocks
/// for a long time; call it on a worker.
database::VerifyReport verifyBackup(const std::string& folder, const std::string& databaseFile,
                                    const database::DatabaseOptions& options,
                                    const database::VerifyWatch& watch = {});

/// The short check of a backup: it is signed with this site's key, the digest of every file matches, and the
/// copy can be opened. Blocks; reads the files once.
core::Result<void> looksWhole(const std::string& folder, const std::string& databaseFile,
                              const database::DatabaseOptions& options);

/// "<databaseFile's folder>/backups": the folder for backups unless the user chooses another one.
std::string defaultBackupFolder(const std::string& databaseFile);

} // namespace chiron::session
