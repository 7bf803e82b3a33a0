// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/repositories/session_repository.h"
#include "database/repositories/session_rules.h"

#include <cstdint>
#include <limits>

// What people decide about or add to a session afterwards: voiding, archiving, comments.
namespace chiron::database {
namespace {
constexpr int kMaximumFreeText = 10000;

// Checks that the tick lies in the session. The length of a running session is not known yet.
core::Result<void> checkMoment(Connection& connection, SessionId session, std::uint64_t tick) {
    const auto ticks =
        selectInteger(connection, "SELECT ticks FROM session WHERE id = ? AND state <> 'running'", {session});
    CHIRON_TRY(ticks);
    const auto longest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    const bool inside = tick <= (*ticks ? static_cast<std::uint64_t>(**ticks) : longest);
    return inside ? core::Result<void>()
                  : core::fail(core::ErrorCode::badInput, "moment: the session has no tick " +
                                                              std::to_string(tick) + ", its last is " +
                                                              std::to_string(ticks->value_or(0)));
}

} // namespace

core::Result<void> mayWriteSession(Connection& connection, const Actor& actor, Action action,
                                   SessionId session) {
    CHIRON_TRY(requireWriter(connection));
    return authoriseForSession(connection, actor, action, session);
}

core::Result<SessionState> sessionState(Connection& connection, SessionId session) {
    const auto word = selectText(connection, "SELECT state FROM session WHERE id = ?", {session});
    CHIRON_TRY(word);
    const auto state = sessionStateFromToken(word->value_or(""));
    return state ? core::Result<SessionState>(*state)
                 : core::fail(core::ErrorCode::storage,
                              "session " + std::to_string(session) + " has no valid state");
}

namespace {

core::Result<void> checkReason(const std::string& reason) {
    auto good = checkText("reason", reason, kMaximumFreeText);
    return good && reason.empty() ? core::fail(core::ErrorCode::badInput, "reason: expected a text") : good;
}

// Returns the current state of the session, after checking the actor's right and the reason.
core::Result<SessionState> stateToJudge(Connection& connection, const Actor& actor, Action decision,
                                        SessionId session, const std::string& reason) {
    auto may = mayWriteSession(connection, actor, decision, session);
    may = may ? checkReason(reason) : may;
    CHIRON_TRY(may);
    return sessionState(connection, session);
}

// Returns the voiding in the session's own row, which is there until it is reversed.
core::Result<std::vector<Column>> presentVoiding(Connection& connection, SessionId session) {
    auto query = Query::run(
        connection,
        "SELECT voided_by, void_reason, void_reason_hash, (SELECT utc FROM audit WHERE target = 'session' "
        "AND target_id "
        "= session.id AND action = 'voidSession' ORDER BY sequence DESC LIMIT 1) FROM session WHERE id = ?",
        {session});
    CHIRON_TRY(query);
    auto row = query->next();
    if (!row || !*row || query->isNull(0) || query->isNull(2)) {
        CHIRON_TRY(row);
        return core::fail(core::ErrorCode::storage,
                          "session " + std::to_string(session) + " does not say who voided it; run verify");
    }
    return std::vector<Column>{{"decision", std::string("void")},
                               {"person_id", query->integer(0)},
                               {"utc", query->text(3)},
                               {"reason", query->text(1)},
                               {"reason_hash", query->blob(2)}};
}

core::Result<void> storeDecision(Connection& connection, const Actor& actor, SessionId session,
                                 std::vector<Column> decision) {
    const auto last = selectInteger(connection, "SELECT max(id) FROM session_decision");
    CHIRON_TRY(last);
    const std::int64_t id = last->value_or(0) + 1;
    decision.push_back({"id", id});
    decision.push_back({"session_id", session});
    const auto row = insertRow(connection, "session_decision", std::move(decision));
    CHIRON_TRY(row);
    return appendAudit(connection, actor, {"reinstateSession", "session_decision", id, *row, "{}"});
}

} // namespace

core::Result<void> SessionRepository::voidSession(SessionId session, const std::string& reason) {
    const auto state = stateToJudge(m_connection, m_actor, Action::voidSession, session, reason);
    CHIRON_TRY(state);
    if (*state == SessionState::running || *state == SessionState::voided) {
        return core::fail(core::ErrorCode::wrongUse,
                          "session " + std::to_string(session) + " is " + std::string(token(*state)));
    }
    const auto row = updateRow(m_connection, "session", {{"id", session}},
                               {{"state", std::string("voided")},
                                {"state_before_void", std::string(token(*state))},
                                {"void_reason", reason},
                                {"void_reason_hash", toBlob(textDigest(reason))},
                                {"voided_by", m_actor.personId()}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, m_actor, {"voidSession", "session", session, *row, "{}"});
}

core::Result<void> SessionRepository::reinstateSession(SessionId session, const std::string& reason) {
    const auto state = stateToJudge(m_connection, m_actor, Action::reinstateSession, session, reason);
    CHIRON_TRY(state);
    if (*state != SessionState::voided) {
        return core::fail(core::ErrorCode::wrongUse, "session " + std::to_string(session) + " is " +
                                                         std::string(token(*state)) + ", not voided");
    }
    auto voiding = presentVoiding(m_connection, session);
    const auto before =
        selectText(m_connection, "SELECT state_before_void FROM session WHERE id = ?", {session});
    CHIRON_TRY(voiding);
    CHIRON_TRY(before);
    auto stored = storeDecision(m_connection, m_actor, session, std::move(*voiding));
    stored = stored ? storeDecision(m_connection, m_actor, session,
                                    {{"decision", std::string("reinstate")},
                                     {"person_id", m_actor.personId()},
                                     {"utc", core::utcNowIso8601()},
                                     {"reason", reason},
                                     {"reason_hash", toBlob(textDigest(reason))}})
                    : stored;
    CHIRON_TRY(stored);
    const auto row = updateRow(m_connection, "session", {{"id", session}},
                               {{"state", before->value_or("")},
                                {"state_before_void", Value()},
                                {"void_reason", std::string()},
                                {"void_reason_hash", Value()},
                                {"voided_by", Value()}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, m_actor, {"reinstateSession", "session", session, *row, "{}"});
}

core::Result<void> SessionRepository::setArchived(SessionId session, bool archived) {
    CHIRON_TRY(mayWriteSession(m_connection, m_actor, Action::setArchived, session));
    const auto row =
        updateRow(m_connection, "session", {{"id", session}}, {{"archived", std::int64_t{archived}}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, m_actor,
                       {archived ? "archive" : "unarchive", "session", session, *row, "{}"});
}

core::Result<std::int64_t> SessionRepository::addComment(SessionId session, const std::string& text,
                                                         std::optional<std::uint64_t> tick) {
    CHIRON_TRY(mayWriteSession(m_connection, m_actor, Action::addComment, session));
    if (auto good = checkText("comment", text, kMaximumFreeText); !good || text.empty()) {
        CHIRON_TRY(good);
        return core::fail(core::ErrorCode::badInput, "comment: expected a text");
    }
    CHIRON_TRY(tick ? checkMoment(m_connection, session, *tick) : core::Result<void>());
    const auto last = selectInteger(m_connection, "SELECT max(id) FROM session_comment");
    CHIRON_TRY(last);
    const std::int64_t id = last->value_or(0) + 1;
    const auto row = insertRow(m_connection, "session_comment",
                               {{"id", id},
                                {"session_id", session},
                                {"author_id", m_actor.personId()},
                                {"utc", core::utcNowIso8601()},
                                {"text", text},
                                {"text_hash", toBlob(textDigest(text))},
                                {"tick", tick ? Value(static_cast<std::int64_t>(*tick)) : Value()}});
    CHIRON_TRY(row);
    auto audited = appendAudit(m_connection, m_actor, {"addComment", "session_comment", id, *row, "{}"});
    CHIRON_TRY(audited);
    return id;
}

} // namespace chiron::database
