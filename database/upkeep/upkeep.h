// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"

#include <atomic>
#include <string>

namespace chiron::database {

/// Describes a backup or an export (manifest.json in its folder).
struct SnapshotInfo {
    std::string folder;
    std::string databaseFile; ///< inside the folder
    std::string blake2b;      ///< of that file, 64 hex digits
    std::int64_t auditCount = 0;
    std::string auditHash;
    std::uint64_t bytes = 0;
};

/// The backup settings of a site; stored with the site.
struct BackupPlan {
    bool on = true;
    std::string folder{}; ///< empty: the default folder of the station
    /// Number of scheduled backups to keep; older scheduled ones are removed, others never.
    int keep = 14;
    bool operator==(const BackupPlan&) const = default;
};
inline constexpr int kMostBackupsKept = 999;

/// The plan, and how the latest scheduled attempt ended.
struct BackupStanding {
    BackupPlan plan;
    std::string triedUtc{}; ///< of the latest attempt; empty: none yet
    std::string problem{};  ///< why that attempt failed; empty: it is complete and verified
    std::string goodUtc{};  ///< of the latest successful one; empty: none yet
    std::string goodFolder{};
    std::uint64_t goodBytes = 0;
};

struct DailyBackup {
    SnapshotInfo made;
    int removed = 0; ///< number of older scheduled backups that were removed
};

struct RestoreRequest {
    std::string backupFolder;
    std::string targetFile;
    std::string name; ///< an administrator of the backup
    std::string password;
    std::string siteKeyFile; ///< copied if the target has no site key yet; empty: there must be one
    /// An administrator of the database that is now at targetFile; empty: the same name and password as for
    /// the backup.
    std::string presentName{};
    std::string presentPassword{};
};

struct RestoreInfo {
    std::string databaseFile;
    std::string keptOldFile; ///< new path of the file that was replaced; empty if there was none
    int erasuresApplied = 0;
};

/// Storage upkeep. Each result is verified after writing. Every function uses connections of its own.
/// Thread: a worker; blocks, and takes long.
class Upkeep {
public:
    /// Makes a consistent snapshot beside the running writer, with manifest, audit head and list of erasures,
    /// in a new folder. It is either complete or absent, because it is written under another name and then
    /// renamed.
    /// Errors: badInput if the folder exists; cancelled if `cancel` was set meanwhile, in which case nothing
    /// remains.
    static core::Result<SnapshotInfo> backup(Database& database, const Actor& actor,
                                             const std::string& folder,
                                             const std::atomic<bool>* cancel = nullptr);

    /// Returns the site's plan and its standing. A site without a plan has the default one, which is off for
    /// a demonstration.
    static core::Result<BackupStanding> backupStanding(Connection& connection, const Actor& actor);
    /// Stores the plan, in a writer's job.
    /// Errors: badInput if `keep` is not 1 to kMostBackupsKept.
    static core::Result<void> setBackupPlan(Connection& connection, const Actor& actor,
                                            const BackupPlan& plan);
    /// Makes the scheduled backup in a new folder in `place`, with a generated name, and reads it back. Then
    /// it removes the schedule's own older backups beyond `keep`, and leftovers of a killed backup. The
    /// outcome, also a failure (except cancelled), is recorded in the site.
    /// Errors: as backup; storage, before anything is written, if `place` has too little space.
    static core::Result<DailyBackup> dailyBackup(Database& database, const Actor& actor,
                                                 const std::string& place, int keep,
                                                 const std::atomic<bool>* cancel = nullptr);

    /// Puts a verified backup in place, applies all erasures made since, and keeps the old file. It needs the
    /// target's writer lock, an administrator of the backup, and one of the database that is replaced, if
    /// that can be read and has one.
    static core::Result<RestoreInfo> restore(const RestoreRequest& request,
                                             const DatabaseOptions& options = {});

    /// Exports a backup and every table as JSON Lines (blobs as hex; no credentials), with a manifest of
    /// digests.
    static core::Result<SnapshotInfo> exportSite(Database& database, const Actor& actor,
                                                 const std::string& folder,
                                                 const std::atomic<bool>* cancel = nullptr);
};

} // namespace chiron::database
