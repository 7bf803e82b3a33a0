// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/access/access_table.h"
#include "database/connection.h"

namespace chiron::database {

/// Returns the scope with which the actor may do this, from the access table and from the current state of
/// the account in the database.
/// Errors: notAllowed (no scope, account disabled, or password must be changed first); storage.
core::Result<Scope> authorise(Connection& connection, const Actor& actor, Action action);

/// The same for something that belongs to a person.
/// Errors: as above; notAllowed also if the scope does not cover that person.
core::Result<void> authoriseFor(Connection& connection, const Actor& actor, Action action, PersonId owner);

/// The same for the owner of a session.
/// Errors: as above; notFound, which an actor without a wider scope receives as notAllowed, so that session
/// numbers cannot be probed.
core::Result<void> authoriseForSession(Connection& connection, const Actor& actor, Action action,
                                       SessionId session);

/// The part of a study that an action concerns: the study itself, one of its participants, or one of their
/// runs.
enum class StudyPart { study, participant, run };
/// The same for the author of a study, who owns everything in it.
core::Result<void> authoriseForStudy(Connection& connection, const Actor& actor, Action action,
                                     StudyPart part, std::int64_t number);

} // namespace chiron::database
