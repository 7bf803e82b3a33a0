// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/privacy_repository.h"

#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"
#include "database/repositories/participations.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "database/repositories/session_rules.h"
#include "database/repositories/study_blinding.h"

namespace chiron::database {
namespace {

core::Result<PersonSession> sealedSession(Connection& connection, const Actor& actor,
                                          const SessionSummary& summary) {
    auto comments = SessionReader(connection, actor).comments(summary.id);
    CHIRON_TRY(comments);
    PersonSession session;
    session.record.summary = summary;
    session.comments = *std::move(comments);
    session.sealed = true;
    return session;
}

core::Result<PersonSession> sessionOf(Connection& connection, const Actor& actor,
                                      const SessionSummary& summary) {
    const SessionId id = summary.id;
    // A person who conducts a blinded study must not export its conditions.
    const auto closed = isSealedSitting(connection, actor, id);
    if (!closed || *closed) {
        CHIRON_TRY(closed);
        return sealedSession(connection, actor, summary);
    }
    SessionReader reader(connection, actor);
    auto record = reader.session(id);
    auto trials = reader.trials(id);
    auto events = reader.events(id);
    auto comments = reader.comments(id);
    CHIRON_TRY(record);
    CHIRON_TRY(trials);
    CHIRON_TRY(events);
    CHIRON_TRY(comments);
    PersonSession session{
        *std::move(record), *std::move(trials), *std::move(events), *std::move(comments), {}, false};
    auto scores = ScoreRepository(connection, actor).scores(id);
    if (!core::failedAs(scores, core::ErrorCode::notFound)) {
        CHIRON_TRY(scores);
        session.scores = *std::move(scores);
    }
    return session;
}

core::Result<std::vector<SessionComment>> commentsBy(Connection& connection, PersonId author) {
    auto query = Query::run(
        connection,
        "SELECT id, author_id, utc, text, tick FROM session_comment WHERE author_id = ? ORDER BY id",
        {author});
    CHIRON_TRY(query);
    std::vector<SessionComment> comments;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        comments.push_back(commentOf(*query));
    }
    CHIRON_TRY(row);
    return comments;
}

core::Result<std::vector<AuditEntry>> auditOf(Connection& connection, PersonId person) {
    auto query = Query::run(
        connection,
        "SELECT sequence, utc, actor_kind, actor_id, action, target, target_id, detail_json FROM audit "
        "WHERE (actor_id = ? AND actor_kind = 'person') OR (target IN ('person', 'credential') AND "
        "target_id = ?) ORDER BY sequence",
        {person, person});
    CHIRON_TRY(query);
    std::vector<AuditEntry> entries;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        entries.push_back({query->integer(0), query->text(1), query->text(2), query->integer(3),
                           query->text(4), query->text(5), query->integer(6), query->text(7)});
    }
    CHIRON_TRY(row);
    return entries;
}

/// Removes from a person's audit entries the times at which sessions and runs of a blinded study ended,
/// because their duration distinguishes the conditions.
core::Result<void> withholdEnds(Connection& connection, const Actor& actor,
                                std::vector<AuditEntry>& entries) {
    const auto sealed = sealedSittings(connection, actor);
    CHIRON_TRY(sealed);
    for (AuditEntry& entry : entries) {
        bool closed = entry.target == "session" && sealed->contains(entry.targetId);
        if (entry.target == "study_run") {
            const auto blinding = blindingOf(connection, StudyPart::run, entry.targetId);
            if (!core::failedAs(blinding, core::ErrorCode::notFound)) {
                CHIRON_TRY(blinding);
            }
            closed = blinding && blinding->seals();
        }
        if (closed && entry.action != "beginSession" && entry.action != "beginRun") {
            entry.utc.clear();
            entry.detailJson = "{}";
        }
    }
    return {};
}

core::Result<Erasure> tombstoneOf(Connection& connection, PersonId person) {
    auto stored = storedErasures(connection);
    CHIRON_TRY(stored);
    for (const Erasure& erasure : *stored) {
        if (erasure.person == person) {
            return erasure;
        }
    }
    return core::fail(core::ErrorCode::notFound,
                      "person " + std::to_string(person) + " is erased but has no tombstone; run verify");
}

} // namespace

core::Result<PersonExport> PrivacyRepository::exportPerson(PersonId id) {
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::exportPerson, id));
    PersonExport held;
    auto person = AccountRepository(m_connection, m_actor).person(id);
    auto earlier = AccountRepository(m_connection, m_actor).earlierNames(id);
    SessionFilter all;
    all.person = id;
    all.includeArchived = true;
    auto sessions = SessionReader(m_connection, m_actor).listSessions(all);
    auto comments = commentsBy(m_connection, id);
    auto audit = auditOf(m_connection, id);
    auto credential = Query::run(
        m_connection, "SELECT password_hash <> '', failures FROM credential WHERE person_id = ?", {id});
    CHIRON_TRY(person);
    CHIRON_TRY(earlier);
    CHIRON_TRY(sessions);
    CHIRON_TRY(comments);
    CHIRON_TRY(audit);
    CHIRON_TRY(credential);
    held.person = *std::move(person);
    held.earlierNames = *std::move(earlier);
    held.commentsWritten = *std::move(comments);
    held.audit = *std::move(audit);
    CHIRON_TRY(withholdEnds(m_connection, m_actor, held.audit));
    if (const auto row = credential->next(); row && *row) {
        held.hasPassword = credential->integer(0) != 0;
        held.failedLogins = static_cast<int>(credential->integer(1));
    }
    for (const SessionSummary& summary : *sessions) {
        auto session = sessionOf(m_connection, m_actor, summary);
        CHIRON_TRY(session);
        held.sessions.push_back(*std::move(session));
    }
    auto participations = participationsOf(m_connection, id,
                                           m_actor.kind() == ActorKind::person && m_actor.personId() == id &&
                                               !m_actor.roles().contains(Role::researcher) &&
                                               !m_actor.roles().contains(Role::admin));
    CHIRON_TRY(participations);
    held.participations = *std::move(participations);
    return held;
}

core::Result<Erasure> PrivacyRepository::erasePerson(PersonId person, const std::string& reason,
                                                     bool withdrawRecordings) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authorise(m_connection, m_actor, Action::erasePerson));
    if (auto good = checkText("reason", reason, 1000); !good || reason.empty()) {
        CHIRON_TRY(good);
        return core::fail(core::ErrorCode::badInput, "reason: expected a text");
    }
    if (person == Actor::kSimulatedPerson || person == m_actor.personId()) {
        return core::fail(core::ErrorCode::wrongUse,
                          "neither oneself nor the simulated account can be erased");
    }
    const auto kind = selectText(m_connection, "SELECT kind FROM person WHERE id = ?", {person});
    const auto running = selectInteger(
        m_connection, "SELECT count(*) FROM session WHERE person_id = ? AND state = 'running'", {person});
    CHIRON_TRY(kind);
    CHIRON_TRY(running);
    if (!*kind) {
        return core::fail(core::ErrorCode::notFound, "there is no person " + std::to_string(person));
    }
    if (running->value_or(0) > 0) {
        return core::fail(core::ErrorCode::wrongUse, "a session of this person has not ended yet");
    }
    if (**kind == "erased") {
        const auto tombstone = tombstoneOf(m_connection, person);
        if (!tombstone || tombstone->recordingsWithdrawn || !withdrawRecordings) {
            return tombstone;
        }
    }
    return overwritePerson(m_connection, m_actor,
                           {person, "", "", reason, m_actor.personId(), withdrawRecordings, ""});
}

core::Result<std::vector<Erasure>> PrivacyRepository::listErasures() {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::listErasures));
    return storedErasures(m_connection);
}

} // namespace chiron::database
