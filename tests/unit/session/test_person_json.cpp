// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody gets who asks what is held of them: every field under its own name, and nothing else.
#include "session/person_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>

using namespace chiron;

class TestPersonJson : public QObject {
    Q_OBJECT
private slots:
    void everythingIsNamed();
    void whatIsAbsentIsNull();
    void aSealedSittingTellsNoLength();
};

namespace {

database::PersonExport everything() {
    database::PersonExport held;
    held.person = {7,     "tim", "Tim \"T\" Ö", "K7M-4QX", {database::Role::trainee, database::Role::admin},
                   false, true,  "created"};
    held.hasPassword = true;
    held.failedLogins = 2;
    held.commentsWritten = {{31, 7, "comment utc", "a word", 42}, {32, 8, "later", "of the whole", {}}};
    held.audit = {{51, "audit utc", "person", 7, "login", "person", 52, R"({"row":"ab"})"}};
    database::PersonSession session;
    database::SessionSummary& line = session.record.summary;
    line.id = 61;
    line.exercise = "palpation";
    line.level = 3;
    line.state = database::SessionState::stopped;
    line.startedUtc = "started";
    line.utcOffset_min = 345;
    line.felt = true;
    line.familiarisation = true;
    line.frames = 1001;
    line.dropped = 1002;
    line.recordingBytes = 1003;
    session.record.endedUtc = "ended";
    session.record.voidReason = "void";
    session.record.contentSha256 = "sha";
    session.record.setup.contentJson = R"({"level":3})";
    session.record.setup.deviceJson = "[1,2]";
    session.trials = {{4, 0xfedcba9876543210ULL, database::SessionState::completed, 11, 22, true, false,
                       R"({"R_m":0.02})"}};
    session.events = {{17, 0.25, 1, "marked", "no JSON"}};
    session.comments = {{33, 9, "utc", "of this one", 44}};
    session.scores = scoring::ScoreCard{};
    session.scores->passed = true;
    session.scores->metrics = {{"path_length", 1, "m", 0.5, "", true}};
    held.sessions = {session};
    held.earlierNames = {{61, "timmy", "Timmy Ö", "renamed", 8}};
    database::PersonParticipation part;
    part.studyKey = "soft";
    part.studyTitle = "Softness";
    part.participant.code = "A-1";
    part.participant.enrolledUtc = "enrolled";
    part.participant.consentUtc = "consented";
    part.participant.consentSha256 = "consent sha";
    part.identity = "ward 3";
    part.sealed = true;
    database::StudyRun open, sealed;
    open.id = 71;
    open.condition = "hard";
    open.sealedCode = "Q7M";
    open.startedUtc = "run begun";
    open.endedUtc = "run ended";
    sealed.id = 72;
    sealed.sealedCode = "Q8M";
    part.runs = {open, sealed};
    database::StudyTrial trial;
    trial.run = 71;
    trial.ordinal = 81;
    trial.session = 82;
    trial.candidate = 83;
    trial.arrangement = 84;
    trial.difference = 0.125;
    trial.answer = 85;
    trial.outcome = 86;
    trial.value = 0.75;
    trial.exploration_s = 1.5;
    trial.answer_s = 2.5;
    trial.device = "arm";
    trial.felt = true;
    trial.practice = true;
    trial.spoiled = "speed";
    trial.fidelityJson = R"({"contacts":3})";
    trial.utc = "trial utc";
    part.trials = {trial};
    part.answers = {{7, "face", "real", 4.0, "", "answer utc"},
                    {7, "face", "remarks", {}, "soft", "later utc"}};
    held.participations = {part};
    return held;
}

constexpr const char* kSession =
    R"({"session_id":61,"exercise":"palpation","level":3,"state":"stopped","started_utc":"started","utc_offset_min":345,"ended_utc":"ended",
  "felt":true,"familiarisation":true,"void_reason":"void","content":{"level":3},"content_sha256":"sha","device":[1,2],
  "recording":{"frames":1001,"dropped":1002,"bytes":1003},
  "trials":[{"trial":5,"seed":"18364758544493064720","state":"completed","first_tick":11,"last_tick":22,"marked":true,"timed_out":false,"scene":{"R_m":0.02}}],
  "events":[{"tick":17,"time_s":0.25,"tool":1,"kind":"marked","detail":"no JSON"}],
  "comments":[{"id":33,"author":9,"utc":"utc","text":"of this one","tick":44}],
  "passed":true})";

QJsonObject objectOf(const char* text) {
    QJsonParseError error;
    const QJsonObject object = QJsonDocument::fromJson(text, &error).object();
    if (error.error != QJsonParseError::NoError)
        qFatal("the test's own JSON: %s at %d", qPrintable(error.errorString()),
               static_cast<int>(error.offset));
    return object;
}

QByteArray textOf(const QJsonValue& value) {
    return value.isArray() ? QJsonDocument(value.toArray()).toJson()
                           : QJsonDocument(value.toObject()).toJson();
}

} // namespace

void TestPersonJson::everythingIsNamed() {
    const QJsonObject json = session::personExportJson(everything());
    QCOMPARE(json.keys(), (QStringList{"audit", "comments_written", "earlier_names", "failed_logins",
                                       "has_password", "participations", "person", "sessions"}));
    QCOMPARE(json["has_password"].toBool(), true);
    QCOMPARE(json["failed_logins"].toInt(), 2);
    QCOMPARE(
        textOf(json["person"]),
        textOf(objectOf(
            R"({"id":7,"name":"tim","display_name":"Tim \"T\" Ö","code":"K7M-4QX","roles":["trainee","admin"],"enabled":false,
        "must_change_password":true,"created":"created"})")));
    QCOMPARE(textOf(json["earlier_names"]),
             textOf(objectOf(
                 R"({"a":[{"name":"timmy","display_name":"Timmy Ö","until_utc":"renamed","changed_by":8}]})")
                        ["a"]));
    QCOMPARE(textOf(json["comments_written"]),
             textOf(objectOf(R"({"a":[{"id":31,"author":7,"utc":"comment utc","text":"a word","tick":42},
        {"id":32,"author":8,"utc":"later","text":"of the whole","tick":null}]})")["a"]));
    QCOMPARE(
        textOf(json["audit"]),
        textOf(objectOf(
            R"({"a":[{"sequence":51,"utc":"audit utc","actor_kind":"person","actor":7,"action":"login","target":"person",
        "target_id":52,"detail":{"row":"ab"}}]})")["a"]));
    QJsonObject session = json["sessions"][0].toObject();
    QCOMPARE(session["metrics"].toArray().size(), 1);
    QCOMPARE(session["metrics"][0]["id"].toString(), QStringLiteral("path_length"));
    session.remove("metrics");
    QCOMPARE(textOf(session), textOf(objectOf(kSession)));
    QCOMPARE(
        textOf(json["participations"]),
        textOf(objectOf(
            R"({"a":[{"study":"soft","title":"Softness","code":"A-1","identity":"ward 3","enrolled_utc":"enrolled",
        "consent_utc":"consented","consent_sha256":"consent sha","trials_sealed":true,
        "runs":[{"run":71,"condition":"hard","started_utc":"run begun","ended_utc":"run ended"},{"run":72,"condition":"Q8M","started_utc":"","ended_utc":""}],
        "trials":[{"run":71,"ordinal":81,"session_id":82,"candidate":83,"arrangement":84,"difference":0.125,"answer":85,"outcome":86,"value":0.75,"exploration_s":1.5,
                   "answer_s":2.5,"device":"arm","felt":true,"practice":true,"spoiled":"speed","fidelity":{"contacts":3},"utc":"trial utc"}],
        "answers":[{"questionnaire":"face","item":"real","number":4,"text":"","utc":"answer utc","run":null,"language":null},
                   {"questionnaire":"face","item":"remarks","number":null,"text":"soft","utc":"later utc","run":null,"language":null}]}]})")
                   ["a"]));
}

void TestPersonJson::whatIsAbsentIsNull() {
    database::PersonExport held = everything();
    held.sessions[0].scores.reset();
    held.participations[0].trials[0].value.reset();
    held.participations[0].trials[0].felt.reset();
    const QJsonObject json = session::personExportJson(held);
    const QJsonObject session = json["sessions"][0].toObject();
    QVERIFY(!session.contains("passed") && !session.contains("metrics") && !session.contains("sealed"));
    const QJsonObject trial = json["participations"][0]["trials"][0].toObject();
    QVERIFY(trial["value"].isNull() && trial["felt"].isNull() && trial.contains("value") &&
            trial.contains("felt"));
}

void TestPersonJson::aSealedSittingTellsNoLength() {
    database::PersonExport held = everything();
    held.sessions[0].sealed = true;
    const QJsonObject session = session::personExportJson(held)["sessions"][0].toObject();
    QVERIFY(session["sealed"].toBool() && session.contains("recording") && session["recording"].isNull());
}

QTEST_GUILESS_MAIN(TestPersonJson)
#include "test_person_json.moc"
