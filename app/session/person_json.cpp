// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/person_json.h"

#include "session/score_json.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace chiron::session {

namespace {

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

QJsonValue parsed(const std::string& json) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json));
    return document.isArray()    ? QJsonValue(document.array())
           : document.isObject() ? QJsonValue(document.object())
                                 : QJsonValue(text(json));
}

QJsonArray roleWords(const database::RoleSet& roles) {
    QJsonArray words;
    for (const std::string& word : roles.tokens())
        words.append(text(word));
    return words;
}

QJsonObject commentJson(const database::SessionComment& comment) {
    return {{QStringLiteral("id"), static_cast<qint64>(comment.id)},
            {QStringLiteral("author"), static_cast<qint64>(comment.author)},
            {QStringLiteral("utc"), text(comment.utc)},
            {QStringLiteral("text"), text(comment.text)},
            {QStringLiteral("tick"),
             comment.tick ? QJsonValue(static_cast<qint64>(*comment.tick)) : QJsonValue()}};
}

QJsonArray commentsJson(const std::vector<database::SessionComment>& comments) {
    QJsonArray array;
    for (const database::SessionComment& comment : comments)
        array.append(commentJson(comment));
    return array;
}

QJsonObject trialJson(const database::TrialRecord& trial) {
    const std::string_view state = database::token(trial.state);
    return {{QStringLiteral("trial"), trial.index + 1},
            {QStringLiteral("seed"), QString::number(trial.seed)},
            {QStringLiteral("state"), QString::fromUtf8(state.data(), static_cast<qsizetype>(state.size()))},
            {QStringLiteral("first_tick"), static_cast<qint64>(trial.firstTick)},
            {QStringLiteral("last_tick"), static_cast<qint64>(trial.lastTick)},
            {QStringLiteral("marked"), trial.marked},
            {QStringLiteral("timed_out"), trial.timedOut},
            {QStringLiteral("scene"), parsed(trial.sceneJson)}};
}

QJsonObject sessionJson(const database::PersonSession& session) {
    const database::SessionSummary& summary = session.record.summary;
    const std::string_view state = database::token(summary.state);
    QJsonArray trials;
    for (const database::TrialRecord& trial : session.trials)
        trials.append(trialJson(trial));
    QJsonArray events;
    for (const database::EventRecord& event : session.events)
        events.append(QJsonObject{{QStringLiteral("tick"), static_cast<qint64>(event.tick)},
                                  {QStringLiteral("time_s"), event.time_s},
                                  {QStringLiteral("tool"), event.tool},
                                  {QStringLiteral("kind"), text(event.kind)},
                                  {QStringLiteral("detail"), parsed(event.detailJson)}});
    QJsonObject json{
        {QStringLiteral("session_id"), static_cast<qint64>(summary.id)},
        {QStringLiteral("exercise"), text(summary.exercise)},
        {QStringLiteral("level"), summary.level},
        {QStringLiteral("state"), QString::fromUtf8(state.data(), static_cast<qsizetype>(state.size()))},
        {QStringLiteral("started_utc"), text(summary.startedUtc)},
        {QStringLiteral("utc_offset_min"), summary.utcOffset_min},
        {QStringLiteral("ended_utc"), text(session.record.endedUtc)},
        {QStringLiteral("felt"), summary.felt},
        {QStringLiteral("familiarisation"), summary.familiarisation},
        {QStringLiteral("void_reason"), text(session.record.voidReason)},
        {QStringLiteral("content"), parsed(session.record.setup.contentJson)},
        {QStringLiteral("content_sha256"), text(session.record.contentSha256)},
        {QStringLiteral("device"), parsed(session.record.setup.deviceJson)},
        {QStringLiteral("recording"),
         QJsonObject{{QStringLiteral("frames"), static_cast<qint64>(summary.frames)},
                     {QStringLiteral("dropped"), static_cast<qint64>(summary.dropped)},
                     {QStringLiteral("bytes"), static_cast<qint64>(summary.recordingBytes)}}},
        {QStringLiteral("trials"), trials},
        {QStringLiteral("events"), events},
        {QStringLiteral("comments"), commentsJson(session.comments)}};
    if (summary.attempt > 0)
        json[QStringLiteral("attempt")] = summary.attempt;
    if (!session.record.decisions.empty())
        json[QStringLiteral("decisions")] = decisionsJson(session.record.decisions);
    if (session.sealed) {
        json[QStringLiteral("sealed")] = true;
        // Its size would reveal the condition of a blinded study.
        json[QStringLiteral("recording")] = QJsonValue();
    }
    if (session.scores) {
        json[QStringLiteral("passed")] = session.scores->passed;
        json[QStringLiteral("metrics")] = metricsJson(session.scores->metrics);
    }
    return json;
}

QJsonObject studyTrialJson(const database::StudyTrial& trial) {
    return {{QStringLiteral("run"), static_cast<qint64>(trial.run)},
            {QStringLiteral("ordinal"), trial.ordinal},
            {QStringLiteral("session_id"), static_cast<qint64>(trial.session)},
            {QStringLiteral("candidate"), trial.candidate},
            {QStringLiteral("arrangement"), trial.arrangement},
            {QStringLiteral("difference"), trial.difference},
            {QStringLiteral("answer"), trial.answer},
            {QStringLiteral("outcome"), trial.outcome},
            {QStringLiteral("value"), trial.value ? QJsonValue(*trial.value) : QJsonValue()},
            {QStringLiteral("exploration_s"), trial.exploration_s},
            {QStringLiteral("answer_s"), trial.answer_s},
            {QStringLiteral("device"), text(trial.device)},
            {QStringLiteral("felt"), trial.felt ? QJsonValue(*trial.felt) : QJsonValue()},
            {QStringLiteral("practice"), trial.practice},
            {QStringLiteral("spoiled"), text(trial.spoiled)},
            {QStringLiteral("fidelity"), parsed(trial.fidelityJson)},
            {QStringLiteral("utc"), text(trial.utc)}};
}

// The data of a person as a participant of a study.
QJsonObject participationJson(const database::PersonParticipation& held) {
    QJsonArray runs;
    for (const database::StudyRun& run : held.runs)
        runs.append(QJsonObject{
            {QStringLiteral("run"), static_cast<qint64>(run.id)},
            {QStringLiteral("condition"), text(run.condition.empty() ? run.sealedCode : run.condition)},
            {QStringLiteral("started_utc"), text(run.startedUtc)},
            {QStringLiteral("ended_utc"), text(run.endedUtc)}});
    QJsonArray trials;
    for (const database::StudyTrial& trial : held.trials)
        trials.append(studyTrialJson(trial));
    QJsonArray answers;
    for (const database::QuestionnaireAnswer& answer : held.answers)
        answers.append(
            QJsonObject{{QStringLiteral("questionnaire"), text(answer.questionnaire)},
                        {QStringLiteral("item"), text(answer.item)},
                        {QStringLiteral("number"), answer.number ? QJsonValue(*answer.number) : QJsonValue()},
                        {QStringLiteral("text"), text(answer.text)},
                        {QStringLiteral("utc"), text(answer.utc)},
                        {QStringLiteral("run"),
                         answer.run != 0 ? QJsonValue(static_cast<qint64>(answer.run)) : QJsonValue()},
                        {QStringLiteral("language"),
                         answer.language.empty() ? QJsonValue() : QJsonValue(text(answer.language))}});
    return {{QStringLiteral("study"), text(held.studyKey)},
            {QStringLiteral("title"), text(held.studyTitle)},
            {QStringLiteral("code"), text(held.participant.code)},
            {QStringLiteral("identity"), text(held.identity)},
            {QStringLiteral("enrolled_utc"), text(held.participant.enrolledUtc)},
            {QStringLiteral("consent_utc"), text(held.participant.consentUtc)},
            {QStringLiteral("consent_sha256"), text(held.participant.consentSha256)},
            {QStringLiteral("runs"), runs},
            {QStringLiteral("trials"), trials},
            {QStringLiteral("trials_sealed"), held.sealed}, // released once the study is unblinded
            {QStringLiteral("answers"), answers}};
}

} // namespace

QJsonArray decisionsJson(const std::vector<database::SessionDecision>& decisions) {
    QJsonArray array;
    for (const database::SessionDecision& decision : decisions)
        array.append(QJsonObject{{QStringLiteral("decision"),
                                  decision.voiding ? QStringLiteral("void") : QStringLiteral("reinstate")},
                                 {QStringLiteral("person"), static_cast<qint64>(decision.person)},
                                 {QStringLiteral("utc"), text(decision.utc)},
                                 {QStringLiteral("reason"), text(decision.reason)}});
    return array;
}

QJsonObject personJson(const database::Person& person) {
    return {{QStringLiteral("id"), static_cast<qint64>(person.id)},
            {QStringLiteral("name"), text(person.name)},
            {QStringLiteral("display_name"), text(person.displayName)},
            {QStringLiteral("code"), text(person.code)},
            {QStringLiteral("roles"), roleWords(person.roles)},
            {QStringLiteral("enabled"), person.enabled},
            {QStringLiteral("must_change_password"), person.mustChangePassword},
            {QStringLiteral("created"), text(person.createdUtc)}};
}

QJsonObject personExportJson(const database::PersonExport& everything) {
    QJsonArray sessions;
    for (const database::PersonSession& session : everything.sessions)
        sessions.append(sessionJson(session));
    QJsonArray audit;
    for (const database::AuditEntry& entry : everything.audit)
        audit.append(QJsonObject{{QStringLiteral("sequence"), static_cast<qint64>(entry.sequence)},
                                 {QStringLiteral("utc"), text(entry.utc)},
                                 {QStringLiteral("actor_kind"), text(entry.actorKind)},
                                 {QStringLiteral("actor"), static_cast<qint64>(entry.actor)},
                                 {QStringLiteral("action"), text(entry.action)},
                                 {QStringLiteral("target"), text(entry.target)},
                                 {QStringLiteral("target_id"), static_cast<qint64>(entry.targetId)},
                                 {QStringLiteral("detail"), parsed(entry.detailJson)}});
    QJsonArray earlier;
    for (const database::EarlierName& before : everything.earlierNames)
        earlier.append(QJsonObject{{QStringLiteral("name"), text(before.name)},
                                   {QStringLiteral("display_name"), text(before.displayName)},
                                   {QStringLiteral("until_utc"), text(before.untilUtc)},
                                   {QStringLiteral("changed_by"), static_cast<qint64>(before.changedBy)}});
    QJsonArray participations;
    for (const database::PersonParticipation& held : everything.participations)
        participations.append(participationJson(held));
    return {{QStringLiteral("person"), personJson(everything.person)},
            {QStringLiteral("earlier_names"), earlier},
            {QStringLiteral("has_password"), everything.hasPassword},
            {QStringLiteral("failed_logins"), everything.failedLogins},
            {QStringLiteral("sessions"), sessions},
            {QStringLiteral("comments_written"), commentsJson(everything.commentsWritten)},
            {QStringLiteral("participations"), participations},
            {QStringLiteral("audit"), audit}};
}

} // namespace chiron::session
