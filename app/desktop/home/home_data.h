// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "core/result.h"
#include "database/upkeep/upkeep.h"
#include "desktop/sessions/session_row.h"
#include "session/level_standing.h"
#include "session/recovery.h"
#include "session/storage_room.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// Somebody who trained lately.
struct RecentPerson {
    qint64 person = 0;
    QString name;
    std::string latestUtc;
    int sessions = 0; ///< in the last seven days
};

/// A session that the last start brought in after a crash, as far as this person may know of it.
struct RecoveredRow {
    SessionRow row;
    std::uint64_t framesFromRing = 0;
    std::string problem; ///< empty: all of it is there
};

/// What others wrote about a session of this person, or after this person about another's.
struct CommentedSession {
    SessionRow row;
    std::string author; ///< of the latest
    int comments = 0;   ///< on the session, everybody's, up to that one
    bool own = true;    ///< a session of this person
};

/// Everything that a home screen shows, as it was when asked for.
struct HomeData {
    std::string name;                              ///< of whoever is logged in: the full one where there is one
    std::vector<session::LevelStanding> standings; ///< of the person
    std::vector<SessionRow> own;                   ///< latest first, some
    std::vector<CommentedSession> commented;       ///< of the latest sessions those where others wrote something for the person, latest first
    std::vector<SessionRow> toLook;                ///< for a trainer: what asks for attention first, some
    int toReview = 0;                              ///< for a trainer: how many await a review in all
    std::vector<RecentPerson> people;              ///< for a trainer, latest first
    std::vector<RecoveredRow> recovered;
    int accounts = 0;                              ///< for an administrator: enabled ones
    int toErase = 0;                               ///< for an administrator: participants who asked for their recordings to be erased
    bool lacksRecoveryCode = false;                ///< for an administrator: a forgotten password would need somebody else's help
    std::optional<session::StorageRoom> room;      ///< for an administrator
    std::string latestBackupUtc;                   ///< empty: none found
    database::BackupStanding backups;              ///< for an administrator: how the schedule goes
    bool lastLoopTimed = false;                    ///< whether the newest session ran against the clock ...
    bool lastLoopPriority = false;                 ///< ... and was granted real-time priority
};

/// What is to be read for whom. A value for the worker.
struct HomeQuestion {
    database::Actor actor;
    ExerciseTitles titles;
    catalogue::Catalogue catalogue;
    std::vector<session::RecoveredSession> recovered;
    std::string databaseFile;
    std::string backupFolder; ///< the station's, where the site's plan names none
};

/// Blocking: a worker's task. Failure: the repositories'.
core::Result<HomeData> readHome(database::Database& database, const HomeQuestion& question);

} // namespace chiron::desktop
