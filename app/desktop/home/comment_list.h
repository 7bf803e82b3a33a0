// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "desktop/playback/playback_data.h"
#include "desktop/sessions/session_row.h"

#include <vector>

namespace chiron::desktop {

/// A comment that a person wrote or received, with the session that it belongs to.
struct FoundComment {
    SessionRow row;
    NamedComment named;
    /// True if another person wrote it on the person's own session, or after a comment by the person. False
    /// if the person wrote it, or another wrote it before the person took part.
    bool received = false;
    int place = 0;     ///< index among all comments on its session, from 0, in order of writing
    int onSession = 0; ///< number of all comments on its session
};

/// Returns the number, counted from 1, of the last comment on a session that `self` should read, or 0 if
/// there is none. These are comments by others on a session of `self` (`own`), and comments by others that
/// follow one by `self` on another person's session. `authors` lists the authors of all its comments in order
/// of writing.
int newsUpTo(const std::vector<database::PersonId>& authors, database::PersonId self, bool own);

/// Reads everything that the actor wrote or received, newest comment first.
/// Thread: worker; blocks.
/// Errors: those of the repositories.
core::Result<std::vector<FoundComment>>
readComments(const database::Database& database, const database::Actor& actor, const ExerciseTitles& titles);

} // namespace chiron::desktop
