// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/storage_words.h"

#include "desktop/sessions/session_words.h"

namespace chiron::desktop {

using session::RoomState;

namespace {
constexpr int kOldBackup_days = 7; // assumption: a training site loses at most a week's work by hand-copying
}

StorageNotice StorageWords::room(const session::StorageRoom& room, const QLocale& locale) {
    const QString free = SessionWords::bytes(room.diskFree_bytes, locale);
    const RoomState disk = session::diskState(room);
    const RoomState ring = session::ringState(room);
    if (disk == RoomState::none)
        return {"bad", tr("The disk is full: %1 are free. Sessions may not be stored. Make room before anybody trains.").arg(free)};
    if (ring == RoomState::none)
        return {"bad", tr("There is no room for the safety copy of a running session (%1 needed, %2 free in memory). Sessions will be "
                          "refused. Close other programs.")
                           .arg(SessionWords::bytes(room.ringNeeded_bytes, locale), SessionWords::bytes(room.ringFree_bytes, locale))};
    if (disk == RoomState::low)
        return {"warning", tr("The disk is getting full: %1 are free. Sessions can still be recorded. Make room, or move backups to another "
                              "disk.")
                               .arg(free)};
    if (ring == RoomState::low)
        return {"warning", tr("Memory for the safety copy of running sessions is getting short: %1 are free.")
                               .arg(SessionWords::bytes(room.ringFree_bytes, locale))};
    return {"good", tr("There is room: %1 are free.").arg(free)};
}

StorageNotice StorageWords::backup(const std::string& latestUtc, const QDateTime& now, const QLocale& locale) {
    const QDateTime latest = SessionWords::timeOf(latestUtc);
    if (!latest.isValid())
        return {"warning", tr("There is no backup yet. What is recorded exists only once.")};
    const QString age = SessionWords::ago(latest, now, locale);
    if (latest.daysTo(now) > kOldBackup_days)
        return {"warning", tr("The last backup was made %1. Make a new one.").arg(age)};
    return {"good", tr("The last backup was made %1.").arg(age)};
}

QString StorageWords::findingKind(const std::string& kind) {
    if (kind == "file" || kind == "database" || kind == "integrity" || kind == "foreign_key")
        return tr("The file is damaged");
    if (kind == "digest")
        return tr("A record was changed");
    if (kind == "payload")
        return tr("Recorded data was changed");
    if (kind == "missing")
        return tr("Something is missing");
    if (kind == "unreadable")
        return tr("It cannot be read");
    if (kind == "seal")
        return tr("A session is not as it ended");
    if (kind == "audit")
        return tr("The audit trail does not hold");
    if (kind == "score")
        return tr("A score does not follow from its recording");
    return tr("Something does not hold");
}

StorageNotice StorageWords::verified(const database::VerifyReport& report, const QLocale& locale) {
    const QString rows = locale.toString(static_cast<qulonglong>(report.rowsChecked));
    if (!report.findings.empty())
        return {"bad", tr("%n thing(s) do not hold. Nothing was changed. Keep this database as it is and restore a backup that verifies.",
                          nullptr, static_cast<int>(report.findings.size()))};
    if (report.cancelled)
        return {"warning", tr("The check was stopped after %1 records. Nothing wrong was found until then.").arg(rows)};
    return {"good", tr("Everything holds: %1 records, every recording, every score, the audit trail.").arg(rows)};
}

} // namespace chiron::desktop
