// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/access/access_table.h"
#include "database/connection.h"

namespace chiron::database {

/// The scope with which the actor may do this, from the access table and from the account as it stands now in
/// the database. Failure: notAllowed (no scope, disabled, password to be changed first), storage.
core::Result<Scope> authorise(Connection& connection, const Actor& actor, Action action);

/// As above, for something that belongs to a person. Failure: notAllowed also where the scope does not reach
/// that far.
core::Result<void> authoriseFor(Connection& connection, const Actor& actor, Action action, PersonId owner);

/// As above, for the owner of a session. Failure: also notFound, which somebody without a wider scope gets as
/// notAllowed, so that session numbers cannot be probed.
core::Result<void> authoriseForSession(Connection& connection, const Actor& actor, Action action,
                                       SessionId session);

/// What of a study something is about: itself, one of its participants, or one of their runs.
enum class StudyPart { study, participant, run };
/// As above, for the author of a study, to whom everything in it belongs.
core::Result<void> authoriseForStudy(Connection& connection, const Actor& actor, Action action, StudyPart part,
                                     std::int64_t number);

} // namespace chiron::database
