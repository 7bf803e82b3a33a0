// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/backup_schedule.h"

#include "session/backup_list.h"

#include <algorithm>

namespace chiron::session {

bool isBackupDue(const database::BackupStanding& standing, const QDateTime& now) {
    if (!standing.plan.on)
        return false;
    const QDateTime good = QDateTime::fromString(QString::fromStdString(standing.goodUtc), Qt::ISODateWithMs);
    return !good.isValid() || good.toTimeZone(now.timeZone()).date() != now.date();
}

DailyWork backUpIfDue(database::Database& database, const std::string& stationFolder,
                      const std::atomic<bool>* cancel) {
    const database::Actor program = database::Actor::maintenance();
    const auto reader = database.openReader();
    const auto standing =
        reader ? database::Upkeep::backupStanding(**reader, program) : tl::unexpected(reader.error());
    if (!standing)
        return {true, tl::unexpected(standing.error())};
    if (!isBackupDue(*standing, QDateTime::currentDateTime()))
        return {};
    const std::string folder = folderOfPlan(standing->plan, stationFolder, database.file());
    return {true, database::Upkeep::dailyBackup(database, program, folder, standing->plan.keep, cancel)};
}

std::chrono::milliseconds waitAfterFailures(int failures) noexcept {
    using namespace std::chrono_literals;
    constexpr int kMostDoublings = 4;
    return failures <= 0 ? 0min : 15min * (1 << std::min(failures - 1, kMostDoublings));
}

std::string folderOfPlan(const database::BackupPlan& plan, const std::string& stationFolder,
                         const std::string& databaseFile) {
    if (!plan.folder.empty())
        return plan.folder;
    return stationFolder.empty() ? defaultBackupFolder(databaseFile) : stationFolder;
}

} // namespace chiron::session
