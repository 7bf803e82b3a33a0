// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/integrity/verifier.h"
#include "database/upkeep/upkeep.h"
#include "session/storage_room.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QString>
#include <string>

namespace chiron::desktop {

/// An assessment as text, with the kind of notice that shows it ("good", "warning", "bad").
struct StorageNotice {
    const char* kind;
    QString text;
    bool isGood() const { return QLatin1String(kind) == QLatin1String("good"); }
};

/// Texts on the state of the storage, translated.
/// Thread: GUI.
class StorageWords {
    Q_DECLARE_TR_FUNCTIONS(StorageWords)
public:
    /// Disk and ring folder together; the worse of the two counts.
    static StorageNotice room(const session::StorageRoom& room, const QLocale& locale);
    /// A warning if the latest backup is older than a week or there is none.
    static StorageNotice backup(const std::string& latestUtc, const QDateTime& now, const QLocale& locale);
    /// Result and time of the schedule's latest attempt.
    static StorageNotice automatic(const database::BackupStanding& standing, const QDateTime& now,
                                   const QLocale& locale);
    static StorageNotice sameDisk(); ///< backups lie on the same disk as the original
    static QString findingKind(const std::string& kind);
    static StorageNotice verified(const database::VerifyReport& report, const QLocale& locale);
};

} // namespace chiron::desktop
