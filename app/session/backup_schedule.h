// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/upkeep.h"

#include <QDateTime>
#include <chrono>
#include <string>

namespace chiron::session {

/// Whether the day's backup is still to be made: one a calendar day, of the local time in `now`. A latest one of any other day, also of
/// a later one (the clock was set back), makes it due. Pure.
bool isBackupDue(const database::BackupStanding& standing, const QDateTime& now);

/// What came of looking after the day's backup.
struct DailyWork {
    bool due = false;
    core::Result<database::DailyBackup> made = core::fail(core::ErrorCode::cancelled, "nothing was due"); ///< where it was due
};

/// Makes the day's backup where it is due, as the program itself. Failure to read the plan counts as due. Blocking and long: a worker's
/// task.
DailyWork backUpIfDue(database::Database& database, const std::string& stationFolder, const std::atomic<bool>* cancel);

/// How long to wait after so many failures one after the other: a quarter of an hour, doubled up to four hours. Pure.
std::chrono::milliseconds waitAfterFailures(int failures) noexcept;

/// Where the plan's backups go: its folder, else the station's, else beside the database. Absolute.
std::string folderOfPlan(const database::BackupPlan& plan, const std::string& stationFolder, const std::string& databaseFile);

} // namespace chiron::session
