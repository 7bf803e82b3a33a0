// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/integrity/row_digest.h"
#include "database/repositories/session_types.h"
#include "scoring/score_card.h"

#include <optional>

namespace chiron::database {

/// Scores of sessions. Each storing makes a new numbered set; none is ever changed. Values are stored as the
/// double's bits, but for -0.0, which SQLite keeps as 0.0 (so it is stored and digested as 0.0).
class ScoreRepository {
public:
    ScoreRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Stores a card of an ended session and audits its seal; returns the set's number (from 1). Failure:
    /// badInput for NaN, infinity, a value together with a reason or neither; all or nothing.
    core::Result<int> storeScores(SessionId session, const scoring::ScoreCard& card);
    /// The latest set, or the one asked for. Failure: notFound when there is none.
    core::Result<scoring::ScoreCard> scores(SessionId session, std::optional<int> set = {});
    /// The seal of that set (session_seal.h): what the audit chain vouches for, and what a report names its scores by.
    /// Failure as for scores.
    core::Result<RowDigest> scoreSeal(SessionId session, std::optional<int> set = {});

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
