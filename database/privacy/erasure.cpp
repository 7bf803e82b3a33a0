// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/privacy/erasure.h"

#include "core/clock.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/privacy/participant_erasure.h"

#include <vector>

namespace chiron::database {
namespace {

core::Result<std::vector<std::int64_t>> idsOf(Connection& connection, const std::string& sql,
                                              PersonId person) {
    auto query = Query::run(connection, sql, {person});
    CHIRON_TRY(query);
    std::vector<std::int64_t> ids;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        ids.push_back(query->integer(0));
    }
    CHIRON_TRY(row);
    return ids;
}

core::Result<void> overwriteIdentity(Connection& connection, const Actor& byWhom, Erasure& erasure) {
    const PersonId id = erasure.person;
    const std::string name = "erased-" + std::to_string(id);
    const auto before = selectText(
        connection, "SELECT lower(hex(digest)) FROM person WHERE id = ? AND kind <> 'simulated'", {id});
    const auto created = selectText(connection, "SELECT created_utc FROM person WHERE id = ?", {id});
    CHIRON_TRY(before);
    CHIRON_TRY(created);
    if (!*before) {
        return core::fail(core::ErrorCode::notFound, "there is no person " + std::to_string(id));
    }
    const auto person = updateRow(connection, "person", {{"id", id}},
                                  {{"kind", std::string("erased")},
                                   {"name", name},
                                   {"name_key", name},
                                   {"display_name", std::string()},
                                   {"roles", std::string()},
                                   {"enabled", std::int64_t{0}}});
    const auto code = updateRow(connection, "person_code", {{"person_id", id}}, {{"code", name}});
    const auto credential = updateRow(
        connection, "credential", {{"person_id", id}},
        {{"password_hash", std::string()}, {"recovery_hash", std::string()}, {"wait_boot", std::string()}});
    CHIRON_TRY(person);
    CHIRON_TRY(code);
    CHIRON_TRY(credential);
    erasure.personCreated_utc = created->value_or("");
    erasure.digestsJson = "{\"person\":\"" + **before + "\"";
    return appendAudit(connection, byWhom, {"erase", "person", id, *person, "{}"});
}

core::Result<void> overwriteTexts(Connection& connection, const Actor& byWhom, PersonId id) {
    auto comments = Query::run(connection,
                               "UPDATE session_comment SET text = '' WHERE author_id = ? OR session_id IN "
                               "(SELECT id FROM session WHERE person_id = ?)",
                               {id, id});
    auto reasons = Query::run(
        connection, "UPDATE session SET void_reason = '' WHERE voided_by = ? OR person_id = ?", {id, id});
    auto decisions =
        Query::run(connection,
                   "UPDATE session_decision SET reason = '' WHERE person_id = ? OR session_id IN "
                   "(SELECT id FROM session WHERE person_id = ?)",
                   {id, id});
    auto names = Query::run(connection, "UPDATE person_name SET names_json = '' WHERE person_id = ?", {id});
    CHIRON_TRY(comments);
    CHIRON_TRY(reasons);
    CHIRON_TRY(decisions);
    CHIRON_TRY(names);
    // A trace's name or the folder of the ring may reveal the person. Names of scripted operators do not, but
    // a single rule is simpler.
    const auto sessions = idsOf(connection, "SELECT id FROM session WHERE person_id = ?", id);
    CHIRON_TRY(sessions);
    for (const SessionId session : *sessions) {
        const auto row = updateRow(connection, "session", {{"id", session}},
                                   {{"ring_file", std::string()}, {"operator_name", std::string()}});
        CHIRON_TRY(row);
        if (auto audited = appendAudit(connection, byWhom, {"eraseTexts", "session", session, *row, "{}"});
            !audited) {
            return audited;
        }
    }
    return {};
}

// Sessions of a study contain its participants' movements, not those of the person who conducted them.
core::Result<void> overwriteRecordings(Connection& connection, const Actor& byWhom, Erasure& erasure) {
    const auto sessions =
        idsOf(connection,
              "SELECT id FROM session WHERE person_id = ? AND id NOT IN (SELECT session_id FROM "
              "recorded_sitting)",
              erasure.person);
    CHIRON_TRY(sessions);
    std::string seals;
    for (const SessionId session : *sessions) {
        CHIRON_TRY(overwriteRecording(connection, byWhom, session, seals));
    }
    erasure.digestsJson += ",\"sessions\":{" + seals + "}";
    return {};
}

// Erases the person's identity as a participant of studies: only the key contains it; everything else refers
// to the code.
core::Result<void> overwriteParticipations(Connection& connection, const Actor& byWhom,
                                           const Erasure& erasure) {
    const auto participants = participantsOf(connection, erasure.person);
    CHIRON_TRY(participants);
    for (const std::int64_t participant : *participants) {
        Erasure each = erasure;
        each.digestsJson.clear();
        const auto done = overwriteParticipant(connection, byWhom, participant, std::move(each));
        CHIRON_TRY(done);
    }
    return {};
}

core::Result<void> storeTombstone(Connection& connection, const Erasure& erasure) {
    const auto known =
        selectInteger(connection, "SELECT 1 FROM erasure WHERE person_id = ?", {erasure.person});
    CHIRON_TRY(known);
    const std::vector<Column> key{{"person_id", erasure.person}};
    std::vector<Column> rest{{"utc", erasure.utc},
                             {"reason", erasure.reason},
                             {"administrator_id", erasure.administrator},
                             {"recordings_withdrawn", std::int64_t{erasure.recordingsWithdrawn}},
                             {"digests_json", erasure.digestsJson}};
    if (!*known) {
        rest.insert(rest.begin(), key.front());
    }
    const auto row = *known ? updateRow(connection, "erasure", key, std::move(rest))
                            : insertRow(connection, "erasure", std::move(rest));
    CHIRON_TRY(row);
    return {};
}

} // namespace

core::Result<void> overwriteRecording(Connection& connection, const Actor& byWhom, SessionId session,
                                      std::string& digestsJson) {
    const auto seal = selectText(connection, "SELECT lower(hex(seal)) FROM session WHERE id = ?", {session});
    auto payloads =
        Query::run(connection, "UPDATE chunk SET payload = zeroblob(0) WHERE session_id = ?", {session});
    CHIRON_TRY(seal);
    CHIRON_TRY(payloads);
    const auto row =
        updateRow(connection, "session", {{"id", session}}, {{"recording_erased", std::int64_t{1}}});
    CHIRON_TRY(row);
    digestsJson +=
        (digestsJson.empty() ? "\"" : ",\"") + std::to_string(session) + "\":\"" + seal->value_or("") + "\"";
    return appendAudit(connection, byWhom, {"eraseRecording", "session", session, *row, "{}"});
}

core::Result<Erasure> overwritePerson(Connection& connection, const Actor& byWhom, Erasure erasure) {
    if (erasure.utc.empty()) {
        erasure.utc = core::utcNowIso8601();
    }
    auto done = overwriteParticipations(connection, byWhom, erasure);
    done = done ? overwriteIdentity(connection, byWhom, erasure) : done;
    done = done ? overwriteTexts(connection, byWhom, erasure.person) : done;
    if (done && erasure.recordingsWithdrawn) {
        done = overwriteRecordings(connection, byWhom, erasure);
    }
    erasure.digestsJson += "}";
    done = done ? storeTombstone(connection, erasure) : done;
    CHIRON_TRY(done);
    return erasure;
}

core::Result<std::vector<Erasure>> storedErasures(Connection& connection) {
    auto query = Query::run(connection,
                            "SELECT e.person_id, p.created_utc, e.utc, e.reason, e.administrator_id, "
                            "e.recordings_withdrawn, e.digests_json "
                            "FROM erasure e LEFT JOIN person p ON p.id = e.person_id ORDER BY e.person_id");
    CHIRON_TRY(query);
    std::vector<Erasure> erasures;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        erasures.push_back({query->integer(0), query->text(1), query->text(2), query->text(3),
                            query->integer(4), query->integer(5) != 0, query->text(6)});
    }
    CHIRON_TRY(row);
    const auto participants = storedParticipantErasures(connection);
    CHIRON_TRY(participants);
    erasures.insert(erasures.end(), participants->begin(), participants->end());
    return erasures;
}

} // namespace chiron::database
