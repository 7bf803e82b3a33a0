// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/integrity/row_digest.h"
#include "database/repositories/session_types.h"
#include "scoring/score_card.h"

#include <optional>

namespace chiron::database {

/// Scores of sessions. Storing always makes a new numbered set, and no set is ever changed. Values are stored
/// with the exact bits of the double, except -0.0, which SQLite stores as 0.0 (so it is stored and digested
/// as 0.0).
class ScoreRepository {
public:
    ScoreRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Stores the score card of an ended session, all or nothing, and audits its seal; returns the set's
    /// number (from 1).
    /// Errors: badInput for NaN, infinity, or a value together with a reason or without either.
    core::Result<int> storeScores(SessionId session, const scoring::ScoreCard& card);
    /// Returns the latest set, or the requested one.
    /// Errors: notFound if there is none.
    core::Result<scoring::ScoreCard> scores(SessionId session, std::optional<int> set = {});
    /// Returns the seal of that set (session_seal.h), which the audit chain covers and by which a report
    /// identifies its scores.
    /// Errors: as for scores.
    core::Result<RowDigest> scoreSeal(SessionId session, std::optional<int> set = {});

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
