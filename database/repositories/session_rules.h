// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/access/action.h"
#include "database/connection.h"
#include "database/query.h"
#include "database/repositories/session_types.h"

namespace chiron::database {

/// Checks that the actor may do this to the session, on the writer's connection.
/// Errors: wrongUse, notAllowed, notFound, storage.
core::Result<void> mayWriteSession(Connection& connection, const Actor& actor, Action action,
                                   SessionId session);

/// Makes a comment from a row that begins with id, author_id, utc, text, tick.
SessionComment commentOf(const Query& row);

/// Returns the stored state of a session.
/// Errors: storage.
core::Result<SessionState> sessionState(Connection& connection, SessionId session);

} // namespace chiron::database
