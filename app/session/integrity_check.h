// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/integrity/verifier.h"

namespace chiron::session {

/// Everything that `verify` checks: the database's own checks, and every score recomputed from its recording.
database::VerifyReport verifyEverything(const std::string& databaseFile,
                                        const database::DatabaseOptions& options = {},
                                        const database::VerifyWatch& watch = {});

/// Recomputes the scores of one session and compares them with the stored ones; empty if they are equal.
std::vector<database::Finding> checkScores(database::Connection& connection, database::SessionId session);

} // namespace chiron::session
