// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/session_check.h"

#include "database/query.h"
#include "database/repositories/session_seal.h"

#include <algorithm>

namespace chiron::database {
namespace {

std::string sessionKey(std::int64_t session) {
    return "session_id=" + std::to_string(session);
}

struct Ended {
    std::int64_t id = 0;
    std::int64_t chunks = 0;
    Blob seal;
    bool erased = false;
    bool scored = false;
};

struct ScoreSet {
    std::int64_t id = 0;
    std::int64_t session = 0;
    std::int64_t scores = 0;
    Blob seal;
};

// Returns all rows of a query; rows that cannot be read are reported.
template <class T, class Make>
std::vector<T> collect(Connection& connection, const std::string& table, const std::string& sql,
                       VerifyReport& report, Make make) {
    std::vector<T> values;
    auto query = Query::run(connection, sql);
    if (!query) {
        report.findings.push_back({"unreadable", table, "", query.error().message});
        return values;
    }
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        values.push_back(make(*query));
    }
    if (!row) {
        report.findings.push_back({"unreadable", table, "", row.error().message});
    }
    return values;
}

void checkEnded(Connection& connection, const Ended& session, const SeenRows& seen, VerifyReport& report) {
    static const std::set<std::int64_t> none;
    const auto found = seen.chunks.find(session.id);
    const std::set<std::int64_t>& sequences = found == seen.chunks.end() ? none : found->second;
    // A damaged count must not make us list chunks endlessly; the seal reveals the rest.
    constexpr std::int64_t kMostNamed = 1'000'000;
    for (std::int64_t i = 0; i < std::min(session.chunks, kMostNamed); ++i) {
        if (!sequences.contains(i)) {
            report.findings.push_back(
                {"missing", "chunk", sessionKey(session.id) + " sequence=" + std::to_string(i), "not there"});
        }
    }
    const auto seal = sessionSeal(connection, session.id);
    if (!seal) {
        report.findings.push_back(
            {"unreadable", "session", "id=" + std::to_string(session.id), seal.error().message});
    } else if (toBlob(*seal) != session.seal) {
        report.findings.push_back({"seal", "session", "id=" + std::to_string(session.id),
                                   "chunks, trials, events or summaries are not those of the session's end"});
    }
}

void checkScoreSet(Connection& connection, const ScoreSet& set, const SeenRows& seen, VerifyReport& report) {
    const std::string row = "id=" + std::to_string(set.id) + " " + sessionKey(set.session);
    const auto found = seen.scores.find(set.id);
    const std::int64_t present = found == seen.scores.end() ? 0 : found->second;
    if (present != set.scores) {
        report.findings.push_back(
            {"missing", "score", row,
             std::to_string(set.scores) + " scores expected, " + std::to_string(present) + " there"});
    }
    const auto seal = scoreSeal(connection, set.id);
    if (!seal) {
        report.findings.push_back({"unreadable", "score_set", row, seal.error().message});
    } else if (toBlob(*seal) != set.seal) {
        report.findings.push_back({"seal", "score_set", row, "the scores are not those that were stored"});
    }
}

} // namespace

void checkSessions(Connection& connection, const SeenRows& seen, const ScoreCheck& check,
                   VerifyReport& report, VerifySteps& steps) {
    const auto ended =
        collect<Ended>(connection, "session",
                       "SELECT id, chunks, seal, recording_erased, EXISTS (SELECT 1 FROM score_set WHERE "
                       "session_id = session.id) FROM session WHERE state <> 'running' ORDER BY id",
                       report, [](const Query& row) {
                           return Ended{row.integer(0), row.integer(1), row.blob(2), row.integer(3) != 0,
                                        row.integer(4) != 0};
                       });
    const auto sets = collect<ScoreSet>(
        connection, "score_set", "SELECT id, session_id, scores, seal FROM score_set ORDER BY id", report,
        [](const Query& row) {
            return ScoreSet{row.integer(0), row.integer(1), row.integer(2), row.blob(3)};
        });
    for (const Ended& session : ended) {
        checkEnded(connection, session, seen, report);
    }
    for (const ScoreSet& set : sets) {
        checkScoreSet(connection, set, seen, report);
    }
    for (const auto& [session, sequences] : seen.chunks) {
        if (!seen.sessions.contains(session)) {
            report.findings.push_back(
                {"missing", "session", "id=" + std::to_string(session), "chunks refer to it"});
        }
    }
    for (const Ended& session : ended) {
        if (!steps.goOn()) {
            return;
        }
        if (check && session.scored && !session.erased) {
            const auto found = check(connection, session.id);
            report.findings.insert(report.findings.end(), found.begin(), found.end());
            steps.add(VerifySteps::kStepsOfSession);
        }
    }
}

} // namespace chiron::database
