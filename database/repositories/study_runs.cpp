// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/repositories/study_repository.h"
#include "database/repositories/study_rules.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

// The conduct of a study: runs, trials, questionnaires.
namespace chiron::database {
namespace {

constexpr std::size_t kMaximumFidelityBytes = 65536;

core::Result<void> bad(const std::string& message) {
    return core::fail(core::ErrorCode::badInput, message);
}

// A condition can have one open or completed run; a stopped one may be begun again.
core::Result<void> notYetRun(Connection& connection, const NewStudyRun& run, const std::string& condition) {
    auto query = Query::run(
        connection,
        "SELECT id, state FROM study_run WHERE participant_id = ? AND condition = ? AND state <> 'stopped'",
        {run.participant, condition});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    return *row ? core::fail(core::ErrorCode::wrongUse, "condition " + run.condition + " has a run (number " +
                                                            std::to_string(query->integer(0)) + ") that is " +
                                                            query->text(1) + ": an open one is resumed")
                : core::Result<void>();
}

core::Result<void> checkTrial(const StudyTrial& trial) {
    const bool finite = std::isfinite(trial.difference) && std::isfinite(trial.exploration_s) &&
                        std::isfinite(trial.answer_s) && (!trial.value || std::isfinite(*trial.value));
    if (!finite || trial.exploration_s < 0.0 || trial.answer_s < 0.0 || std::abs(trial.difference) > 1000.0) {
        return bad("trial " + std::to_string(trial.ordinal) +
                   ": expected finite numbers and times of 0 or more");
    }
    if (trial.candidate < 0 || trial.candidate > 4095 || trial.arrangement < 0 || trial.arrangement > 15) {
        return bad("trial " + std::to_string(trial.ordinal) +
                   ": expected a candidate of 0 to 4095 and an arrangement of 0 to 15");
    }
    if (trial.answer < -1 || trial.outcome < -1 || trial.procedure < 0 || trial.lastTick < trial.firstTick) {
        return bad("trial " + std::to_string(trial.ordinal) +
                   ": expected answer and outcome from -1, procedure from 0, "
                   "last tick not before the first");
    }
    const QJsonDocument fidelity = QJsonDocument::fromJson(QByteArray::fromStdString(trial.fidelityJson));
    if (!fidelity.isObject() || trial.fidelityJson.size() > kMaximumFidelityBytes) {
        return bad("trial " + std::to_string(trial.ordinal) +
                   ": fidelity: expected a JSON object of at most 64 KiB");
    }
    return checkText("spoiled", trial.spoiled, 40);
}

core::Result<void> followsOn(Connection& connection, const Actor& actor, const StudyTrial& trial) {
    const auto state = selectText(connection, "SELECT state FROM study_run WHERE id = ?", {trial.run});
    const auto last =
        selectInteger(connection, "SELECT max(ordinal) FROM study_trial WHERE run_id = ?", {trial.run});
    const auto owner =
        selectInteger(connection, "SELECT person_id FROM session WHERE id = ?", {trial.session});
    CHIRON_TRY(state);
    CHIRON_TRY(last);
    CHIRON_TRY(owner);
    if (state->value_or("") != "open") {
        return core::fail(core::ErrorCode::wrongUse,
                          "run " + std::to_string(trial.run) + " has ended (" + state->value_or("") + ")");
    }
    if (trial.ordinal != last->value_or(-1) + 1) {
        return bad("trial " + std::to_string(trial.ordinal) + ": expected " +
                   std::to_string(last->value_or(-1) + 1) + ", the run's next");
    }
    if (trial.session != 0 && owner->value_or(0) != actor.personId()) {
        return bad("session " + std::to_string(trial.session) + ": expected one of whoever stores the trial");
    }
    return {};
}

std::vector<Column> columnsOf(const StudyTrial& trial) {
    const auto number = [](int value) { return Value(std::int64_t{value}); };
    return {{"run_id", trial.run},
            {"ordinal", number(trial.ordinal)},
            {"procedure", number(trial.procedure)},
            {"session_id", trial.session != 0 ? Value(trial.session) : Value()},
            {"first_tick", storedFromUnsigned(trial.firstTick)},
            {"last_tick", storedFromUnsigned(trial.lastTick)},
            {"candidate", number(trial.candidate)},
            {"arrangement", number(trial.arrangement)},
            {"difference", trial.difference},
            {"entropy_margin", std::isfinite(trial.entropyMargin) ? Value(trial.entropyMargin) : Value()},
            {"answer", number(trial.answer)},
            {"outcome", number(trial.outcome)},
            {"value", trial.value ? Value(*trial.value) : Value()},
            {"exploration_s", trial.exploration_s},
            {"answer_s", trial.answer_s},
            {"practice", number(trial.practice)},
            {"undone", number(trial.undone)},
            {"spoiled", trial.spoiled},
            {"fidelity_json", trial.fidelityJson},
            {"utc", trial.utc.empty() ? core::utcNowIso8601() : trial.utc}};
}

std::string answerJson(const QuestionnaireAnswer& answer) {
    QJsonObject json{{"nonce", QString::fromStdString(randomNonce())}};
    if (answer.number) {
        json["number"] = *answer.number;
    } else {
        json["text"] = QString::fromStdString(answer.text);
    }
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

/// An enrolment questionnaire may be answered before the consent, and any questionnaire after the last run.
core::Result<void> mayAnswer(const StoredParticipant& who, const QJsonObject& design,
                             const std::string& questionnaire) {
    const bool early = who.state == ParticipantState::enrolled && isEnrolment(design, questionnaire);
    return early || who.state == ParticipantState::completed ? core::Result<void>() : mayRun(who);
}

/// An answer that belongs to a run is accepted only once that run is completed.
core::Result<void> checkRunOf(Connection& connection, const QuestionnaireAnswer& answer) {
    if (answer.run == 0) {
        return {};
    }
    const auto state =
        selectText(connection, "SELECT state FROM study_run WHERE id = ? AND participant_id = ?",
                   {answer.run, answer.participant});
    CHIRON_TRY(state);
    const std::string place =
        "answer " + answer.questionnaire + "." + answer.item + ": run " + std::to_string(answer.run);
    if (!*state) {
        return bad(place + ": expected a run of this participant");
    }
    return **state == "completed" ? core::Result<void>()
                                  : core::fail(core::ErrorCode::wrongUse,
                                               place + " is " + **state + ": expected it to be completed");
}

core::Result<void> storeAnswer(Connection& connection, const Actor& actor,
                               const QuestionnaireAnswer& answer) {
    const auto last = selectInteger(connection, "SELECT max(id) FROM questionnaire_answer");
    const auto there = selectInteger(connection,
                                     "SELECT 1 FROM questionnaire_answer WHERE participant_id = ? AND "
                                     "questionnaire = ? AND item = ? AND coalesce(run_id, 0) = ?",
                                     {answer.participant, answer.questionnaire, answer.item, answer.run});
    CHIRON_TRY(last);
    CHIRON_TRY(there);
    if (*there) {
        return core::fail(core::ErrorCode::wrongUse, "answer " + answer.questionnaire + "." + answer.item +
                                                         " was given already, and answers are not changed");
    }
    const std::int64_t id = last->value_or(0) + 1;
    const std::string json = answerJson(answer);
    const auto row = insertRow(connection, "questionnaire_answer",
                               {{"id", id},
                                {"participant_id", answer.participant},
                                {"questionnaire", answer.questionnaire},
                                {"item", answer.item},
                                {"answer_json", json},
                                {"answer_hash", toBlob(textDigest(json))},
                                {"utc", answer.utc.empty() ? core::utcNowIso8601() : answer.utc},
                                {"run_id", answer.run != 0 ? Value(answer.run) : Value()},
                                {"language", answer.language.empty() ? Value() : Value(answer.language)}});
    CHIRON_TRY(row);
    return appendAudit(connection, actor,
                       {"storeQuestionnaireAnswers", "questionnaire_answer", id, *row, "{}"});
}

} // namespace

core::Result<StudyRunNumber> StudyRepository::beginRun(const NewStudyRun& run) {
    auto good =
        mayWriteStudy(m_connection, m_actor, Action::beginRun, StudyPart::participant, run.participant);
    CHIRON_TRY(good);
    const auto who = storedParticipant(m_connection, run.participant);
    CHIRON_TRY(who);
    const auto study = studyInState(m_connection, who->study, "frozen");
    CHIRON_TRY(study);
    const auto named = namedCondition(m_connection, *study, run.condition);
    const auto last = selectInteger(m_connection, "SELECT max(id) FROM study_run");
    CHIRON_TRY(named);
    CHIRON_TRY(last);
    good = mayRun(*who);
    good = good ? notYetRun(m_connection, run, named->condition) : good;
    good = good ? checkText("procedures", run.procedures, 1000) : good;
    if (good && (run.procedures.empty() || run.position < 0 || run.position > 1000)) {
        good = bad("run: expected the procedures' ids and a position from 0");
    }
    CHIRON_TRY(good);
    const StudyRunNumber id = last->value_or(0) + 1;
    const auto row = insertRow(m_connection, "study_run",
                               {{"id", id},
                                {"participant_id", run.participant},
                                {"condition", named->condition},
                                {"sealed_code", named->sealedCode},
                                {"position", std::int64_t{run.position}},
                                {"seed", storedFromUnsigned(run.seed)},
                                {"procedures", run.procedures},
                                {"begun_by", m_actor.personId()},
                                {"state", std::string("open")},
                                {"started_utc", core::utcNowIso8601()},
                                {"ended_utc", std::string()},
                                {"trials", std::int64_t{0}}});
    CHIRON_TRY(row);
    auto audited = appendAudit(m_connection, m_actor, {"beginRun", "study_run", id, *row, "{}"});
    CHIRON_TRY(audited);
    return id;
}

core::Result<void> StudyRepository::storeStudyTrial(const StudyTrial& trial) {
    auto good = mayWriteStudy(m_connection, m_actor, Action::storeStudyTrial, StudyPart::run, trial.run);
    good = good ? checkTrial(trial) : good;
    good = good ? followsOn(m_connection, m_actor, trial) : good;
    CHIRON_TRY(good);
    const auto row = insertRow(m_connection, "study_trial", columnsOf(trial));
    CHIRON_TRY(row);
    return {};
}

core::Result<void> StudyRepository::finishRun(StudyRunNumber run, StudyRunState state) {
    CHIRON_TRY(mayWriteStudy(m_connection, m_actor, Action::finishRun, StudyPart::run, run));
    const auto present = selectText(m_connection, "SELECT state FROM study_run WHERE id = ?", {run});
    CHIRON_TRY(present);
    if (present->value_or("") != "open") {
        return core::fail(core::ErrorCode::wrongUse,
                          "run " + std::to_string(run) + " has ended (" + present->value_or("") + ")");
    }
    return state == StudyRunState::open ? bad("a run ends completed or stopped")
                                        : endRun(m_connection, m_actor, run, state);
}

core::Result<void>
StudyRepository::storeQuestionnaireAnswers(const std::vector<QuestionnaireAnswer>& answers) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authorise(m_connection, m_actor, Action::storeQuestionnaireAnswers));
    for (const QuestionnaireAnswer& answer : answers) {
        auto good = authoriseForStudy(m_connection, m_actor, Action::storeQuestionnaireAnswers,
                                      StudyPart::participant, answer.participant);
        CHIRON_TRY(good);
        const auto who = storedParticipant(m_connection, answer.participant);
        CHIRON_TRY(who);
        const auto study = storedStudy(m_connection, who->study);
        CHIRON_TRY(study);
        const auto design = designObject(study->designJson);
        CHIRON_TRY(design);
        good = good ? mayAnswer(*who, *design, answer.questionnaire) : good;
        good = good ? checkAnswer(*design, answer) : good;
        good = good ? checkRunOf(m_connection, answer) : good;
        good = good ? storeAnswer(m_connection, m_actor, answer) : good;
        CHIRON_TRY(good);
    }
    return {};
}

} // namespace chiron::database
