// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/database.h"

#include <atomic>
#include <string>

namespace chiron::database {

/// What a backup or an export says about itself (manifest.json in its folder).
struct SnapshotInfo {
    std::string folder;
    std::string databaseFile; ///< inside the folder
    std::string blake2b;      ///< of that file, 64 hex digits
    std::int64_t auditCount = 0;
    std::string auditHash;
    std::uint64_t bytes = 0;
};

/// How a site backs itself up; stored with the site.
struct BackupPlan {
    bool on = true;
    std::string folder{}; ///< empty: wherever the station keeps its backups
    int keep = 14;        ///< so many that the schedule made; older ones of its own are removed, others never
    bool operator==(const BackupPlan&) const = default;
};
inline constexpr int kMostBackupsKept = 999;

/// The plan, and how the latest attempt of the schedule ended.
struct BackupStanding {
    BackupPlan plan;
    std::string triedUtc{};     ///< of the latest attempt; empty: there was none yet
    std::string problem{};      ///< why that one failed; empty: it is whole and verified
    std::string goodUtc{};      ///< of the latest that succeeded; empty: none yet
    std::string goodFolder{};
    std::uint64_t goodBytes = 0;
};

struct DailyBackup {
    SnapshotInfo made;
    int removed = 0; ///< older ones of the schedule
};

struct RestoreRequest {
    std::string backupFolder;
    std::string targetFile;
    std::string name; ///< an administrator of the backup
    std::string password;
    std::string siteKeyFile; ///< copied where the target has no site key yet; empty: there must be one
    /// An administrator of the database that stands at targetFile now; empty: the same name and password.
    std::string presentName{};
    std::string presentPassword{};
};

struct RestoreInfo {
    std::string databaseFile;
    std::string keptOldFile; ///< where the file that stood there is now; empty if there was none
    int erasuresApplied = 0;
};

/// Storage upkeep, each verified after writing. Blocking and long: a worker's task, on connections of its
/// own.
class Upkeep {
public:
    /// A consistent snapshot beside the running writer, with manifest, audit head and list of erasures, in a
    /// new folder (badInput if it exists). Complete or not there: it is written under another name and
    /// renamed. Failure: cancelled, when `cancel` was set meanwhile; nothing is left behind then.
    static core::Result<SnapshotInfo> backup(Database& database, const Actor& actor,
                                             const std::string& folder,
                                             const std::atomic<bool>* cancel = nullptr);

    /// What the site's plan is and how it goes. On a site that has none yet: the default, off for a demonstration.
    static core::Result<BackupStanding> backupStanding(Connection& connection, const Actor& actor);
    /// In a writer's job. Failure: badInput where `keep` is not 1 to kMostBackupsKept.
    static core::Result<void> setBackupPlan(Connection& connection, const Actor& actor, const BackupPlan& plan);
    /// The schedule's backup: into a new folder of its own name in `place`, read back after it is written; then the schedule's
    /// own older ones beyond `keep` are removed, and what a killed one left. The outcome is noted in the site, also of a failure
    /// (but for cancelled). Failure: as backup; storage before anything is written where `place` has too little room.
    static core::Result<DailyBackup> dailyBackup(Database& database, const Actor& actor, const std::string& place, int keep,
                                                 const std::atomic<bool>* cancel = nullptr);

    /// Puts a verified backup in place, erases again what was erased since, keeps the old file aside. Needs
    /// the target's writer lock, an administrator of the backup, and one of the database that is replaced,
    /// where that can be read and has one.
    static core::Result<RestoreInfo> restore(const RestoreRequest& request,
                                             const DatabaseOptions& options = {});

    /// A backup and every table as JSON Lines (blobs as hex; no credentials), with a manifest of digests.
    static core::Result<SnapshotInfo> exportSite(Database& database, const Actor& actor,
                                                 const std::string& folder,
                                                 const std::atomic<bool>* cancel = nullptr);
};

} // namespace chiron::database
