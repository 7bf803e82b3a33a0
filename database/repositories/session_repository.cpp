// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_repository.h"

#include "core/clock.h"
#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/repositories/chunk_store.h"
#include "database/repositories/session_rules.h"
#include "database/repositories/session_seal.h"

#include <QCryptographicHash>
#include <QDateTime>

namespace chiron::database {
namespace {

core::Result<void> mustRun(Connection& connection, SessionId session) {
    const auto state = sessionState(connection, session);
    CHIRON_TRY(state);
    return *state == SessionState::running
               ? core::Result<void>()
               : core::fail(core::ErrorCode::wrongUse, "session " + std::to_string(session) + " has ended (" +
                                                           std::string(token(*state)) + ")");
}

core::Result<std::int64_t> contentIdFor(Connection& connection, const std::string& json) {
    const QByteArray hash =
        QCryptographicHash::hash(QByteArray::fromStdString(json), QCryptographicHash::Sha256);
    const Blob sha256(hash.begin(), hash.end());
    const auto known = selectInteger(connection, "SELECT id FROM content WHERE sha256 = ?", {sha256});
    CHIRON_TRY(known);
    if (*known) {
        return **known;
    }
    const auto last = selectInteger(connection, "SELECT max(id) FROM content");
    CHIRON_TRY(last);
    const std::int64_t id = last->value_or(0) + 1;
    const auto row = insertRow(connection, "content", {{"id", id}, {"sha256", sha256}, {"json", json}});
    CHIRON_TRY(row);
    return id;
}

core::Result<void> checkSetup(const NewSession& setup) {
    const auto bad = [](const std::string& message) {
        return core::fail(core::ErrorCode::badInput, message);
    };
    if (setup.exercise.empty() || setup.exercise.size() > 100) {
        return bad("exercise: expected an id of 1 to 100 characters");
    }
    if (setup.level < 1 || setup.level > 1000000) {
        return bad("level " + std::to_string(setup.level) + ": expected 1 to 1000000");
    }
    if (setup.contentJson.empty()) {
        return bad("content: expected the resolved content as JSON");
    }
    if (setup.plannedTrials < 1 || setup.plannedTrials > 1000000) {
        return bad("planned trials " + std::to_string(setup.plannedTrials) + ": expected 1 to 1000000");
    }
    if (!(setup.forceLimit_N >= 0.0 && setup.forceLimit_N <= 1e6)) {
        return bad("force limit: expected 0 to 1e6 N");
    }
    return {};
}

std::vector<Column> columnsOf(SessionId id, const NewSession& setup, std::int64_t content) {
    return {{"id", id},
            {"exercise", setup.exercise},
            {"level", std::int64_t{setup.level}},
            {"content_id", content},
            {"seed", storedFromUnsigned(setup.seed)},
            {"operator_name", setup.operatorName},
            {"felt", std::int64_t{setup.felt}},
            {"device_json", setup.deviceJson},
            {"mapping_json", setup.mappingJson},
            {"supervisor_json", setup.supervisorJson},
            {"versions_json", setup.versionsJson},
            {"build_id", setup.buildId},
            {"cpu_class", setup.cpuClass},
            {"force_limit_n", setup.forceLimit_N},
            {"planned_trials", std::int64_t{setup.plannedTrials}},
            {"familiarisation", std::int64_t{setup.familiarisation}},
            {"realtime", std::int64_t{setup.realtime}},
            {"ring_file", setup.ringFile},
            {"channel_table", Blob(setup.channelTable)},
            {"started_utc", core::utcNowIso8601()},
            {"utc_offset_min", std::int64_t{QDateTime::currentDateTime().offsetFromUtc() / 60}},
            {"state", std::string("running")},
            {"ended_utc", std::string()},
            {"ticks", std::int64_t{0}},
            {"frames", std::int64_t{0}},
            {"dropped", std::int64_t{0}},
            {"chunks", std::int64_t{0}},
            {"recording_bytes", std::int64_t{0}},
            {"loop_json", std::string("{}")},
            {"archived", std::int64_t{0}},
            {"recording_erased", std::int64_t{0}},
            {"void_reason", std::string()}};
}

core::Result<void> mayRecordFor(Connection& connection, const Actor& actor, std::int64_t run) {
    CHIRON_TRY(authoriseForStudy(connection, actor, Action::storeStudyTrial, StudyPart::run, run));
    const auto state = selectText(connection, "SELECT state FROM study_run WHERE id = ?", {run});
    CHIRON_TRY(state);
    return state->value_or("") == "open"
               ? core::Result<void>()
               : core::fail(core::ErrorCode::wrongUse,
                            "run " + std::to_string(run) + " has ended: nothing more is recorded for it");
}

core::Result<void> storeSitting(Connection& connection, const Actor& actor, SessionId session,
                                std::int64_t run) {
    const auto row = insertRow(connection, "study_sitting", {{"id", session}, {"run_id", run}});
    CHIRON_TRY(row);
    return appendAudit(connection, actor, {"beginSession", "study_sitting", session, *row, "{}"});
}

} // namespace

core::Result<SessionId> SessionRepository::beginSession(const NewSession& setup) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::beginSession, m_actor.personId()));
    CHIRON_TRY(checkSetup(setup));
    if (setup.studyRun != 0) {
        CHIRON_TRY(mayRecordFor(m_connection, m_actor, setup.studyRun));
    }
    const auto content = contentIdFor(m_connection, setup.contentJson);
    const auto last = selectInteger(m_connection, "SELECT max(id) FROM session");
    const auto demonstration = selectText(m_connection, "SELECT value FROM meta WHERE key = 'demonstration'");
    CHIRON_TRY(content);
    CHIRON_TRY(last);
    CHIRON_TRY(demonstration);
    const SessionId id = last->value_or(0) + 1;
    auto columns = columnsOf(id, setup, *content);
    columns.push_back({"person_id", m_actor.personId()});
    columns.push_back({"demonstration", std::int64_t{demonstration->value_or("0") == "1"}});
    const auto row = insertRow(m_connection, "session", std::move(columns));
    CHIRON_TRY(row);
    auto audited = appendAudit(m_connection, m_actor, {"beginSession", "session", id, *row, "{}"});
    if (audited && setup.studyRun != 0) {
        audited = storeSitting(m_connection, m_actor, id, setup.studyRun);
    }
    CHIRON_TRY(audited);
    return id;
}

core::Result<std::unique_ptr<recording::TrialSink>> SessionRepository::openSink(SessionId session) {
    if (!m_connection.isWritable()) {
        return core::fail(core::ErrorCode::wrongUse, m_connection.file() + ": only the writer records");
    }
    CHIRON_TRY(authoriseForSession(m_connection, m_actor, Action::openSink, session));
    CHIRON_TRY(mustRun(m_connection, session));
    return makeChunkSink(m_connection, session);
}

core::Result<void> SessionRepository::storeTrial(SessionId session, const TrialRecord& trial) {
    CHIRON_TRY(mayWriteSession(m_connection, m_actor, Action::storeTrial, session));
    CHIRON_TRY(mustRun(m_connection, session));
    if (trial.state == SessionState::running || trial.state == SessionState::voided) {
        return core::fail(core::ErrorCode::badInput,
                          "a trial ends completed, stopped, interrupted, incomplete or faulted");
    }
    const auto row = insertRow(m_connection, "trial",
                               {{"session_id", session},
                                {"ordinal", std::int64_t{trial.index}},
                                {"seed", storedFromUnsigned(trial.seed)},
                                {"state", std::string(token(trial.state))},
                                {"first_tick", storedFromUnsigned(trial.firstTick)},
                                {"last_tick", storedFromUnsigned(trial.lastTick)},
                                {"marked", std::int64_t{trial.marked}},
                                {"timed_out", std::int64_t{trial.timedOut}},
                                {"scene_json", trial.sceneJson}});
    CHIRON_TRY(row);
    return {};
}

core::Result<void> SessionRepository::storeEvents(SessionId session, std::span<const EventRecord> events) {
    CHIRON_TRY(mayWriteSession(m_connection, m_actor, Action::storeEvents, session));
    CHIRON_TRY(mustRun(m_connection, session));
    const auto last =
        selectInteger(m_connection, "SELECT max(ordinal) FROM event WHERE session_id = ?", {session});
    CHIRON_TRY(last);
    std::int64_t ordinal = last->value_or(-1);
    for (const EventRecord& event : events) {
        const auto row = insertRow(m_connection, "event",
                                   {{"session_id", session},
                                    {"ordinal", ++ordinal},
                                    {"tick", storedFromUnsigned(event.tick)},
                                    {"time_s", event.time_s},
                                    {"tool", std::int64_t{event.tool}},
                                    {"kind", event.kind},
                                    {"detail_json", event.detailJson}});
        CHIRON_TRY(row);
    }
    return {};
}

core::Result<void> SessionRepository::finishSession(SessionId session, const SessionEnd& end) {
    CHIRON_TRY(mayWriteSession(m_connection, m_actor, Action::finishSession, session));
    CHIRON_TRY(mustRun(m_connection, session));
    if (end.state == SessionState::running || end.state == SessionState::voided) {
        return core::fail(core::ErrorCode::badInput,
                          "a session ends completed, stopped, interrupted, incomplete or faulted");
    }
    const auto seal = sessionSeal(m_connection, session);
    const auto chunks =
        selectInteger(m_connection, "SELECT count(*) FROM chunk WHERE session_id = ?", {session});
    const auto bytes =
        selectInteger(m_connection, "SELECT sum(length(payload)) FROM chunk WHERE session_id = ?", {session});
    CHIRON_TRY(seal);
    CHIRON_TRY(chunks);
    CHIRON_TRY(bytes);
    const auto row = updateRow(m_connection, "session", {{"id", session}},
                               {{"state", std::string(token(end.state))},
                                {"ended_utc", core::utcNowIso8601()},
                                {"ticks", storedFromUnsigned(end.ticks)},
                                {"frames", storedFromUnsigned(end.frames)},
                                {"dropped", storedFromUnsigned(end.dropped)},
                                {"chunks", chunks->value_or(0)},
                                {"recording_bytes", bytes->value_or(0)},
                                {"loop_json", end.loopJson},
                                {"seal", toBlob(*seal)},
                                {"ring_file", std::string()}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, m_actor,
                       {"finishSession", "session", session, *row,
                        "{\"seal\":\"" + hex(seal->data(), seal->size()) + "\",\"state\":\"" +
                            std::string(token(end.state)) + "\"}"});
}

} // namespace chiron::database
