// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/integrity_check.h"

#include "database/repositories/score_repository.h"
#include "session/session_view.h"

namespace chiron::session {

namespace {

database::Finding finding(database::SessionId session, const std::string& detail) {
    return {"score", "score", "session_id=" + std::to_string(session), detail};
}

} // namespace

std::vector<database::Finding> checkScores(database::Connection& connection, database::SessionId session) {
    // Runs with the maintenance actor: the check changes nothing and reveals nothing about anybody except
    // whether it passes.
    const database::Actor actor = database::Actor::maintenance();
    auto stored = SessionView::open(connection, actor, session);
    if (!stored)
        return {finding(session, "cannot be recomputed: " + stored.error().message)};
    auto kept = database::ScoreRepository(connection, actor).scores(session);
    if (!kept)
        return {finding(session, "stored scores cannot be read: " + kept.error().message)};
    auto again = (*stored)->computeScores();
    if (!again)
        return {finding(session, "cannot be recomputed: " + again.error().message)};
    if (!sameScores(*kept, *again))
        return {finding(session, "stored scores differ from those of the recording")};
    return {};
}

database::VerifyReport verifyEverything(const std::string& databaseFile,
                                        const database::DatabaseOptions& options,
                                        const database::VerifyWatch& watch) {
    return database::verifyDatabase(databaseFile, options, checkScores, watch);
}

} // namespace chiron::session
