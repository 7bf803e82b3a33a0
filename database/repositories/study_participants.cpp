// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/privacy/participant_erasure.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "database/repositories/study_rules.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>

// Participants: codes, keys, consent, withdrawal.
namespace chiron::database {
namespace {

constexpr int kMaximumIdentity = 2000;
constexpr int kMaximumObserver = 500;

struct NewParticipant {
    StudyNumber study = 0;
    std::string identity;
    PersonId person = 0;
    std::string observer;
    std::string wantedCode;
    bool simulated() const { return !observer.empty(); }
};

core::Result<void> bad(const std::string& message) {
    return core::fail(core::ErrorCode::badInput, message);
}

core::Result<void> checkPerson(Connection& connection, const NewParticipant& wanted) {
    if (wanted.person == 0) {
        return {};
    }
    const auto known =
        selectInteger(connection, "SELECT 1 FROM person WHERE id = ? AND kind = 'person'", {wanted.person});
    const auto ids = participantsOf(connection, wanted.person);
    CHIRON_TRY(known);
    CHIRON_TRY(ids);
    if (!*known) {
        return bad("person " + std::to_string(wanted.person) + ": expected somebody with an account");
    }
    for (const ParticipantNumber id : *ids) {
        const auto participant = storedParticipant(connection, id);
        CHIRON_TRY(participant);
        if (participant->study == wanted.study && participant->state != ParticipantState::withdrawn) {
            return bad("this person takes part already"); // only those who may open the key table may know as
                                                          // whom
        }
    }
    return {};
}

core::Result<void> checkWanted(Connection& connection, const Actor& actor, const NewParticipant& wanted) {
    if (actor.kind() == ActorKind::simulated && !wanted.simulated()) {
        return core::fail(core::ErrorCode::notAllowed,
                          "not allowed for the simulated account: participants other than simulated ones");
    }
    if (wanted.simulated() && (wanted.person != 0 || !wanted.identity.empty())) {
        return bad("a simulated participant is nobody: expected no identity and no person");
    }
    static const QRegularExpression kCode(QStringLiteral("^[A-Za-z0-9_-]{1,20}$"));
    if (!wanted.wantedCode.empty() &&
        (!wanted.simulated() || !kCode.match(QString::fromStdString(wanted.wantedCode)).hasMatch())) {
        return bad("code \"" + wanted.wantedCode +
                   "\": expected 1 to 20 letters, digits, \"-\" or \"_\", for a simulated "
                   "participant; people get random codes");
    }
    auto good = checkText("identity", wanted.identity, kMaximumIdentity);
    good = good ? checkText("observer", wanted.observer, kMaximumObserver) : good;
    return good ? checkPerson(connection, wanted) : good;
}

core::Result<std::string> codeFor(Connection& connection, const NewParticipant& wanted) {
    if (!wanted.wantedCode.empty()) {
        const auto taken =
            selectInteger(connection, "SELECT 1 FROM study_participant WHERE study_id = ? AND code = ?",
                          {wanted.study, wanted.wantedCode});
        CHIRON_TRY(taken);
        return *taken ? core::fail(core::ErrorCode::badInput,
                                   "code \"" + wanted.wantedCode + "\": is taken in this study")
                      : core::Result<std::string>(wanted.wantedCode);
    }
    while (true) { // with 148 million codes a second round is rare
        const std::string code = randomCode();
        const auto taken =
            selectInteger(connection, "SELECT 1 FROM study_participant WHERE code = ?", {code});
        if (!taken || !*taken) {
            CHIRON_TRY(taken);
            return code;
        }
    }
}

core::Result<std::int64_t> freeRow(Connection& connection, const NewParticipant& wanted) {
    const Value simulated(std::int64_t{wanted.simulated()});
    const auto row = selectInteger(connection,
                                   "WITH taken AS (SELECT order_row AS r FROM study_participant WHERE "
                                   "study_id = ? AND simulated = ? AND "
                                   "state <> 'withdrawn') SELECT min(r) FROM (SELECT 0 AS r UNION SELECT r + "
                                   "1 FROM taken) WHERE r NOT IN taken",
                                   {wanted.study, simulated});
    CHIRON_TRY(row);
    return row->value_or(0);
}

core::Result<void> storeKey(Connection& connection, const Actor& actor, ParticipantNumber id,
                            const NewParticipant& wanted) {
    const QJsonObject key{{"identity", QString::fromStdString(wanted.identity)},
                          {"nonce", QString::fromStdString(randomNonce())},
                          {"person", static_cast<qint64>(wanted.person)}};
    const std::string json = QJsonDocument(key).toJson(QJsonDocument::Compact).toStdString();
    const auto row = insertRow(connection, "participant_key",
                               {{"id", id}, {"key_json", json}, {"key_hash", toBlob(textDigest(json))}});
    CHIRON_TRY(row);
    return appendAudit(
        connection, actor,
        {"enrolParticipant", "participant_key", id, *row, wanted.person != 0 ? R"({"account":true})" : "{}"});
}

core::Result<void> setState(Connection& connection, const Actor& actor, ParticipantNumber participant,
                            std::string_view action, std::vector<Column> changes) {
    const auto row = updateRow(connection, "study_participant", {{"id", participant}}, std::move(changes));
    CHIRON_TRY(row);
    return appendAudit(connection, actor, {action, "study_participant", participant, *row, "{}"});
}

core::Result<void> insertParticipant(Connection& connection, const Actor& actor, ParticipantNumber id,
                                     const NewParticipant& wanted) {
    const auto code = codeFor(connection, wanted);
    const auto order = freeRow(connection, wanted);
    CHIRON_TRY(code);
    CHIRON_TRY(order);
    const auto row = insertRow(connection, "study_participant",
                               {{"id", id},
                                {"study_id", wanted.study},
                                {"code", *code},
                                {"order_row", *order},
                                {"state", std::string("enrolled")},
                                {"simulated", std::int64_t{wanted.simulated()}},
                                {"observer", wanted.observer},
                                {"enrolled_by", actor.personId()},
                                {"enrolled_utc", core::utcNowIso8601()},
                                {"erase_recordings", std::int64_t{0}}});
    CHIRON_TRY(row);
    auto done = appendAudit(connection, actor,
                            {"enrolParticipant", "study_participant", id, *row,
                             "{\"study\":" + std::to_string(wanted.study) + "}"});
    return done && !wanted.simulated() ? storeKey(connection, actor, id, wanted) : done;
}

} // namespace

core::Result<Participant> StudyRepository::enrolParticipant(StudyNumber study, const std::string& identity,
                                                            PersonId person, const std::string& observer,
                                                            const std::string& wantedCode) {
    auto done = mayWriteStudy(m_connection, m_actor, Action::enrolParticipant, StudyPart::study, study);
    CHIRON_TRY(done);
    const auto stored = studyInState(m_connection, study, "frozen");
    CHIRON_TRY(stored);
    const NewParticipant wanted{study, identity, person, observer, wantedCode};
    done = checkWanted(m_connection, m_actor, wanted);
    const auto last = selectInteger(m_connection, "SELECT max(id) FROM study_participant");
    CHIRON_TRY(done);
    CHIRON_TRY(last);
    const ParticipantNumber id = last->value_or(0) + 1;
    CHIRON_TRY(insertParticipant(m_connection, m_actor, id, wanted));
    const auto all = StudyReader(m_connection, m_actor).participants(study);
    CHIRON_TRY(all);
    const auto found =
        std::find_if(all->begin(), all->end(), [&](const Participant& p) { return p.id == id; });
    return found != all->end() ? core::Result<Participant>(*found)
                               : core::fail(core::ErrorCode::storage, "the new participant cannot be read");
}

core::Result<Participant> StudyRepository::enrolAccount(StudyNumber study, const std::string& identity,
                                                        const std::string& account) {
    CHIRON_TRY(mayWriteStudy(m_connection, m_actor, Action::enrolAccount, StudyPart::study, study));
    const auto person = selectInteger(
        m_connection, "SELECT id FROM person WHERE name_key = ? AND kind = 'person'", {nameKey(account)});
    if (!person || !*person) {
        CHIRON_TRY(person);
        return core::fail(core::ErrorCode::notFound, "there is no account \"" + account + "\"");
    }
    return enrolParticipant(study, identity, **person, {});
}

core::Result<void> StudyRepository::recordConsent(ParticipantNumber participant, const std::string& sha256) {
    auto allowed =
        mayWriteStudy(m_connection, m_actor, Action::recordConsent, StudyPart::participant, participant);
    CHIRON_TRY(allowed);
    const auto who = storedParticipant(m_connection, participant);
    CHIRON_TRY(who);
    const auto study = studyInState(m_connection, who->study, "frozen");
    CHIRON_TRY(study);
    const auto design = designObject(study->designJson);
    CHIRON_TRY(design);
    if (who->state != ParticipantState::enrolled) {
        return core::fail(core::ErrorCode::wrongUse, "participant " + who->code + " is " +
                                                         std::string(token(who->state)) +
                                                         ": expected enrolled, without consent");
    }
    const std::vector<std::string> texts = consentDigests(*design);
    if (std::find(texts.begin(), texts.end(), sha256) == texts.end()) {
        return bad("consent " + sha256 +
                   ": expected the SHA-256 of the study's consent text in one of its languages");
    }
    const QByteArray bytes = QByteArray::fromHex(QByteArray::fromStdString(sha256));
    const auto row = insertRow(m_connection, "participant_consent",
                               {{"id", participant},
                                {"sha256", Blob(bytes.begin(), bytes.end())},
                                {"utc", core::utcNowIso8601()},
                                {"recorded_by", m_actor.personId()}});
    CHIRON_TRY(row);
    auto done =
        appendAudit(m_connection, m_actor, {"recordConsent", "participant_consent", participant, *row, "{}"});
    return done ? setState(m_connection, m_actor, participant, "recordConsent",
                           {{"state", std::string("consented")}})
                : done;
}

core::Result<void> StudyRepository::completeParticipant(ParticipantNumber participant) {
    auto allowed = mayWriteStudy(m_connection, m_actor, Action::completeParticipant, StudyPart::participant,
                                 participant);
    CHIRON_TRY(allowed);
    const auto who = storedParticipant(m_connection, participant);
    CHIRON_TRY(who);
    const auto open = selectInteger(
        m_connection, "SELECT count(*) FROM study_run WHERE participant_id = ? AND state = 'open'",
        {participant});
    CHIRON_TRY(open);
    const bool may = who->state == ParticipantState::consented ||
                     (who->simulated && who->state == ParticipantState::enrolled);
    if (!may || open->value_or(0) > 0) {
        return core::fail(core::ErrorCode::wrongUse, "participant " + who->code + " is " +
                                                         std::string(token(who->state)) + " with " +
                                                         std::to_string(open->value_or(0)) +
                                                         " open runs: expected consented, with none open");
    }
    return setState(m_connection, m_actor, participant, "completeParticipant",
                    {{"state", std::string("completed")}});
}

core::Result<void> StudyRepository::withdrawParticipant(ParticipantNumber participant, bool eraseRecordings) {
    auto allowed = mayWriteStudy(m_connection, m_actor, Action::withdrawParticipant, StudyPart::participant,
                                 participant);
    CHIRON_TRY(allowed);
    const auto who = storedParticipant(m_connection, participant);
    CHIRON_TRY(who);
    auto open = Query::run(
        m_connection, "SELECT id FROM study_run WHERE participant_id = ? AND state = 'open'", {participant});
    std::vector<StudyRunNumber> runs;
    CHIRON_TRY(open);
    auto row = open->next();
    for (; row && *row; row = open->next()) {
        runs.push_back(open->integer(0));
    }
    CHIRON_TRY(row);
    for (const StudyRunNumber run : runs) {
        CHIRON_TRY(endRun(m_connection, m_actor, run, StudyRunState::stopped));
    }
    return setState(
        m_connection, m_actor, participant, "withdrawParticipant",
        {{"state", std::string("withdrawn")}, {"erase_recordings", std::int64_t{eraseRecordings}}});
}

} // namespace chiron::database
