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

/// A judgement in words with the kind of notice it is shown as ("good", "warning", "bad").
struct StorageNotice {
    const char* kind;
    QString text;
    bool isGood() const { return QLatin1String(kind) == QLatin1String("good"); }
};

/// How the state of the storage is said. Translated; GUI thread.
class StorageWords {
    Q_DECLARE_TR_FUNCTIONS(StorageWords)
public:
    /// Disk and ring folder together: the worse of the two.
    static StorageNotice room(const session::StorageRoom& room, const QLocale& locale);
    /// A backup older than a week is a warning, none at all too.
    static StorageNotice backup(const std::string& latestUtc, const QDateTime& now, const QLocale& locale);
    /// How the schedule's latest attempt went, and when.
    static StorageNotice automatic(const database::BackupStanding& standing, const QDateTime& now, const QLocale& locale);
    static StorageNotice sameDisk(); ///< backups beside what they are of
    static QString findingKind(const std::string& kind);
    static StorageNotice verified(const database::VerifyReport& report, const QLocale& locale);
};

} // namespace chiron::desktop
