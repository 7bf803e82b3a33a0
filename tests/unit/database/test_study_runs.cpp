// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_people.h"

#include "database/integrity/verifier.h"
#include "database/query.h"

#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Runs of a study in the database: consent, trials, sealed codes, answers.
class TestStudyRuns : public QObject, StudyPeople {
    Q_OBJECT
private slots:
    void init() { begin(); }
    void rowsOfTheOrderAreThoseOfAStudy();
    void countsAreOfAStudy();
    void consentComesBeforeARun();
    void runsAreOpenOnceAndResumed();
    void trialsComeBackAsStored();
    void everyFieldIsItsOwn();
    void trialsFollowOnAndStay();
    void sessionsAreRecordedForAnOpenRun();
    void sealedCodesCannotBeComputed();
    void answersMustFit();
    void enrolmentComesBeforeTheConsent();
    void answersOfConditionsBelongToRuns();
};

// The row of the order of conditions: from 0 in each study, of people and of simulated observers apart;
// whoever left makes room.
void TestStudyRuns::rowsOfTheOrderAreThoseOfAStudy() {
    const StudyNumber one = frozen("order_one"), other = frozen("order_other");
    const auto enrolled = [&](StudyNumber study, const char* observer) {
        const auto who =
            write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, observer); });
        return who ? who->id : ParticipantNumber{};
    };
    const auto rowOf = [&](ParticipantNumber id) {
        return selectInteger(*reader(), "SELECT order_row FROM study_participant WHERE id = ?", {id})
            ->value_or(-1);
    };
    for (std::int64_t row = 0; row < 3; ++row) {
        QCOMPARE(rowOf(enrolled(one, "")), row);
        QCOMPARE(rowOf(enrolled(one, "weber:0.1")), row);
    }
    const auto second = enrolled(other, "");
    QCOMPARE(rowOf(second), std::int64_t{0});
    QCOMPARE(rowOf(enrolled(other, "weber:0.1")), std::int64_t{0});
    const auto third = enrolled(other, "");
    QCOMPARE(rowOf(third), std::int64_t{1});
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(second, false); }));
    QCOMPARE(rowOf(enrolled(other, "")), std::int64_t{0});
    QCOMPARE(rowOf(enrolled(other, "")), std::int64_t{2});
}

// Each study counts its own participants, completed participants and scored trials.
void TestStudyRuns::countsAreOfAStudy() {
    const StudyNumber one = frozen("counted"), other = frozen("counted_beside");
    const ParticipantNumber done = consented(one);
    (void)consented(one);
    const ParticipantNumber left = consented(one);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(left, false); }));
    (void)consented(other);
    for (const char* condition : {"soft", "hard"}) {
        const auto run = write(m_ruth, [&](StudyRepository& s) {
            return s.beginRun({done, codeOf(*reader(), one, condition), 0, 1, "descending@1"});
        });
        REQUIRE(run);
        StudyTrial practice = someTrial(*run, 0), spoiled = someTrial(*run, 1);
        practice.practice = true;
        spoiled.spoiled = "time";
        for (const StudyTrial& trial : {practice, spoiled, someTrial(*run, 2)}) {
            REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); }));
        }
        REQUIRE(
            write(m_ruth, [&](StudyRepository& s) { return s.finishRun(*run, StudyRunState::completed); }));
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.completeParticipant(done); }));
    const StudySummary first = StudyReader(*reader(), m_ruth).study(one)->summary,
                       second = StudyReader(*reader(), m_ruth).study(other)->summary;
    QCOMPARE(first.participants, 2);
    QCOMPARE(first.completed, 1);
    QCOMPARE(first.trials, 2); // in each condition one trial is neither practice nor spoiled
    QCOMPARE(second.participants, 1);
    QCOMPARE(second.completed, 0);
    QCOMPARE(second.trials, 0);
}

void TestStudyRuns::consentComesBeforeARun() {
    const StudyNumber study = frozen("consent");
    const auto who = write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "x", 0, ""); });
    REQUIRE(who);
    const std::string soft = codeOf(*reader(), study, "soft");
    const auto begin = [&](ParticipantNumber id) {
        return write(m_ruth, [&](StudyRepository& s) {
            return s.beginRun({id, soft, 0, 1, "descending@1"});
        });
    };
    QVERIFY(begin(who->id).error().message.find("consent") != std::string::npos);
    const auto agree = [&](const std::string& sha) {
        return write(m_ruth, [&](StudyRepository& s) { return s.recordConsent(who->id, sha); });
    };
    QCOMPARE(agree(catalogue::sha256Hex("another text")).error().code, core::ErrorCode::badInput);
    REQUIRE(agree(catalogue::sha256Hex("Ich nehme teil."))); // any language's text
    QCOMPARE(agree(consentDigest()).error().code, core::ErrorCode::wrongUse);
    const auto stored = StudyReader(*reader(), m_ruth).participantByCode(study, who->code);
    QCOMPARE(stored->consentSha256, catalogue::sha256Hex("Ich nehme teil."));
    QVERIFY(stored->state == ParticipantState::consented && !stored->consentUtc.empty());
    REQUIRE(begin(who->id));
    const auto simulated =
        write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, "weber:0.1"); });
    REQUIRE(begin(simulated->id));
}

void TestStudyRuns::runsAreOpenOnceAndResumed() {
    const StudyNumber study = frozen("runs");
    const ParticipantNumber who = consented(study);
    const auto begin = [&](const std::string& condition) {
        const std::string code = codeOf(*reader(), study, condition);
        return write(m_ruth, [&](StudyRepository& s) {
            return s.beginRun({who, code.empty() ? condition : code, 0, 9, "descending@1"});
        });
    };
    const auto finish = [&](StudyRunNumber run, StudyRunState state) {
        return write(m_ruth, [&](StudyRepository& s) { return s.finishRun(run, state); });
    };
    const auto first = begin("soft");
    REQUIRE(first);
    QCOMPARE(begin("soft").error().code, core::ErrorCode::wrongUse);
    QCOMPARE(begin("velvet").error().code, core::ErrorCode::badInput);
    REQUIRE(begin("hard"));
    QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.completeParticipant(who); }).error().code,
             core::ErrorCode::wrongUse);
    REQUIRE(m->reopen()); // the program ended in between
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(someTrial(*first, 0)); }));
    QCOMPARE(finish(*first, StudyRunState::open).error().code, core::ErrorCode::badInput);
    REQUIRE(finish(*first, StudyRunState::stopped));
    QCOMPARE(finish(*first, StudyRunState::stopped).error().code, core::ErrorCode::wrongUse);
    const auto again = begin("soft");
    REQUIRE(again);
    REQUIRE(finish(*again, StudyRunState::completed));
    QCOMPARE(begin("soft").error().code, core::ErrorCode::wrongUse);
    const auto runs = StudyReader(*reader(), m_ruth).runs(who);
    QCOMPARE(runs->size(), std::size_t{3});
    QCOMPARE(runs->front().seed,
             std::uint64_t{0}); // with it presentations could be drawn: kept back while blinded
    REQUIRE(write(
        m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(who, false); })); // stops what is open
    QCOMPARE(StudyReader(*reader(), m_ruth).runs(who)->at(1).state, StudyRunState::stopped);
    QCOMPARE(begin("hard").error().code, core::ErrorCode::wrongUse);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(study, "all are done"); }));
    QCOMPARE(StudyReader(*reader(), m_ruth).runs(who)->front().seed, std::uint64_t{9});
}

void TestStudyRuns::trialsComeBackAsStored() {
    const StudyNumber study = frozen("trials");
    const ParticipantNumber who = consented(study);
    const auto session = storeSession(*m->database, m_ruth, 1);
    REQUIRE(session);
    const std::string soft = codeOf(*reader(), study, "soft");
    const auto run = write(m_ruth, [&](StudyRepository& s) {
        return s.beginRun({who, soft, 0, 1, "descending@1"});
    });
    StudyTrial magnitude = someTrial(*run, 2, *session);
    magnitude.value = -0.1 - 0.2;
    for (const StudyTrial& trial : {someTrial(*run, 0, *session), someTrial(*run, 1), magnitude}) {
        REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); }));
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) {
        return s.unblindStudy(study, "all are done");
    })); // none is read before
    const auto trials = StudyReader(*reader(), m_ruth).studyTrials(*run);
    REQUIRE(trials);
    QCOMPARE(trials->size(), std::size_t{3});
    const StudyTrial& first = trials->front();
    QVERIFY(first.session == *session && first.practice && first.entropyMargin == 0.25 &&
            first.spoiled.empty());
    QVERIFY(trials->at(1).session == 0 && std::isnan(trials->at(1).entropyMargin) &&
            trials->at(1).spoiled == "late_ticks");
    QVERIFY(trials->at(2).value == -0.1 - 0.2 && trials->at(2).fidelityJson == "{\"contacts\":3}");
    QCOMPARE(StudyReader(*reader(), m_ruth).study(study)->summary.trials, 1); // neither practice nor spoiled
}

// No field stands for another: each has a value that no other has.
void TestStudyRuns::everyFieldIsItsOwn() {
    (void)frozen("before"); // no number is the same by chance
    const StudyNumber study = frozen("fields");
    (void)consented(study);
    const auto enrolled = write(
        m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, "weber:0.3", "K-1"); });
    REQUIRE(enrolled);
    const Participant who = StudyReader(*reader(), m_ruth).participants(study)->at(1);
    QVERIFY(who.id == enrolled->id && who.study == study && who.code == "K-1" && who.order == 0 &&
            who.state == ParticipantState::enrolled && who.simulated);
    QVERIFY(who.observer == "weber:0.3" && who.enrolledBy == m_ruth.personId() && !who.enrolledUtc.empty() &&
            !who.recordingsToErase && !who.erased);
    QVERIFY(who.consentUtc.empty() && who.consentSha256.empty());
    const Participant person = StudyReader(*reader(), m_ruth).participants(study)->at(0);
    QVERIFY(!person.simulated && person.observer.empty() && person.state == ParticipantState::consented &&
            person.consentSha256 == consentDigest());
    const auto run = write(m_ruth, [&](StudyRepository& s) {
        return s.beginRun(
            {who.id, codeOf(*reader(), study, "hard"), 3, 0xfedcba9876543210ULL, "descending@1,other@2"});
    });
    REQUIRE(run);
    const auto session = storeSession(*m->database, m_ruth, 1);
    REQUIRE(session);
    StudyTrial trial = someTrial(*run, 0, *session);
    trial.procedure = 1;
    trial.firstTick = 111;
    trial.lastTick = 222;
    trial.candidate = 5;
    trial.arrangement = 7;
    trial.difference = -0.125;
    trial.entropyMargin = 0.375;
    trial.answer = 9;
    trial.outcome = 11;
    trial.value = 0.625;
    trial.exploration_s = 1.75;
    trial.answer_s = 0.875;
    trial.practice = false;
    trial.spoiled = "speed";
    trial.utc = "2001-02-03T04:05:06.789Z";
    StudyTrial plain = someTrial(*run, 1);
    plain.answer = plain.outcome = -1;
    plain.practice = true;
    plain.spoiled.clear();
    plain.utc = "2002-03-04T05:06:07.890Z";
    for (const StudyTrial& each : {trial, plain}) {
        REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(each); }));
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.finishRun(*run, StudyRunState::stopped); }));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(study, "all are done"); }));
    const auto runs = StudyReader(*reader(), m_ruth).runs(who.id);
    REQUIRE(runs);
    QCOMPARE(runs->size(), std::size_t{1});
    const StudyRun& stored = runs->front();
    QVERIFY(stored.id == *run && stored.participant == who.id && stored.condition == "hard" &&
            stored.sealedCode == codeOf(*reader(), study, "hard"));
    QVERIFY(stored.position == 3 && stored.seed == 0xfedcba9876543210ULL &&
            stored.procedures == "descending@1,other@2" && stored.state == StudyRunState::stopped);
    QVERIFY(!stored.startedUtc.empty() && stored.endedUtc >= stored.startedUtc);
    const auto trials = StudyReader(*reader(), m_ruth).studyTrials(*run);
    REQUIRE(trials);
    QCOMPARE(trials->size(), std::size_t{2});
    for (const auto& [a, b] : {std::pair{trial, trials->at(0)}, {plain, trials->at(1)}}) {
        QVERIFY(a.run == b.run && a.ordinal == b.ordinal && a.procedure == b.procedure &&
                a.session == b.session && a.firstTick == b.firstTick && a.lastTick == b.lastTick);
        QVERIFY(a.candidate == b.candidate && a.arrangement == b.arrangement &&
                a.difference == b.difference && a.answer == b.answer && a.outcome == b.outcome);
        QVERIFY(a.entropyMargin == b.entropyMargin ||
                (std::isnan(a.entropyMargin) && std::isnan(b.entropyMargin)));
        QVERIFY(a.value == b.value && a.exploration_s == b.exploration_s && a.answer_s == b.answer_s &&
                a.practice == b.practice && !b.undone);
        QVERIFY(a.spoiled == b.spoiled && a.fidelityJson == b.fidelityJson && a.utc == b.utc);
    }
    QVERIFY(trials->at(0).felt == true && trials->at(0).device.empty() && !trials->at(1).felt &&
            trials->at(1).device.empty()); // the session's device has no model
    const StudySummary line = StudyReader(*reader(), m_ruth).study(study)->summary;
    QVERIFY(line.id == study && line.key == "fields" && line.title == "Stiffness of fields" &&
            line.state == StudyState::frozen && line.sha256.size() == 64);
    QVERIFY(line.author == m_ruth.personId() && !line.createdUtc.empty() &&
            line.frozenUtc >= line.createdUtc && line.unblinded && !line.demonstration);
    QVERIFY(line.participants == 2 && line.completed == 0 && line.trials == 0);
}

void TestStudyRuns::trialsFollowOnAndStay() {
    const StudyNumber study = frozen("order");
    const ParticipantNumber who = consented(study);
    const std::string soft = codeOf(*reader(), study, "soft");
    const auto run = write(m_ruth, [&](StudyRepository& s) {
        return s.beginRun({who, soft, 0, 1, "descending@1"});
    });
    const auto store = [&](const StudyTrial& trial) {
        return write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); });
    };
    REQUIRE(store(someTrial(*run, 0)));
    const auto with = [&](auto change) {
        StudyTrial trial = someTrial(*run, 1);
        change(trial);
        return store(trial).error().code;
    };
    const core::ErrorCode bad = core::ErrorCode::badInput;
    QCOMPARE(with([](StudyTrial& t) { t.ordinal = 2; }), bad);
    QCOMPARE(store(someTrial(*run, 2)).error().message, std::string("trial 2: expected 1, the run's next"));
    QCOMPARE(with([](StudyTrial& t) { t.ordinal = 0; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.difference = std::nan(""); }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.value = std::numeric_limits<double>::infinity(); }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.exploration_s = -1.0; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.candidate = 4096; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.arrangement = 16; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.lastTick = 0; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.fidelityJson = "nonsense"; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.session = 77; }), bad);
    const auto hers = storeSession(*m->database, m_admin, 1); // somebody else's
    REQUIRE(hers);
    QCOMPARE(with([&](StudyTrial& t) { t.session = *hers; }), bad);
    for (const char* sql : {"UPDATE study_trial SET answer = 1", "DELETE FROM study_trial"}) {
        QVERIFY(!m->database->write([&](WriteContext& w) { return w.connection().execute(sql); }));
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.finishRun(*run, StudyRunState::completed); }));
    QCOMPARE(store(someTrial(*run, 1)).error().code, core::ErrorCode::wrongUse);
}

// Known from its first tick on, so that a participant's recordings are found where no trial was stored.
void TestStudyRuns::sessionsAreRecordedForAnOpenRun() {
    const StudyNumber study = frozen("recorded");
    const ParticipantNumber who = consented(study);
    const auto run = write(m_ruth, [&](StudyRepository& s) {
        return s.beginRun({who, codeOf(*reader(), study, "soft"), 0, 1, "descending@1"});
    });
    REQUIRE(run);
    const auto trudy = m->person(m_admin, "trudy", {Role::trainer});
    REQUIRE(trudy);
    const auto begin = [&](const Actor& actor, std::int64_t of) {
        NewSession setup = someSession();
        setup.studyRun = of;
        return m->database->write(
            [&](WriteContext& w) { return SessionRepository(w.connection(), actor).beginSession(setup); });
    };
    const auto sessions = [&] {
        return selectInteger(*reader(), "SELECT count(*) FROM session")->value_or(-1);
    };
    QCOMPARE(begin(*trudy, *run).error().code, core::ErrorCode::notAllowed);
    QVERIFY(!begin(m_ruth, *run + 1));
    QCOMPARE(sessions(), std::int64_t{0}); // nothing of those that were refused
    const auto session = begin(m_ruth, *run);
    REQUIRE(session);
    QCOMPARE(
        selectInteger(*reader(), "SELECT run_id FROM study_sitting WHERE id = ?", {*session})->value_or(0),
        *run);
    const auto beside = begin(m_ruth, 0);
    REQUIRE(beside);
    QCOMPARE(selectInteger(*reader(), "SELECT count(*) FROM study_sitting")->value_or(0), std::int64_t{1});
    for (const char* sql : {"UPDATE study_sitting SET run_id = 9", "DELETE FROM study_sitting"})
        QVERIFY(!m->database->write([&](WriteContext& w) { return w.connection().execute(sql); }));
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.finishRun(*run, StudyRunState::stopped); }));
    QCOMPARE(begin(m_ruth, *run).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(sessions(), std::int64_t{2});
}

void TestStudyRuns::sealedCodesCannotBeComputed() {
    const auto codes = [&] {
        const StudyNumber study = frozen("sealed");
        return m->database
            ->write(
                [&](WriteContext& w) { return StudyReader(w.connection(), m_ruth).sealedConditions(study); })
            .value();
    };
    const auto here = codes();
    QCOMPARE(here.size(), std::size_t{2});
    QVERIFY(here[0].condition == "soft" && here[0].sealedCode != here[1].sealedCode &&
            here[0].sealedCode.size() == 3);
    init(); // another site's key, the same design: another code
    const auto there = codes();
    QVERIFY(here[0].sealedCode != there[0].sealedCode || here[1].sealedCode != there[1].sealedCode);
    const ParticipantNumber who = consented(StudyReader(*reader(), m_ruth).studyByKey("sealed")->summary.id);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) {
        return s.beginRun({who, there[1].sealedCode, 0, 1, "descending@1"});
    }));
    QCOMPARE(StudyReader(*reader(), m_ruth).runs(who)->front().sealedCode, there[1].sealedCode);
}

void TestStudyRuns::answersMustFit() {
    const StudyNumber study = frozen("answers");
    const ParticipantNumber who = consented(study);
    const auto store = [&](std::vector<QuestionnaireAnswer> answers) {
        return write(m_ruth, [&](StudyRepository& s) { return s.storeQuestionnaireAnswers(answers); });
    };
    const QuestionnaireAnswer good{who, "face", "real", 5.0, "", ""};
    for (const QuestionnaireAnswer& wrong : {QuestionnaireAnswer{who, "face", "real", 6.0, "", ""},
                                             {who, "face", "real", 2.5, "", ""},
                                             {who, "face", "real", {}, "yes", ""},
                                             {who, "face", "years", 61.0, "", ""},
                                             {who, "face", "hand", 2.0, "", ""},
                                             {who, "face", "remarks", 1.0, "", ""},
                                             {who, "face", "size", 1.0, "", ""},
                                             {who, "back", "real", 1.0, "", ""}}) {
        QCOMPARE(store({good, wrong}).error().code, core::ErrorCode::badInput);
    }
    QVERIFY(StudyReader(*reader(), m_ruth).questionnaireAnswers(study)->empty()); // all or nothing
    REQUIRE(store({good,
                   {who, "face", "years", 7.5, "", ""},
                   {who, "face", "hand", 0.0, "", ""},
                   {who, "face", "remarks", {}, "weich, \"ähnlich\"", ""}}));
    QCOMPARE(store({good}).error().code, core::ErrorCode::wrongUse);
    const auto asked =
        write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "Jane Roe", 0, ""); });
    REQUIRE(asked);
    QCOMPARE(store({{asked->id, "face", "real", 5.0, "", ""}}).error().code,
             core::ErrorCode::wrongUse); // no consent
    const auto answers = StudyReader(*reader(), m_ruth).questionnaireAnswers(study);
    QCOMPARE(answers->size(), std::size_t{4});
    QVERIFY(answers->front().number == 5.0 && answers->back().text == "weich, \"ähnlich\"" &&
            !answers->back().number);
}

/// What is written down at the enrolment is stored before the consent, nothing else is; and never of who has
/// left.
void TestStudyRuns::enrolmentComesBeforeTheConsent() {
    std::string design = someDesign("enrolment");
    design.replace(
        design.find(R"("questionnaires":[)"), 18,
        R"("questionnaires":[{"id":"person","title":{"en":"Person"},"when":"enrolment","items":[{"id":"age","text":{"en":"Age"},"kind":"number","lowest":0,"highest":120}]},)");
    const auto study =
        write(m_ruth, [&](StudyRepository& s) { return s.createStudy("enrolment", "Enrolment", design); });
    REQUIRE(study);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.freezeStudy(*study); }));
    const auto who =
        write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(*study, "Jane Roe", 0, ""); });
    REQUIRE(who);
    const auto store = [&](ParticipantNumber of, const char* questionnaire, const char* item, double value) {
        return write(m_ruth, [&](StudyRepository& s) {
            return s.storeQuestionnaireAnswers({{of, questionnaire, item, value, "", ""}});
        });
    };
    QCOMPARE(store(who->id, "face", "real", 5.0).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(store(who->id, "person", "age", 130.0).error().code, core::ErrorCode::badInput);
    REQUIRE(store(who->id, "person", "age", 31.0));
    QCOMPARE(store(who->id, "person", "age", 32.0).error().code, core::ErrorCode::wrongUse); // once
    const auto left =
        write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(*study, "John Roe", 0, ""); });
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(left->id, false); }));
    QCOMPARE(store(left->id, "person", "age", 40.0).error().code, core::ErrorCode::wrongUse);
}

/// A questionnaire that is asked after each condition: once for each completed run of the participant, by
/// sealed code and withheld while the study is blinded (its conditions differ), with the language in which it
/// was shown.
void TestStudyRuns::answersOfConditionsBelongToRuns() {
    std::string design = someDesign("each");
    design.replace(design.find(R"({"id":"face",)"), 13, R"({"id":"face","when":"after_condition",)");
    const auto study =
        write(m_ruth, [&](StudyRepository& s) { return s.createStudy("each", "Each", design); });
    REQUIRE(study);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.freezeStudy(*study); }));
    const ParticipantNumber who = consented(*study), other = consented(*study);
    const auto begun = [&](ParticipantNumber of, const char* condition) {
        return write(m_ruth,
                     [&](StudyRepository& s) {
                         return s.beginRun({of, codeOf(*reader(), *study, condition), 0, 1, "descending@1"});
                     })
            .value_or(0);
    };
    const auto store = [&](StudyRunNumber run, double value, const std::string& language = "en") {
        QuestionnaireAnswer answer{who, "face", "real", value, "", ""};
        answer.run = run;
        answer.language = language;
        return write(m_ruth, [&](StudyRepository& s) { return s.storeQuestionnaireAnswers({answer}); });
    };
    const auto completed = [&](StudyRunNumber run) {
        return write(m_ruth, [&](StudyRepository& s) { return s.finishRun(run, StudyRunState::completed); });
    };
    const StudyRunNumber soft = begun(who, "soft"), foreign = begun(other, "soft");
    QCOMPARE(store(0, 5.0).error().code, core::ErrorCode::badInput);    // of which condition?
    QCOMPARE(store(soft, 5.0).error().code, core::ErrorCode::wrongUse); // not done yet
    REQUIRE(completed(soft));
    REQUIRE(completed(foreign));
    QCOMPARE(store(foreign, 5.0).error().code, core::ErrorCode::badInput);    // somebody else's
    QCOMPARE(store(soft, 5.0, "xx").error().code, core::ErrorCode::badInput); // it is not written in that
    REQUIRE(store(soft, 5.0));
    QCOMPARE(store(soft, 4.0).error().code, core::ErrorCode::wrongUse); // once
    const StudyRunNumber hard = begun(who, "hard");
    REQUIRE(completed(hard));
    REQUIRE(store(hard, 2.0, ""));
    const auto listed = StudyReader(*reader(), m_ruth).questionnaireAnswers(*study);
    for (const QuestionnaireAnswer& answer : *listed) {
        QVERIFY(answer.withheld && !answer.number && answer.utc.empty() && answer.condition.empty());
        QCOMPARE(answer.sealedCode, codeOf(*reader(), *study, answer.run == soft ? "soft" : "hard"));
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(*study, "all are done"); }));
    const auto answers = StudyReader(*reader(), m_ruth).questionnaireAnswers(*study);
    QCOMPARE(answers->size(), std::size_t{2});
    QVERIFY(answers->front().condition == "soft" && answers->front().number == 5.0 &&
            answers->front().language == "en" && !answers->front().withheld);
    QVERIFY(answers->back().condition == "hard" && answers->back().number == 2.0 &&
            answers->back().language.empty());
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(who, false); }));
    REQUIRE(AccountService(*m->database).eraseParticipant(m_admin, kPassword, who, "wish"));
    const auto listedLater = StudyReader(*reader(), m_ruth).questionnaireAnswers(*study);
    for (const QuestionnaireAnswer& answer : *listedLater) {
        QVERIFY(!answer.number && answer.text.empty()); // of every condition
    }
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

QTEST_GUILESS_MAIN(TestStudyRuns)
#include "test_study_runs.moc"
