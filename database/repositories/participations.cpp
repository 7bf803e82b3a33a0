// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/participations.h"

#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/privacy/participant_erasure.h"
#include "database/repositories/study_blinding.h"
#include "database/repositories/study_rows.h"

#include <QJsonDocument>
#include <QJsonObject>

// The legal rights of study participants: a copy of the stored data, and its erasure.
namespace chiron::database {
namespace {

core::Result<void> addStudy(Connection& connection, PersonParticipation& held) {
    auto query = Query::run(
        connection,
        "SELECT s.key, s.title, k.key_json FROM study_participant p JOIN study s ON s.id = p.study_id "
        "JOIN participant_key k ON k.id = p.id WHERE p.id = ?",
        {held.participant.id});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row) {
        return {};
    }
    held.studyKey = query->text(0);
    held.studyTitle = query->text(1);
    held.identity = QJsonDocument::fromJson(QByteArray::fromStdString(query->text(2)))
                        .object()["identity"]
                        .toString()
                        .toStdString();
    return {};
}

core::Result<PersonParticipation> participation(Connection& connection, ParticipantNumber id, bool own) {
    auto participants = participantRows(connection, "p.id = ?", {id});
    auto runs = shownRuns(connection, id); // the export of a person's data unblinds nothing
    const auto blinding = blindingOf(connection, StudyPart::participant, id);
    CHIRON_TRY(participants);
    CHIRON_TRY(runs);
    CHIRON_TRY(blinding);
    auto answers = answerRows(connection, "p.id = ?", id);
    CHIRON_TRY(answers);
    if (participants->empty()) {
        return core::fail(core::ErrorCode::storage, "a participant is damaged; run verify");
    }
    PersonParticipation held;
    held.participant = std::move(participants->front());
    held.runs = *std::move(runs);
    const bool done = held.participant.state == ParticipantState::completed ||
                      held.participant.state == ParticipantState::withdrawn;
    const bool handedOut = own && done && blinding->seals();
    held.sealed = blinding->seals() && !handedOut;
    for (QuestionnaireAnswer& answer : *answers) {
        // Included like the trials: by run, without the names by which experimenters know the condition.
        held.answers.push_back(handedOut ? std::move(answer) : sealed(std::move(answer), *blinding));
        if (handedOut) {
            held.answers.back().condition.clear();
            held.answers.back().sealedCode.clear();
        }
    }
    for (StudyRun& run : held.runs) {
        if (handedOut) {
            // Together with its trials the code would reveal its condition to everybody.
            run.sealedCode.clear();
        }
        auto trials = handedOut ? studyTrialRows(connection, run.id) : shownTrials(connection, run.id);
        CHIRON_TRY(trials);
        held.trials.insert(held.trials.end(), trials->begin(), trials->end());
    }
    const auto added = addStudy(connection, held);
    CHIRON_TRY(added);
    return held;
}

} // namespace

core::Result<std::vector<PersonParticipation>> participationsOf(Connection& connection, PersonId person,
                                                                bool own) {
    const auto ids = participantsOf(connection, person);
    CHIRON_TRY(ids);
    std::vector<PersonParticipation> all;
    for (const ParticipantNumber id : *ids) {
        auto one = participation(connection, id, own);
        CHIRON_TRY(one);
        all.push_back(*std::move(one));
    }
    return all;
}

core::Result<Erasure> PrivacyRepository::eraseParticipant(ParticipantNumber participant,
                                                          const std::string& reason) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authoriseForStudy(m_connection, m_actor, Action::eraseParticipant, StudyPart::participant,
                                 participant));
    if (auto good = checkText("reason", reason, 1000); !good || reason.empty()) {
        CHIRON_TRY(good);
        return core::fail(core::ErrorCode::badInput, "reason: expected a text");
    }
    const auto state =
        selectText(m_connection, "SELECT state FROM study_participant WHERE id = ?", {participant});
    const auto running = selectInteger(
        m_connection,
        "SELECT count(*) FROM session WHERE state = 'running' AND id IN (SELECT t.session_id "
        "FROM recorded_sitting t JOIN study_run r ON r.id = t.run_id WHERE r.participant_id = ?)",
        {participant});
    CHIRON_TRY(state);
    CHIRON_TRY(running);
    if (state->value_or("") != "withdrawn" || running->value_or(0) > 0) {
        return core::fail(core::ErrorCode::wrongUse,
                          running->value_or(0) > 0
                              ? "a session of this participant has not ended yet"
                              : "the participant has not withdrawn: withdraw first, then erase");
    }
    Erasure erasure;
    erasure.reason = reason;
    erasure.administrator = m_actor.personId();
    return overwriteParticipant(m_connection, m_actor, participant, std::move(erasure));
}

} // namespace chiron::database
