// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_site.h"

#include "database/integrity/verifier.h"
#include "database/query.h"

#include <QRegularExpression>
#include <cmath>
#include <limits>
#include <set>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Studies in the database: from draft to closed, participants, runs.
class TestStudies : public QObject {
    Q_OBJECT
private slots:
    void init();
    void draftsChangeUntilFrozen();
    void frozenDesignCannotBeChangedByAnyWay();
    void auditKnowsTheFreezing();
    void keysAreOfPeopleAndOfTheSimulatedAccount();
    void codesAreRandomAndReadable();
    void ordersAreGivenOut();
    void consentComesBeforeARun();
    void runsAreOpenOnceAndResumed();
    void trialsComeBackAsStored();
    void trialsFollowOnAndStay();
    void sealedCodesCannotBeComputed();
    void answersMustFit();
    void keysAreReadByFewAndAudited();
    void simulatedAccountKeepsToItself();
    void aBrokenJobLeavesNothing();

private:
    template <class F> auto write(const Actor& actor, F job) {
        return m->database->write([&](WriteContext& w) {
            StudyRepository studies(w.connection(), actor);
            return job(studies);
        });
    }
    StudyNumber frozen(const std::string& key);
    ParticipantNumber consented(StudyNumber study);
    std::unique_ptr<Connection> reader() { return *m->database->openReader(); }

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous();
    Actor m_ruth = Actor::anonymous();
};

void TestStudies::init() {
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    const auto admin = m->administrator();
    REQUIRE(admin);
    m_admin = *admin;
    const auto ruth = m->person(m_admin, "ruth", {Role::researcher});
    REQUIRE(ruth);
    m_ruth = *ruth;
}

StudyNumber TestStudies::frozen(const std::string& key) {
    const auto made = write(m_ruth, [&](StudyRepository& s) -> core::Result<StudyNumber> {
        const auto study = s.createStudy(key, "Title", someDesign(key));
        const auto sha = study ? s.freezeStudy(*study) : tl::unexpected(study.error());
        return sha ? study : tl::unexpected(sha.error());
    });
    return made.value_or(0);
}

ParticipantNumber TestStudies::consented(StudyNumber study) {
    return write(m_ruth, [&](StudyRepository& s) { return enrol(s, m_ruth, study, true); }).value_or(0);
}

void TestStudies::draftsChangeUntilFrozen() {
    const auto study = write(m_ruth, [](StudyRepository& s) { return s.createStudy("soft_tubes", "Soft tubes", "{}"); });
    REQUIRE(study);
    QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.freezeStudy(*study); }).error().code, core::ErrorCode::badInput);
    for (const char* wrong : {"", "[]", "{", "{\"a\":1}{}"}) {
        QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.saveDraft(*study, wrong); }).error().code,
                 core::ErrorCode::badInput);
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.saveDraft(*study, someDesign("soft_tubes")); }));
    const auto record = StudyReader(*reader(), m_ruth).study(*study);
    REQUIRE(record);
    QCOMPARE(record->summary.title, std::string("Stiffness of soft_tubes"));
    QVERIFY(record->summary.state == StudyState::draft && record->summary.sha256.empty());
    QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(*study); }).error().code, core::ErrorCode::wrongUse);
    const auto sha = write(m_ruth, [&](StudyRepository& s) { return s.freezeStudy(*study); });
    REQUIRE(sha);
    const auto after = StudyReader(*reader(), m_ruth).studyByKey("soft_tubes");
    REQUIRE(after);
    QCOMPARE(after->summary.sha256, *sha);
    QCOMPARE(catalogue::sha256Hex(after->designJson), *sha);
    QVERIFY(after->summary.state == StudyState::frozen && !after->summary.frozenUtc.empty());
    for (const auto& again : {write(m_ruth, [&](StudyRepository& s) { return s.saveDraft(*study, "{}"); }),
                              write(m_ruth, [&](StudyRepository& s) { return drop(s.freezeStudy(*study)); })}) {
        QCOMPARE(again.error().code, core::ErrorCode::wrongUse);
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.closeStudy(*study); }));
    QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(*study, "", 0, ""); }).error().code,
             core::ErrorCode::wrongUse);
    REQUIRE(write(m_admin, [&](StudyRepository& s) { return s.setStudyArchived(*study, true); }));
    QVERIFY(StudyReader(*reader(), m_ruth).listStudies()->empty());
    QCOMPARE(StudyReader(*reader(), m_ruth).listStudies(true)->front().state, StudyState::archived);
    REQUIRE(write(m_admin, [&](StudyRepository& s) { return s.setStudyArchived(*study, false); }));
    QCOMPARE(StudyReader(*reader(), m_ruth).study(*study)->summary.state, StudyState::closed);
}

void TestStudies::frozenDesignCannotBeChangedByAnyWay() {
    const StudyNumber study = frozen("fixed");
    QVERIFY(study != 0);
    for (const char* sql : {"UPDATE study SET design_json = '{}'", "UPDATE study SET sha256 = zeroblob(32)",
                            "UPDATE study SET state = 'draft', sha256 = NULL", "UPDATE study SET key = 'other'",
                            "UPDATE study SET title = 'other'", "DELETE FROM study",
                            "UPDATE study_condition SET sealed_code = 'AAA' || ordinal", "DELETE FROM study_condition"}) {
        const auto done = m->database->write([&](WriteContext& w) { return w.connection().execute(sql); });
        QVERIFY2(!done && done.error().message.find("never") != std::string::npos, sql);
    }
}

void TestStudies::auditKnowsTheFreezing() {
    const StudyNumber study = frozen("noted");
    auto connection = reader();
    const auto detail = selectText(*connection, "SELECT detail_json FROM audit WHERE action = 'freezeStudy' AND target_id = ?", {study});
    const auto record = StudyReader(*connection, m_ruth).study(study);
    REQUIRE(record);
    QVERIFY((*detail)->find("\"sha256\":\"" + record->summary.sha256 + "\"") != std::string::npos);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(study); }));
    QVERIFY(StudyReader(*reader(), m_ruth).study(study)->summary.unblinded);
    QCOMPARE(selectInteger(*reader(), "SELECT count(*) FROM audit WHERE action = 'unblindStudy'")->value_or(0), std::int64_t{1});
}

void TestStudies::keysAreOfPeopleAndOfTheSimulatedAccount() {
    const StudyNumber study = frozen("same_key");
    QCOMPARE(write(m_admin, [](StudyRepository& s) { return s.createStudy("same_key", "", "{}"); }).error().code, core::ErrorCode::badInput);
    const auto simulated = write(Actor::simulated(), [](StudyRepository& s) { return s.createStudy("same_key", "", "{}"); });
    REQUIRE(simulated);
    QCOMPARE(StudyReader(*reader(), m_ruth).studyByKey("same_key")->summary.id, study);
    QCOMPARE(StudyReader(*reader(), Actor::simulated()).studyByKey("same_key")->summary.id, *simulated);
    QCOMPARE(StudyReader(*reader(), m_ruth).studyByKey("none").error().code, core::ErrorCode::notFound);
    for (const char* key : {"", "Big", "1st", "a-b", "a b"}) {
        QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.createStudy(key, "", "{}"); }).error().code, core::ErrorCode::badInput);
    }
}

void TestStudies::codesAreRandomAndReadable() {
    const StudyNumber study = frozen("codes");
    static const QRegularExpression kCode(QStringLiteral("^[ACDEFGHJKMNPQRTWXY34679]{3}-[ACDEFGHJKMNPQRTWXY34679]{3}$"));
    std::set<std::string> codes;
    for (int i = 0; i < 60; ++i) {
        const auto who = write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "somebody", 0, ""); });
        REQUIRE(who);
        QVERIFY2(kCode.match(QString::fromStdString(who->code)).hasMatch(), who->code.c_str());
        QVERIFY(codes.insert(who->code).second);
        QCOMPARE(who->order, i);
    }
    const std::string code = *codes.begin();
    QString lower = QString::fromStdString(code).toLower().remove('-');
    const auto found = StudyReader(*reader(), m_ruth).participantByCode(study, lower.toStdString());
    REQUIRE(found);
    QCOMPARE(found->code, code);
}

void TestStudies::ordersAreGivenOut() {
    const StudyNumber study = frozen("orders");
    const auto enrolled = [&](const std::string& observer, const std::string& code = "") {
        return write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, observer, code); });
    };
    QCOMPARE(enrolled("")->order, 0);
    const auto second = enrolled("");
    QCOMPARE(second->order, 1);
    QCOMPARE(enrolled("weber:0.1", "P01")->order, 0); // simulated ones count by themselves
    QCOMPARE(enrolled("")->order, 2);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(second->id, false); }));
    QCOMPARE(enrolled("")->order, 1); // the row of who left
    QCOMPARE(enrolled("weber:0.1", "P01").error().code, core::ErrorCode::badInput);
    QCOMPARE(enrolled("", "P02").error().code, core::ErrorCode::badInput); // people get random codes
    QCOMPARE(StudyReader(*reader(), m_ruth).participantByCode(study, "p01")->observer, std::string("weber:0.1"));
    const auto twice = [&] {
        return write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "", m_admin.personId(), ""); });
    };
    REQUIRE(twice());
    QCOMPARE(twice().error().code, core::ErrorCode::badInput);
}

void TestStudies::consentComesBeforeARun() {
    const StudyNumber study = frozen("consent");
    const auto who = write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "x", 0, ""); });
    REQUIRE(who);
    const std::string soft = codeOf(*reader(), study, "soft");
    const auto begin = [&](ParticipantNumber id) {
        return write(m_ruth, [&](StudyRepository& s) { return s.beginRun({id, soft, 0, 1, "descending@1"}); });
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
    const auto simulated = write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, "weber:0.1"); });
    REQUIRE(begin(simulated->id));
}

void TestStudies::runsAreOpenOnceAndResumed() {
    const StudyNumber study = frozen("runs");
    const ParticipantNumber who = consented(study);
    const auto begin = [&](const std::string& condition) {
        const std::string code = codeOf(*reader(), study, condition);
        return write(m_ruth, [&](StudyRepository& s) { return s.beginRun({who, code.empty() ? condition : code, 0, 9, "descending@1"}); });
    };
    const auto finish = [&](StudyRunNumber run, StudyRunState state) {
        return write(m_ruth, [&](StudyRepository& s) { return s.finishRun(run, state); });
    };
    const auto first = begin("soft");
    REQUIRE(first);
    QCOMPARE(begin("soft").error().code, core::ErrorCode::wrongUse);
    QCOMPARE(begin("velvet").error().code, core::ErrorCode::badInput);
    REQUIRE(begin("hard"));
    QCOMPARE(write(m_ruth, [&](StudyRepository& s) { return s.completeParticipant(who); }).error().code, core::ErrorCode::wrongUse);
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
    QCOMPARE(runs->front().seed, std::uint64_t{9});
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.withdrawParticipant(who, false); })); // stops what is open
    QCOMPARE(StudyReader(*reader(), m_ruth).runs(who)->at(1).state, StudyRunState::stopped);
    QCOMPARE(begin("hard").error().code, core::ErrorCode::wrongUse);
}

void TestStudies::trialsComeBackAsStored() {
    const StudyNumber study = frozen("trials");
    const ParticipantNumber who = consented(study);
    const auto session = storeSession(*m->database, m_ruth, 1);
    REQUIRE(session);
    const std::string soft = codeOf(*reader(), study, "soft");
    const auto run = write(m_ruth, [&](StudyRepository& s) { return s.beginRun({who, soft, 0, 1, "descending@1"}); });
    StudyTrial magnitude = someTrial(*run, 2, *session);
    magnitude.value = -0.1 - 0.2;
    for (const StudyTrial& trial : {someTrial(*run, 0, *session), someTrial(*run, 1), magnitude}) {
        REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); }));
    }
    const auto trials = StudyReader(*reader(), m_ruth).studyTrials(*run);
    REQUIRE(trials);
    QCOMPARE(trials->size(), std::size_t{3});
    const StudyTrial& first = trials->front();
    QVERIFY(first.session == *session && first.practice && first.entropyMargin == 0.25 && first.spoiled.empty());
    QVERIFY(trials->at(1).session == 0 && std::isnan(trials->at(1).entropyMargin) && trials->at(1).spoiled == "late_ticks");
    QVERIFY(trials->at(2).value == -0.1 - 0.2 && trials->at(2).fidelityJson == "{\"contacts\":3}");
    QCOMPARE(StudyReader(*reader(), m_ruth).study(study)->summary.trials, 1); // neither practice nor spoiled
}

void TestStudies::trialsFollowOnAndStay() {
    const StudyNumber study = frozen("order");
    const ParticipantNumber who = consented(study);
    const std::string soft = codeOf(*reader(), study, "soft");
    const auto run = write(m_ruth, [&](StudyRepository& s) { return s.beginRun({who, soft, 0, 1, "descending@1"}); });
    const auto store = [&](const StudyTrial& trial) { return write(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); }); };
    REQUIRE(store(someTrial(*run, 0)));
    const auto with = [&](auto change) {
        StudyTrial trial = someTrial(*run, 1);
        change(trial);
        return store(trial).error().code;
    };
    const core::ErrorCode bad = core::ErrorCode::badInput;
    QCOMPARE(with([](StudyTrial& t) { t.ordinal = 2; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.ordinal = 0; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.difference = std::nan(""); }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.value = std::numeric_limits<double>::infinity(); }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.exploration_s = -1.0; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.candidate = 4096; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.arrangement = 16; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.lastTick = 0; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.fidelityJson = "nonsense"; }), bad);
    QCOMPARE(with([](StudyTrial& t) { t.session = 77; }), bad);
    for (const char* sql : {"UPDATE study_trial SET answer = 1", "DELETE FROM study_trial"}) {
        QVERIFY(!m->database->write([&](WriteContext& w) { return w.connection().execute(sql); }));
    }
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.finishRun(*run, StudyRunState::completed); }));
    QCOMPARE(store(someTrial(*run, 1)).error().code, core::ErrorCode::wrongUse);
}

void TestStudies::sealedCodesCannotBeComputed() {
    const auto codes = [&] {
        const StudyNumber study = frozen("sealed");
        return m->database->write([&](WriteContext& w) { return StudyReader(w.connection(), m_ruth).sealedConditions(study); }).value();
    };
    const auto here = codes();
    QCOMPARE(here.size(), std::size_t{2});
    QVERIFY(here[0].condition == "soft" && here[0].sealedCode != here[1].sealedCode && here[0].sealedCode.size() == 3);
    init(); // another site's key, the same design: another code
    const auto there = codes();
    QVERIFY(here[0].sealedCode != there[0].sealedCode || here[1].sealedCode != there[1].sealedCode);
    const ParticipantNumber who = consented(StudyReader(*reader(), m_ruth).studyByKey("sealed")->summary.id);
    REQUIRE(write(m_ruth, [&](StudyRepository& s) { return s.beginRun({who, there[1].sealedCode, 0, 1, "descending@1"}); }));
    QCOMPARE(StudyReader(*reader(), m_ruth).runs(who)->front().sealedCode, there[1].sealedCode);
}

void TestStudies::answersMustFit() {
    const StudyNumber study = frozen("answers");
    const ParticipantNumber who = consented(study);
    const auto store = [&](std::vector<QuestionnaireAnswer> answers) {
        return write(m_ruth, [&](StudyRepository& s) { return s.storeQuestionnaireAnswers(answers); });
    };
    const QuestionnaireAnswer good{who, "face", "real", 5.0, "", ""};
    for (const QuestionnaireAnswer& wrong : {QuestionnaireAnswer{who, "face", "real", 6.0, "", ""}, {who, "face", "real", 2.5, "", ""},
                                             {who, "face", "real", {}, "yes", ""}, {who, "face", "years", 61.0, "", ""},
                                             {who, "face", "hand", 2.0, "", ""}, {who, "face", "remarks", 1.0, "", ""},
                                             {who, "face", "size", 1.0, "", ""}, {who, "back", "real", 1.0, "", ""}}) {
        QCOMPARE(store({good, wrong}).error().code, core::ErrorCode::badInput);
    }
    QVERIFY(StudyReader(*reader(), m_ruth).questionnaireAnswers(study)->empty()); // all or nothing
    REQUIRE(store({good, {who, "face", "years", 7.5, "", ""}, {who, "face", "hand", 0.0, "", ""}, {who, "face", "remarks", {}, "weich, \"ähnlich\"", ""}}));
    QCOMPARE(store({good}).error().code, core::ErrorCode::wrongUse);
    const auto asked = write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "Jane Roe", 0, ""); });
    REQUIRE(asked);
    QCOMPARE(store({{asked->id, "face", "real", 5.0, "", ""}}).error().code, core::ErrorCode::wrongUse); // no consent
    const auto answers = StudyReader(*reader(), m_ruth).questionnaireAnswers(study);
    QCOMPARE(answers->size(), std::size_t{4});
    QVERIFY(answers->front().number == 5.0 && answers->back().text == "weich, \"ähnlich\"" && !answers->back().number);
}

void TestStudies::keysAreReadByFewAndAudited() {
    const StudyNumber study = frozen("keys");
    const auto who = write(m_ruth, [&](StudyRepository& s) { return s.enrolParticipant(study, "Jane Roe", m_admin.personId(), ""); });
    REQUIRE(who);
    const auto other = m->person(m_admin, "rob", {Role::researcher});
    const auto look = [&](const Actor& actor) {
        return m->database->write([&](WriteContext& w) { return StudyReader(w.connection(), actor).participantKeys(study); });
    };
    QCOMPARE(look(*other).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(StudyReader(*reader(), m_ruth).participantKeys(study).error().code, core::ErrorCode::wrongUse);
    for (const Actor& actor : {m_ruth, m_admin}) {
        const auto keys = look(actor);
        REQUIRE(keys);
        QVERIFY(keys->front().identity == "Jane Roe" && keys->front().code == who->code && keys->front().person == m_admin.personId());
    }
    QCOMPARE(selectInteger(*reader(), "SELECT count(*) FROM audit WHERE action = 'participantKeys'")->value_or(0), std::int64_t{2});
}

void TestStudies::simulatedAccountKeepsToItself() {
    const StudyNumber study = frozen("of_ruth");
    const auto made = makeStudies(*m->database, Actor::simulated(), "of_nobody");
    REQUIRE(made);
    auto connection = reader();
    StudyReader everybody(*connection, Actor::anonymous());
    QCOMPARE(everybody.listStudies()->size(), std::size_t{2});
    QCOMPARE(everybody.study(study).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(everybody.studyByKey("of_ruth").error().code, core::ErrorCode::notFound);
    const auto participants = everybody.participants(made->frozen);
    for (const Participant& participant : *participants) {
        QVERIFY(participant.simulated && participant.enrolledBy == Actor::kSimulatedPerson);
    }
    QCOMPARE(write(Actor::simulated(), [&](StudyRepository& s) { return s.enrolParticipant(study, "", 0, "weber:0.1"); }).error().code,
             core::ErrorCode::notAllowed);
    QCOMPARE(write(Actor::simulated(), [&](StudyRepository& s) { return s.enrolParticipant(made->frozen, "me", 0, ""); }).error().code,
             core::ErrorCode::notAllowed);
}

void TestStudies::aBrokenJobLeavesNothing() {
    const StudyNumber study = frozen("half");
    const auto broken = write(m_ruth, [&](StudyRepository& s) -> core::Result<void> {
        const auto who = s.enrolParticipant(study, "x", 0, "");
        return who ? s.recordConsent(who->id, "nonsense") : tl::unexpected(who.error());
    });
    QVERIFY(!broken);
    QVERIFY(StudyReader(*reader(), m_ruth).participants(study)->empty());
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

QTEST_GUILESS_MAIN(TestStudies)
#include "test_studies.moc"
