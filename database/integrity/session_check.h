// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/integrity/verifier.h"
#include "database/integrity/verify_steps.h"

#include <map>
#include <set>

namespace chiron::database {

/// The rows that the row scan found, by owner.
struct SeenRows {
    std::map<std::int64_t, std::set<std::int64_t>> chunks; ///< session -> sequences
    std::map<std::int64_t, std::int64_t> scores;           ///< score set -> number
    std::set<std::int64_t> sessions;
};

/// Checks rows that belong together: no chunk or score is missing, and the seals are as stored when the
/// session ended. Then, if `check` is given, it checks the scores themselves.
void checkSessions(Connection& connection, const SeenRows& seen, const ScoreCheck& check,
                   VerifyReport& report, VerifySteps& steps);

} // namespace chiron::database
