// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/storage_words.h"

#include "desktop/sessions/session_words.h"

namespace chiron::desktop {

using session::RoomState;

namespace {
constexpr int kOldBackup_days = 7; // assumption: a training site can redo at most one week's work by hand
}

StorageNotice StorageWords::room(const session::StorageRoom& room, const QLocale& locale) {
    const QString free = SessionWords::bytes(room.diskFree_bytes, locale);
    const RoomState disk = session::diskState(room);
    const RoomState ring = session::ringState(room);
    if (disk == RoomState::none)
        return {"bad", tr("The disk is full: only %1 is free. Sessions might not be saved. Free up space "
                          "before anybody trains.")
                           .arg(free)};
    if (ring == RoomState::none)
        return {"bad", tr("There is no room for the safety copy of a running session (%1 needed, %2 free in "
                          "memory). Sessions cannot "
                          "start. Close other programs.")
                           .arg(SessionWords::bytes(room.ringNeeded_bytes, locale),
                                SessionWords::bytes(room.ringFree_bytes, locale))};
    if (disk == RoomState::low)
        return {"warning", tr("The disk is getting full: %1 is free. Sessions can still be recorded. Free up "
                              "space, or move backups to "
                              "another disk.")
                               .arg(free)};
    if (ring == RoomState::low)
        return {"warning", tr("Memory for the safety copy of running sessions is running low: %1 is free.")
                               .arg(SessionWords::bytes(room.ringFree_bytes, locale))};
    return {"good", tr("There is enough room: %1 is free.").arg(free)};
}

StorageNotice StorageWords::backup(const std::string& latestUtc, const QDateTime& now,
                                   const QLocale& locale) {
    const QDateTime latest = SessionWords::timeOf(latestUtc);
    if (!latest.isValid())
        return {"warning", tr("There is no backup yet. What is recorded exists only once.")};
    const QString age = SessionWords::ago(latest, now, locale);
    if (latest.daysTo(now) > kOldBackup_days)
        return {"warning", tr("The last backup was made %1. Make a new one.").arg(age)};
    return {"good", tr("The last backup was made %1.").arg(age)};
}

StorageNotice StorageWords::automatic(const database::BackupStanding& standing, const QDateTime& now,
                                      const QLocale& locale) {
    if (!standing.plan.on)
        return {
            "warning",
            tr("Automatic backups are off. Only backups that you make yourself protect what is recorded.")};
    if (!standing.problem.empty())
        return {"bad", tr("An automatic backup failed %1. It will be tried again; in the meantime, make one "
                          "yourself.\nDetails: %2")
                           .arg(SessionWords::ago(SessionWords::timeOf(standing.triedUtc), now, locale),
                                QString::fromStdString(standing.problem))};
    const QDateTime good = SessionWords::timeOf(standing.goodUtc);
    if (!good.isValid())
        return {"info", tr("The first automatic backup is made when nobody has used the program for a few "
                           "minutes, or when it closes.")};
    return {"good", tr("The latest automatic backup was made and checked on %1 (%2).")
                        .arg(locale.toString(good.toLocalTime(), QLocale::ShortFormat),
                             SessionWords::bytes(standing.goodBytes, locale))};
}

StorageNotice StorageWords::sameDisk() {
    return {"warning", tr("The backups are on the same disk as the site: if that disk fails, both are lost. "
                          "Choose a folder on another disk, on a "
                          "USB drive or on the network.")};
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
        return tr("A session was changed after it ended");
    if (kind == "audit")
        return tr("The audit trail is not intact");
    if (kind == "score")
        return tr("A score does not match its recording");
    return tr("Something is wrong");
}

StorageNotice StorageWords::verified(const database::VerifyReport& report, const QLocale& locale) {
    const QString rows = locale.toString(static_cast<qulonglong>(report.rowsChecked));
    if (!report.findings.empty())
        return {"bad", tr("The check found %n error(s). Nothing was changed. Keep this database as it is and "
                          "restore a backup that passes "
                          "the check.",
                          nullptr, static_cast<int>(report.findings.size()))};
    if (report.cancelled)
        return {"warning",
                tr("The check was stopped after %1 records. It had found no errors until then.").arg(rows)};
    return {
        "good",
        tr("No errors were found: %1 records, every recording, every score and the audit trail were checked.")
            .arg(rows)};
}

} // namespace chiron::desktop
