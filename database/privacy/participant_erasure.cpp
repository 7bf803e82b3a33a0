// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/privacy/participant_erasure.h"

#include "core/clock.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"

namespace chiron::database {
namespace {

core::Result<std::vector<std::int64_t>> idsOf(Connection& connection, const std::string& sql,
                                              std::int64_t number) {
    auto query = Query::run(connection, sql, {number});
    CHIRON_TRY(query);
    std::vector<std::int64_t> ids;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        ids.push_back(query->integer(0));
    }
    CHIRON_TRY(row);
    return ids;
}

// Keys and answers are covered through their hashes, so neither digests nor the chain change.
core::Result<void> overwriteTexts(Connection& connection, std::int64_t participant, std::string& digests) {
    const auto key = selectText(connection, "SELECT lower(hex(key_hash)) FROM participant_key WHERE id = ?",
                                {participant});
    const auto answers =
        selectText(connection,
                   "SELECT group_concat('\"' || id || '\":\"' || lower(hex(answer_hash)) || '\"', ',') FROM "
                   "questionnaire_answer WHERE participant_id = ?",
                   {participant});
    CHIRON_TRY(key);
    CHIRON_TRY(answers);
    digests += "\"key\":\"" + key->value_or("") + "\",\"answers\":{" + answers->value_or("") + "}";
    auto first =
        Query::run(connection, "UPDATE participant_key SET key_json = '' WHERE id = ?", {participant});
    auto second =
        Query::run(connection, "UPDATE questionnaire_answer SET answer_json = '' WHERE participant_id = ?",
                   {participant});
    CHIRON_TRY(first);
    CHIRON_TRY(second);
    return {};
}

// Overwrites remarks about the participant's sessions, whoever wrote them: they are free text and may name
// the person. They, too, are covered through their hash.
core::Result<void> overwriteRemarks(Connection& connection, std::int64_t participant) {
    const std::string sittings =
        "(SELECT t.session_id FROM recorded_sitting t JOIN study_run r ON r.id = t.run_id WHERE "
        "r.participant_id = ?)";
    auto comments = Query::run(
        connection, "UPDATE session_comment SET text = '' WHERE session_id IN " + sittings, {participant});
    auto reasons =
        Query::run(connection, "UPDATE session SET void_reason = '' WHERE id IN " + sittings, {participant});
    auto decisions = Query::run(
        connection, "UPDATE session_decision SET reason = '' WHERE session_id IN " + sittings, {participant});
    CHIRON_TRY(comments);
    CHIRON_TRY(reasons);
    CHIRON_TRY(decisions);
    return {};
}

core::Result<void> overwriteRecordings(Connection& connection, const Actor& byWhom, std::int64_t participant,
                                       std::string& digests) {
    const auto sessions =
        idsOf(connection,
              "SELECT t.session_id FROM recorded_sitting t JOIN study_run r ON r.id = t.run_id "
              "WHERE r.participant_id = ? ORDER BY t.session_id",
              participant);
    CHIRON_TRY(sessions);
    std::string seals;
    for (const SessionId session : *sessions) {
        CHIRON_TRY(overwriteRecording(connection, byWhom, session, seals));
    }
    digests += ",\"sessions\":{" + seals + "}";
    return {};
}

core::Result<void> storeTombstone(Connection& connection, const Actor& byWhom, std::int64_t participant,
                                  const Erasure& erasure) {
    const auto known =
        selectInteger(connection, "SELECT 1 FROM participant_erasure WHERE id = ?", {participant});
    CHIRON_TRY(known);
    std::vector<Column> rest{{"utc", erasure.utc},
                             {"reason", erasure.reason},
                             {"administrator_id", erasure.administrator},
                             {"recordings_withdrawn", std::int64_t{erasure.recordingsWithdrawn}},
                             {"digests_json", erasure.digestsJson}};
    if (!*known) {
        rest.insert(rest.begin(), {"id", participant});
    }
    const auto row =
        *known ? updateRow(connection, "participant_erasure", {{"id", participant}}, std::move(rest))
               : insertRow(connection, "participant_erasure", std::move(rest));
    CHIRON_TRY(row);
    return appendAudit(connection, byWhom,
                       {"eraseParticipant", "participant_erasure", participant, *row, "{}"});
}

} // namespace

core::Result<std::vector<std::int64_t>> participantsOf(Connection& connection, PersonId person) {
    return idsOf(
        connection,
        "SELECT id FROM participant_key WHERE CASE WHEN json_valid(key_json) THEN json_extract(key_json, "
        "'$.person') ELSE 0 END = ? ORDER BY id",
        person);
}

core::Result<std::int64_t> participantWithCode(Connection& connection, const std::string& code) {
    const auto id = selectInteger(
        connection, "SELECT id FROM study_participant WHERE code = ? AND simulated = 0", {code});
    CHIRON_TRY(id);
    return id->value_or(0);
}

core::Result<Erasure> overwriteParticipant(Connection& connection, const Actor& byWhom,
                                           std::int64_t participant, Erasure erasure) {
    auto query =
        Query::run(connection, "SELECT code, simulated, erase_recordings FROM study_participant WHERE id = ?",
                   {participant});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row || query->integer(1) != 0) {
        return *row ? core::fail(core::ErrorCode::wrongUse,
                                 "a simulated participant is nobody who could be erased")
                    : core::fail(core::ErrorCode::notFound,
                                 "there is no participant " + std::to_string(participant));
    }
    erasure.person = 0;
    erasure.personCreated_utc.clear();
    erasure.participantCode = query->text(0);
    erasure.recordingsWithdrawn = erasure.recordingsWithdrawn || query->integer(2) != 0;
    erasure.utc = erasure.utc.empty() ? core::utcNowIso8601() : erasure.utc;
    std::string digests;
    auto done = overwriteTexts(connection, participant, digests);
    done = done ? overwriteRemarks(connection, participant) : done;
    if (done && erasure.recordingsWithdrawn) {
        done = overwriteRecordings(connection, byWhom, participant, digests);
    }
    erasure.digestsJson = "{" + digests + "}";
    done = done ? storeTombstone(connection, byWhom, participant, erasure) : done;
    CHIRON_TRY(done);
    return erasure;
}

core::Result<std::vector<Erasure>> storedParticipantErasures(Connection& connection) {
    const auto there =
        selectInteger(connection, "SELECT count(*) FROM sqlite_schema WHERE name = 'participant_erasure'");
    if (!there || there->value_or(0) == 0) {
        CHIRON_TRY(there);
        return std::vector<Erasure>();
    }
    auto query = Query::run(
        connection, "SELECT p.code, e.utc, e.reason, e.administrator_id, e.recordings_withdrawn, "
                    "e.digests_json FROM participant_erasure e JOIN study_participant p ON p.id = e.id "
                    "ORDER BY e.id");
    CHIRON_TRY(query);
    std::vector<Erasure> erasures;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        erasures.push_back({0, "", query->text(1), query->text(2), query->integer(3), query->integer(4) != 0,
                            query->text(5), query->text(0)});
    }
    CHIRON_TRY(row);
    return erasures;
}

} // namespace chiron::database
