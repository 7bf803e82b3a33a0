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

/// A person who trained recently.
struct RecentPerson {
    qint64 person = 0;
    QString name;
    std::string latestUtc;
    int sessions = 0; ///< in the last seven days
};

/// A session that the last start recovered after a crash, limited to what this person may see.
struct RecoveredRow {
    SessionRow row;
    std::uint64_t framesFromRing = 0;
    std::string problem; ///< empty if all of it was recovered
};

/// A session with comments by others that concern this person: on the person's own session, or after a
/// comment by the person on another's.
struct CommentedSession {
    SessionRow row;
    std::string author; ///< of the latest comment
    int comments = 0;   ///< comments on the session by anybody, up to and including the latest
    bool own = true;    ///< the session is the person's own
};

/// Everything that a home screen shows, as it was at the time of the request.
struct HomeData {
    std::string name; ///< the logged-in person's full name, or else the login name
    std::vector<session::LevelStanding> standings; ///< of the person
    std::vector<SessionRow> own;                   ///< the latest few, newest first
    /// Recent sessions in which others wrote something that concerns the person; latest first.
    std::vector<CommentedSession> commented;
    std::vector<SessionRow> toLook;   ///< for a trainer: the first few that need attention
    int toReview = 0;                 ///< for a trainer: total number awaiting a review
    std::vector<RecentPerson> people; ///< for a trainer: latest first
    std::vector<RecoveredRow> recovered;
    int accounts = 0; ///< for an administrator: number of enabled accounts
    /// For an administrator: the number of participants who asked for their recordings to be erased.
    int toErase = 0;
    /// For an administrator: without a recovery code, a forgotten password would need another person's help.
    bool lacksRecoveryCode = false;
    std::optional<session::StorageRoom> room; ///< for an administrator
    std::string latestBackupUtc;              ///< empty if none was found
    database::BackupStanding backups;         ///< for an administrator: state of the backup schedule
    bool lastLoopTimed = false;               ///< whether the newest session ran in real time ...
    bool lastLoopPriority = false;            ///< ... and was granted real-time priority
};

/// What to read, and for whom. A value that is passed to the worker.
struct HomeQuestion {
    database::Actor actor;
    ExerciseTitles titles;
    catalogue::Catalogue catalogue;
    std::vector<session::RecoveredSession> recovered;
    std::string databaseFile;
    std::string backupFolder; ///< the station's; used if the site's plan names none
};

/// Reads everything for the home screen.
/// Thread: worker; blocks.
/// Errors: those of the repositories.
core::Result<HomeData> readHome(database::Database& database, const HomeQuestion& question);

} // namespace chiron::desktop
