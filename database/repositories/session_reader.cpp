// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_reader.h"

#include "database/access/authorise.h"
#include "database/query.h"
#include "database/repositories/chunk_store.h"
#include "database/repositories/session_attempts.h"
#include "database/repositories/study_blinding.h"

#include <cstdint>

namespace chiron::database {
namespace {

std::string summaryColumns() {
    return "s.id, s.person_id, p.name, coalesce(k.code, p.name), s.exercise, s.level, s.state, "
           "s.started_utc, "
           "s.utc_offset_min, "
           "s.operator_name, s.felt, s.familiarisation, s.demonstration, s.archived, s.recording_erased, "
           "s.ticks, "
           "s.frames, "
           "s.dropped, s.chunks, s.recording_bytes, "
           "(SELECT passed FROM score_set WHERE session_id = s.id ORDER BY ordinal DESC LIMIT 1), "
           "(SELECT count(c.passed) FROM score c WHERE c.score_set_id = (SELECT id FROM score_set WHERE "
           "session_id = s.id ORDER BY ordinal DESC LIMIT 1)), "
           "(SELECT coalesce(sum(c.passed), 0) FROM score c WHERE c.score_set_id = (SELECT id FROM score_set "
           "WHERE session_id = s.id ORDER BY ordinal DESC LIMIT 1)), "
           "(SELECT count(*) FROM session_comment m WHERE m.session_id = s.id), "
           "EXISTS (SELECT 1 FROM session_comment m WHERE m.session_id = s.id AND m.author_id <> "
           "s.person_id), " +
           attemptNumberSql() + ", " + awaitsReviewSql() + ", " + isOfStudySql("s");
}
constexpr const char* kSummaryTables = " FROM session s JOIN person p ON p.id = s.person_id LEFT JOIN "
                                       "person_code k ON k.person_id = s.person_id";
constexpr int kSummaryCount = 28;

SessionSummary summaryOf(const Query& row, bool names, PersonId self) {
    SessionSummary summary;
    summary.id = row.integer(0);
    summary.person = row.integer(1);
    summary.personName = names || summary.person == self ? row.text(2) : row.text(3);
    summary.exercise = row.text(4);
    summary.level = static_cast<int>(row.integer(5));
    summary.state = sessionStateFromToken(row.text(6)).value_or(SessionState::faulted);
    summary.startedUtc = row.text(7);
    summary.utcOffset_min = static_cast<int>(row.integer(8));
    summary.operatorName = row.text(9);
    summary.felt = row.integer(10) != 0;
    summary.familiarisation = row.integer(11) != 0;
    summary.demonstration = row.integer(12) != 0;
    summary.archived = row.integer(13) != 0;
    summary.recordingErased = row.integer(14) != 0;
    summary.ticks = unsignedFromStored(row.integer(15));
    summary.frames = unsignedFromStored(row.integer(16));
    summary.dropped = unsignedFromStored(row.integer(17));
    summary.chunks = unsignedFromStored(row.integer(18));
    summary.recordingBytes = unsignedFromStored(row.integer(19));
    summary.passed = row.isNull(20) ? std::nullopt : std::optional(row.integer(20) != 0);
    summary.gates = static_cast<int>(row.integer(21));
    summary.gatesMet = static_cast<int>(row.integer(22));
    summary.comments = static_cast<int>(row.integer(23));
    summary.reviewed = row.integer(24) != 0;
    summary.attempt = static_cast<int>(row.integer(25));
    summary.toReview = row.integer(26) != 0 && summary.person != self;
    summary.ofStudy = row.integer(27) != 0;
    return summary;
}

/// Removes what distinguishes the conditions of a blinded study.
void withhold(SessionSummary& summary) {
    summary.sealed = true;
    summary.passed.reset();
    summary.gates = summary.gatesMet = 0;
    summary.ticks = summary.frames = summary.dropped = summary.chunks = summary.recordingBytes = 0;
}

constexpr const char* kDetailColumns = ", c.json, lower(hex(c.sha256)), s.seed, s.device_json, "
                                       "s.mapping_json, s.supervisor_json, s.versions_json, s.build_id, "
                                       "s.cpu_class, s.force_limit_n, s.planned_trials, s.realtime, "
                                       "s.ring_file, s.channel_table, s.loop_json, s.ended_utc, "
                                       "s.void_reason, coalesce(s.voided_by, 0), s.state_before_void";

SessionRecord recordOf(const Query& row, bool names, PersonId self) {
    SessionRecord record;
    record.summary = summaryOf(row, names, self);
    NewSession& setup = record.setup;
    setup.exercise = record.summary.exercise;
    setup.level = record.summary.level;
    setup.operatorName = record.summary.operatorName;
    setup.felt = record.summary.felt;
    setup.familiarisation = record.summary.familiarisation;
    int column = kSummaryCount;
    setup.contentJson = row.text(column++);
    record.contentSha256 = row.text(column++);
    setup.seed = unsignedFromStored(row.integer(column++));
    setup.deviceJson = row.text(column++);
    setup.mappingJson = row.text(column++);
    setup.supervisorJson = row.text(column++);
    setup.versionsJson = row.text(column++);
    setup.buildId = row.text(column++);
    setup.cpuClass = row.text(column++);
    setup.forceLimit_N = row.real(column++);
    setup.plannedTrials = static_cast<int>(row.integer(column++));
    setup.realtime = row.integer(column++) != 0;
    setup.ringFile = row.text(column++);
    setup.channelTable = row.blob(column++);
    record.loopJson = row.text(column++);
    record.endedUtc = row.text(column++);
    record.voidReason = row.text(column++);
    record.voidedBy = row.integer(column++);
    record.stateBeforeVoid = sessionStateFromToken(row.text(column));
    return record;
}

core::Result<std::vector<SessionDecision>> decisionsOn(Connection& connection, SessionId session) {
    auto query = Query::run(
        connection,
        "SELECT decision, person_id, utc, reason FROM session_decision WHERE session_id = ? ORDER BY id",
        {session});
    CHIRON_TRY(query);
    std::vector<SessionDecision> decisions;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        decisions.push_back({query->text(0) == "void", query->integer(1), query->text(2), query->text(3)});
    }
    CHIRON_TRY(row);
    return decisions;
}

// Actors who may list people see names; others see codes (and their own name).
core::Result<bool> mayReadNames(Connection& connection, const Actor& actor) {
    const auto scope = authorise(connection, actor, Action::listPeople);
    if (core::failedAs(scope, core::ErrorCode::notAllowed)) {
        return false;
    }
    CHIRON_TRY(scope);
    return true;
}

class Conditions {
public:
    void add(const std::string& condition, Value value) {
        m_sql += (m_sql.empty() ? " WHERE " : " AND ") + condition;
        m_values.push_back(std::move(value));
    }
    const std::string& sql() const { return m_sql; }
    std::vector<Value>& values() { return m_values; }

private:
    std::string m_sql;
    std::vector<Value> m_values;
};

Conditions conditionsOf(const SessionFilter& filter, Scope scope, const Actor& actor) {
    Conditions where;
    if (scope == Scope::own) {
        where.add("s.person_id = ?", actor.personId());
    } else if (scope == Scope::simulated) {
        where.add("s.person_id = ?", Actor::kSimulatedPerson);
    } else if (scope == Scope::ownAndSimulated) {
        where.add("s.person_id IN (1, ?)", actor.personId());
    }
    if (filter.person) {
        where.add("s.person_id = ?", *filter.person);
    }
    if (!filter.exercise.empty()) {
        where.add("s.exercise = ?", filter.exercise);
    }
    if (filter.level) {
        where.add("s.level = ?", std::int64_t{*filter.level});
    }
    if (filter.state) {
        where.add("s.state = ?", std::string(token(*filter.state)));
    }
    if (filter.toReview) {
        where.add(awaitsReviewSql() + " AND s.person_id <> ?", actor.personId());
    }
    if (!filter.includeArchived) {
        where.add("s.archived = ?", std::int64_t{0});
    }
    if (filter.afterSession > 0) {
        where.add(filter.newestFirst ? "s.id < ?" : "s.id > ?", filter.afterSession);
    }
    return where;
}

} // namespace

std::string SessionReader::listSql(const std::string& where, bool newestFirst) {
    return "SELECT " + summaryColumns() + kSummaryTables + where +
           (newestFirst ? " ORDER BY s.id DESC LIMIT ?" : " ORDER BY s.id LIMIT ?");
}

core::Result<std::vector<SessionSummary>>
SessionReader::summaries(const std::string& where, const std::vector<Value>& values, bool newestFirst) {
    const auto names = mayReadNames(m_connection, m_actor);
    CHIRON_TRY(names);
    const auto sealed = sealedSittings(m_connection, m_actor);
    CHIRON_TRY(sealed);
    auto query = Query::run(m_connection, listSql(where, newestFirst), values);
    CHIRON_TRY(query);
    std::vector<SessionSummary> sessions;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        sessions.push_back(summaryOf(*query, *names, m_actor.personId()));
        if (sealed->contains(sessions.back().id)) {
            withhold(sessions.back());
        }
    }
    CHIRON_TRY(row);
    return sessions;
}

core::Result<std::vector<SessionSummary>> SessionReader::listSessions(const SessionFilter& filter) {
    const auto scope = authorise(m_connection, m_actor, Action::listSessions);
    CHIRON_TRY(scope);
    Conditions where = conditionsOf(filter, *scope, m_actor);
    where.values().push_back(std::int64_t{filter.limit > 0 ? filter.limit : -1});
    return summaries(where.sql(), where.values(), filter.newestFirst);
}

core::Result<std::vector<CommentedSession>> SessionReader::commentedSessions(const CommentedFilter& which) {
    const auto scope = authorise(m_connection, m_actor, Action::commentedSessions);
    CHIRON_TRY(scope);
    SessionFilter filter;
    filter.includeArchived = true;
    Conditions where = conditionsOf(filter, *scope, m_actor);
    where.add("EXISTS (SELECT 1 FROM session_comment m WHERE m.session_id = s.id AND ? IN (m.author_id, "
              "s.person_id))",
              m_actor.personId());
    if (which.toRead) {
        where.add("EXISTS (SELECT 1 FROM (SELECT ? AS self) reader JOIN session_comment m ON m.session_id = "
                  "s.id AND m.author_id <> reader.self "
                  "WHERE s.person_id = reader.self OR EXISTS (SELECT 1 FROM session_comment before WHERE "
                  "before.session_id = s.id AND "
                  "before.author_id = reader.self AND before.id < m.id))",
                  m_actor.personId());
    }
    where.values().push_back(std::int64_t{which.most > 0 ? which.most : -1});
    auto sessions = summaries(where.sql(), where.values(), true);
    CHIRON_TRY(sessions);
    std::vector<CommentedSession> commented;
    for (SessionSummary& session : *sessions) {
        auto written = comments(session.id);
        CHIRON_TRY(written);
        commented.push_back({std::move(session), std::move(*written)});
    }
    return commented;
}

core::Result<std::vector<SessionRecord>> SessionReader::records(const std::string& where,
                                                                const std::vector<Value>& values) {
    const auto names = mayReadNames(m_connection, m_actor);
    CHIRON_TRY(names);
    auto query = Query::run(m_connection,
                            "SELECT " + summaryColumns() + kDetailColumns + kSummaryTables +
                                " JOIN content c ON c.id = s.content_id WHERE " + where + " ORDER BY s.id",
                            values);
    CHIRON_TRY(query);
    std::vector<SessionRecord> records;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        records.push_back(recordOf(*query, *names, m_actor.personId()));
    }
    CHIRON_TRY(row);
    return records;
}

core::Result<std::vector<SessionRecord>> SessionReader::listUnfinished() {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::listUnfinished));
    auto running = records("s.state = 'running'", {});
    for (std::size_t i = 0; running && i < running->size(); ++i) {
        const auto closed = isSealedSitting(m_connection, m_actor, (*running)[i].summary.id);
        CHIRON_TRY(closed);
        if (*closed) {
            withhold((*running)[i].summary);
            (*running)[i].setup.contentJson.clear();
            (*running)[i].contentSha256.clear();
            // With the seed the condition's presentations could be drawn and compared.
            (*running)[i].setup.seed = 0;
        }
    }
    return running;
}

core::Result<SessionRecord> SessionReader::session(SessionId id) {
    auto allowed = authoriseForSession(m_connection, m_actor, Action::session, id);
    allowed = allowed ? mayOpenSitting(m_connection, m_actor, id) : allowed;
    CHIRON_TRY(allowed);
    auto found = records("s.id = ?", {id});
    CHIRON_TRY(found);
    auto decisions = decisionsOn(m_connection, id);
    CHIRON_TRY(decisions);
    if (!found->empty()) {
        found->front().decisions = std::move(*decisions);
    }
    return found->empty() ? core::fail(core::ErrorCode::storage,
                                       "session " + std::to_string(id) + " is damaged; run verify")
                          : core::Result<SessionRecord>(std::move(found->front()));
}

core::Result<std::unique_ptr<recording::ChunkSource>> SessionReader::openChunks(SessionId id) {
    auto allowed = authoriseForSession(m_connection, m_actor, Action::openChunks, id);
    allowed = allowed ? mayOpenSitting(m_connection, m_actor, id) : allowed;
    CHIRON_TRY(allowed);
    const auto erased =
        selectInteger(m_connection, "SELECT recording_erased FROM session WHERE id = ?", {id});
    CHIRON_TRY(erased);
    if (erased->value_or(0) != 0) {
        return core::fail(core::ErrorCode::notFound,
                          "the recording of session " + std::to_string(id) + " was erased");
    }
    return makeChunkSource(m_connection, id);
}

} // namespace chiron::database
