// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/upkeep.h"

#include <QDateTime>
#include <chrono>
#include <string>

namespace chiron::session {

/// True if the backup of the day is still missing: there is one per calendar day of the local time in `now`.
/// If the latest backup is from any other day, even a later one (the clock was set back), a new one is due.
/// Pure function.
bool isBackupDue(const database::BackupStanding& standing, const QDateTime& now);

/// The result of the check for the day's backup.
struct DailyWork {
    bool due = false;
    /// Valid if a backup was due.
    core::Result<database::DailyBackup> made = core::fail(core::ErrorCode::cancelled, "nothing was due");
};

/// Makes the day's backup if it is due, on behalf of the program itself. If the plan cannot be read, the
/// backup counts as due. Blocks for a long time; call it on a worker.
DailyWork backUpIfDue(database::Database& database, const std::string& stationFolder,
                      const std::atomic<bool>* cancel);

/// The waiting time after a number of consecutive failures: a quarter of an hour, doubled for each failure up
/// to four hours. Pure function.
std::chrono::milliseconds waitAfterFailures(int failures) noexcept;

/// The folder of the plan's backups: the plan's own, else the station's, else one beside the database.
/// Absolute path.
std::string folderOfPlan(const database::BackupPlan& plan, const std::string& stationFolder,
                         const std::string& databaseFile);

} // namespace chiron::session
