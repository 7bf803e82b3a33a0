// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/score_repository.h"

#include "core/clock.h"
#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/repositories/session_seal.h"
#include "database/repositories/study_blinding.h"

#include <algorithm>
#include <cmath>

namespace chiron::database {
namespace {

core::Result<void> checkValue(const scoring::MetricValue& metric) {
    if (metric.id.empty() || metric.version < 1) {
        return core::fail(core::ErrorCode::badInput, "a score needs a metric id and a version from 1");
    }
    if (metric.value && !std::isfinite(*metric.value)) {
        return core::fail(core::ErrorCode::badInput,
                          metric.id + ": the value is not finite; leave it out and give a reason");
    }
    if (metric.value.has_value() == !metric.reason.empty()) {
        return core::fail(core::ErrorCode::badInput,
                          metric.id + ": expected either a value or a reason why there is none");
    }
    return {};
}

core::Result<void> storeGroup(Connection& connection, std::int64_t set, int trial,
                              const std::vector<scoring::MetricValue>& metrics) {
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const scoring::MetricValue& metric = metrics[i];
        CHIRON_TRY(checkValue(metric));
        const auto row =
            insertRow(connection, "score",
                      {{"score_set_id", set},
                       {"trial", std::int64_t{trial}},
                       {"ordinal", static_cast<std::int64_t>(i)},
                       {"metric", metric.id},
                       {"version", std::int64_t{metric.version}},
                       {"unit", metric.unit},
                       {"value", metric.value ? Value(*metric.value) : Value()},
                       {"reason", metric.reason},
                       {"passed", metric.passed ? Value(std::int64_t{*metric.passed}) : Value()}});
        CHIRON_TRY(row);
    }
    return {};
}

struct NewSet {
    std::int64_t id = 0;
    std::int64_t ordinal = 0;
};

core::Result<NewSet> nextSet(Connection& connection, SessionId session) {
    const auto id = selectInteger(connection, "SELECT max(id) FROM score_set");
    const auto ordinal =
        selectInteger(connection, "SELECT max(ordinal) FROM score_set WHERE session_id = ?", {session});
    const auto running = selectText(connection, "SELECT state FROM session WHERE id = ?", {session});
    CHIRON_TRY(id);
    CHIRON_TRY(ordinal);
    CHIRON_TRY(running);
    if (running->value_or("") == "running") {
        return core::fail(core::ErrorCode::wrongUse,
                          "session " + std::to_string(session) + " has not ended yet");
    }
    return NewSet{id->value_or(0) + 1, ordinal->value_or(0) + 1};
}

scoring::MetricValue metricOf(const Query& row) {
    scoring::MetricValue metric;
    metric.id = row.text(1);
    metric.version = static_cast<int>(row.integer(2));
    metric.unit = row.text(3);
    metric.value = row.isNull(4) ? std::nullopt : std::optional(row.real(4));
    metric.reason = row.text(5);
    metric.passed = row.isNull(6) ? std::nullopt : std::optional(row.integer(6) != 0);
    return metric;
}

// Returns the row (id, passed, trials, seal) of the latest set, or of the requested one.
core::Result<Query> storedSet(Connection& connection, const Actor& actor, SessionId session,
                              std::optional<int> wanted) {
    const auto closed = isSealedSitting(connection, actor, session);
    if (!closed || *closed) {
        CHIRON_TRY(closed);
        return core::fail(
            core::ErrorCode::notFound,
            "session " + std::to_string(session) +
                " is a session of a blinded study: its scores come once the study is unblinded");
    }
    auto set = Query::run(
        connection,
        "SELECT id, passed, trials, seal FROM score_set WHERE session_id = ? AND ordinal BETWEEN ? AND ? "
        "ORDER BY ordinal DESC LIMIT 1",
        {session, std::int64_t{wanted.value_or(1)}, std::int64_t{wanted.value_or(1'000'000)}});
    CHIRON_TRY(set);
    const auto found = set->next();
    CHIRON_TRY(found);
    if (!*found) {
        return core::fail(core::ErrorCode::notFound, "session " + std::to_string(session) + " has no scores");
    }
    return set;
}

} // namespace

core::Result<int> ScoreRepository::storeScores(SessionId session, const scoring::ScoreCard& card) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authoriseForSession(m_connection, m_actor, Action::storeScores, session));
    const auto set = nextSet(m_connection, session);
    CHIRON_TRY(set);
    // Scores refer to their set, whose seal covers them. The reference is therefore checked only when the
    // transaction commits.
    auto done = m_connection.execute("PRAGMA defer_foreign_keys=ON;");
    done = done ? storeGroup(m_connection, set->id, -1, card.metrics) : done;
    std::size_t count = card.metrics.size();
    for (std::size_t i = 0; done && i < card.trials.size(); ++i) {
        done = storeGroup(m_connection, set->id, static_cast<int>(i), card.trials[i]);
        count += card.trials[i].size();
    }
    CHIRON_TRY(done);
    const auto seal = database::scoreSeal(m_connection, set->id);
    CHIRON_TRY(seal);
    const auto row = insertRow(m_connection, "score_set",
                               {{"id", set->id},
                                {"session_id", session},
                                {"ordinal", set->ordinal},
                                {"utc", core::utcNowIso8601()},
                                {"passed", std::int64_t{card.passed}},
                                {"trials", static_cast<std::int64_t>(card.trials.size())},
                                {"scores", static_cast<std::int64_t>(count)},
                                {"seal", toBlob(*seal)}});
    CHIRON_TRY(row);
    auto audited = appendAudit(
        m_connection, m_actor,
        {"storeScores", "score_set", set->id, *row, "{\"session\":" + std::to_string(session) + "}"});
    CHIRON_TRY(audited);
    return static_cast<int>(set->ordinal);
}

core::Result<scoring::ScoreCard> ScoreRepository::scores(SessionId session, std::optional<int> wanted) {
    CHIRON_TRY(authoriseForSession(m_connection, m_actor, Action::scores, session));
    auto set = storedSet(m_connection, m_actor, session, wanted);
    CHIRON_TRY(set);
    scoring::ScoreCard card;
    card.passed = set->integer(1) != 0;
    card.trials.resize(static_cast<std::size_t>(set->integer(2)));
    auto query = Query::run(m_connection,
                            "SELECT trial, metric, version, unit, value, reason, passed FROM score "
                            "WHERE score_set_id = ? ORDER BY trial, ordinal",
                            {set->integer(0)});
    CHIRON_TRY(query);
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        const std::int64_t trial = query->integer(0);
        if (trial >= static_cast<std::int64_t>(card.trials.size())) {
            return core::fail(core::ErrorCode::storage,
                              "scores of session " + std::to_string(session) + " are damaged; run verify");
        }
        (trial < 0 ? card.metrics : card.trials[static_cast<std::size_t>(trial)]).push_back(metricOf(*query));
    }
    CHIRON_TRY(row);
    return card;
}

core::Result<RowDigest> ScoreRepository::scoreSeal(SessionId session, std::optional<int> wanted) {
    CHIRON_TRY(authoriseForSession(m_connection, m_actor, Action::scoreSeal, session));
    const auto set = storedSet(m_connection, m_actor, session, wanted);
    CHIRON_TRY(set);
    const auto seal = set->blob(3);
    RowDigest digest{};
    if (seal.size() != digest.size()) {
        return core::fail(core::ErrorCode::storage,
                          "scores of session " + std::to_string(session) + " are damaged; run verify");
    }
    std::copy(seal.begin(), seal.end(), digest.begin());
    return digest;
}

} // namespace chiron::database
