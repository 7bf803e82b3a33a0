// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_rows.h"

#include "database/repositories/study_rules.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <limits>

namespace chiron::database {
namespace {

Participant participantOf(const Query& row) {
    Participant participant;
    participant.id = row.integer(0);
    participant.study = row.integer(1);
    participant.code = row.text(2);
    participant.order = static_cast<int>(row.integer(3));
    participant.state = participantStateFromToken(row.text(4)).value_or(ParticipantState::withdrawn);
    participant.simulated = row.integer(5) != 0;
    participant.observer = row.text(6);
    participant.enrolledBy = row.integer(7);
    participant.enrolledUtc = row.text(8);
    participant.recordingsToErase = row.integer(9) != 0;
    participant.consentUtc = row.text(10);
    participant.consentSha256 = row.text(11);
    participant.erased = row.integer(12) != 0;
    return participant;
}

StudyRun runOf(const Query& row) {
    StudyRun run;
    run.id = row.integer(0);
    run.participant = row.integer(1);
    run.condition = row.text(2);
    run.sealedCode = row.text(3);
    run.position = static_cast<int>(row.integer(4));
    run.seed = unsignedFromStored(row.integer(5));
    run.procedures = row.text(6);
    run.state = studyRunStateFromToken(row.text(7)).value_or(StudyRunState::stopped);
    run.startedUtc = row.text(8);
    run.endedUtc = row.text(9);
    return run;
}

// Returns the model of the first device or, without a model, its driver.
std::string deviceOf(const std::string& deviceJson) {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(deviceJson)).object();
    const QJsonObject first = json["tools"].toArray().first().toObject();
    const QString model = first["model"].toString();
    return (model.isEmpty() ? first["driver"].toString() : model).toStdString();
}

StudyTrial trialOf(const Query& row) {
    StudyTrial trial;
    trial.run = row.integer(0);
    trial.ordinal = static_cast<int>(row.integer(1));
    trial.procedure = static_cast<int>(row.integer(2));
    trial.session = row.isNull(3) ? 0 : row.integer(3);
    trial.firstTick = unsignedFromStored(row.integer(4));
    trial.lastTick = unsignedFromStored(row.integer(5));
    trial.candidate = static_cast<int>(row.integer(6));
    trial.arrangement = static_cast<int>(row.integer(7));
    trial.difference = row.real(8);
    trial.entropyMargin = row.isNull(9) ? std::numeric_limits<double>::quiet_NaN() : row.real(9);
    trial.answer = static_cast<int>(row.integer(10));
    trial.outcome = static_cast<int>(row.integer(11));
    trial.value = row.isNull(12) ? std::nullopt : std::optional(row.real(12));
    trial.exploration_s = row.real(13);
    trial.answer_s = row.real(14);
    trial.practice = row.integer(15) != 0;
    trial.undone = row.integer(16) != 0;
    trial.spoiled = row.text(17);
    trial.fidelityJson = row.text(18);
    trial.utc = row.text(19);
    if (!row.isNull(20)) {
        trial.felt = row.integer(20) != 0;
        trial.device = deviceOf(row.text(21));
    }
    return trial;
}

QuestionnaireAnswer answerOf(const Query& row) {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(row.text(3))).object();
    QuestionnaireAnswer answer{
        row.integer(0), row.text(1), row.text(2), {}, json["text"].toString().toStdString(), row.text(4)};
    answer.run = row.isNull(5) ? 0 : row.integer(5);
    answer.language = row.isNull(6) ? std::string() : row.text(6);
    answer.condition = row.text(7);
    answer.sealedCode = row.text(8);
    if (json["number"].isDouble()) {
        answer.number = json["number"].toDouble();
    }
    return answer;
}

} // namespace

core::Result<std::vector<Participant>> participantRows(Connection& connection, const std::string& where,
                                                       const std::vector<Value>& values) {
    return rowsOf<Participant>(
        connection,
        "SELECT p.id, p.study_id, p.code, p.order_row, p.state, p.simulated, p.observer, p.enrolled_by, "
        "p.enrolled_utc, p.erase_recordings, coalesce(c.utc, ''), coalesce(lower(hex(c.sha256)), ''), "
        "EXISTS (SELECT 1 FROM participant_erasure e WHERE e.id = p.id) FROM study_participant p LEFT JOIN "
        "participant_consent c ON c.id = p.id WHERE " +
            where + " ORDER BY p.id",
        values, participantOf);
}

core::Result<std::vector<SealedCondition>> sealedConditionRows(Connection& connection, StudyNumber study) {
    return rowsOf<SealedCondition>(
        connection, "SELECT condition, sealed_code FROM study_condition WHERE study_id = ? ORDER BY ordinal",
        {study}, [](const Query& row) {
            return SealedCondition{row.text(0), row.text(1)};
        });
}

core::Result<std::vector<StudyRun>> runRows(Connection& connection, ParticipantNumber participant) {
    return rowsOf<StudyRun>(
        connection,
        "SELECT id, participant_id, condition, sealed_code, position, seed, procedures, state, "
        "started_utc, ended_utc FROM study_run WHERE participant_id = ? ORDER BY id",
        {participant}, runOf);
}

core::Result<std::vector<StudyTrial>> studyTrialRows(Connection& connection, StudyRunNumber run) {
    return rowsOf<StudyTrial>(
        connection,
        "SELECT run_id, ordinal, procedure, session_id, first_tick, last_tick, candidate, arrangement, "
        "difference, "
        "entropy_margin, answer, outcome, value, exploration_s, answer_s, practice, undone, spoiled, "
        "fidelity_json, t.utc, x.felt, x.device_json "
        "FROM study_trial t LEFT JOIN session x ON x.id = t.session_id WHERE run_id = ? ORDER BY ordinal",
        {run}, trialOf);
}

core::Result<std::vector<QuestionnaireAnswer>> answerRows(Connection& connection, const std::string& where,
                                                          std::int64_t number) {
    return rowsOf<QuestionnaireAnswer>(connection,
                                       "SELECT a.participant_id, a.questionnaire, a.item, a.answer_json, "
                                       "a.utc, a.run_id, a.language, coalesce(r.condition, ''), "
                                       "coalesce(r.sealed_code, '') FROM questionnaire_answer a JOIN "
                                       "study_participant p ON p.id = a.participant_id "
                                       "LEFT JOIN study_run r ON r.id = a.run_id WHERE " +
                                           where + " ORDER BY a.participant_id, a.id",
                                       {number}, answerOf);
}

} // namespace chiron::database
