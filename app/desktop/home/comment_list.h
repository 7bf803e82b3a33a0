// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "desktop/playback/playback_data.h"
#include "desktop/sessions/session_row.h"

#include <vector>

namespace chiron::desktop {

/// A comment that a person wrote or received, with the session that it is about.
struct FoundComment {
    SessionRow row;
    NamedComment named;
    bool received = false; ///< by somebody else, on a session of the person or after what the person wrote; else written, or said beside it
    int place = 0;         ///< among all comments on its session, from 0 in the order of writing
    int onSession = 0;     ///< how many these are
};

/// Up to which of a session's comments (counted from 1; 0: of none) there is something for `self` to read: what others wrote on a session of
/// `self`'s own, and what they wrote after `self` on another's. `authors`: of all its comments, in the order of writing.
int newsUpTo(const std::vector<database::PersonId>& authors, database::PersonId self, bool own);

/// Everything that the actor wrote or received, the newest comment first. Blocking: a worker's task. Failure: the repositories'.
core::Result<std::vector<FoundComment>> readComments(const database::Database& database, const database::Actor& actor, const ExerciseTitles& titles);

} // namespace chiron::desktop
