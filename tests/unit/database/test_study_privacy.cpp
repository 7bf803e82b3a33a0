// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_site.h"

#include "database/integrity/verifier.h"
#include "database/privacy/erasure.h"
#include "database/query.h"

#include <QDir>
#include <QFile>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {
bool onDisk(const std::string& database, const QByteArray& bytes) {
    for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
        if (contentOf(database + suffix).contains(bytes)) {
            return true;
        }
    }
    return false;
}
} // namespace

/// Participants of studies towards the law: a copy, and oblivion, also in what is restored.
class TestStudyPrivacy : public QObject {
    Q_OBJECT
private slots:
    void init();
    void exportHoldsParticipations();
    void trialsOfABlindedStudyAreTheParticipants();
    void erasureNeedsWithdrawalAdministratorAndPassword();
    void erasureOverwritesButKeepsTrials();
    void erasureOverwritesWhatWasSaidOfSittings();
    void recordingsGoWhereTheParticipantWishes_data();
    void recordingsGoWhereTheParticipantWishes();
    void erasingAPersonErasesTheParticipant();
    void anAccountIsLinkedByItsLoginName();
    void erasingAnExperimenterKeepsParticipantsRecordings();
    void restoredBackupsStayErased();
    void nonceKeepsDigestsFromTelling();

private:
    void withdraw(bool recordings);
    std::unique_ptr<Connection> reader() { return *m->database->openReader(); }

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous();
    Actor m_ruth = Actor::anonymous();
    PersonId m_tim = 0;
    StudyNumber m_study = 0;
    ParticipantNumber m_participant = 0;
    std::string m_code;
    SessionId m_session = 0;
    StudyRunNumber m_run = 0;
};

void TestStudyPrivacy::init() {
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    m_admin = m->administrator().value();
    m_ruth = m->person(m_admin, "ruth", {Role::researcher}).value();
    m_tim = m->person(m_admin, "tim", {Role::trainee})->personId();
    m_session = storeSession(*m->database, m_ruth, 2).value();
    const auto done = m->database->write([&](WriteContext& w) -> core::Result<void> {
        StudyRepository studies(w.connection(), m_ruth);
        m_study = studies.createStudy("private", "Private", someDesign("private")).value();
        (void)studies.freezeStudy(m_study).value();
        const Participant who =
            studies.enrolParticipant(m_study, "Timotheus Unverwechselbar", m_tim, "").value();
        m_participant = who.id;
        m_code = who.code;
        auto good = studies.recordConsent(who.id, consentDigest());
        m_run =
            studies.beginRun({who.id, codeOf(w.connection(), m_study, "soft"), 0, 1, "descending@1"}).value();
        good = good ? studies.storeStudyTrial(someTrial(m_run, 0, m_session)) : good;
        good = good ? studies.finishRun(m_run, StudyRunState::completed) : good;
        return good ? studies.storeQuestionnaireAnswers(
                          {{who.id, "face", "remarks", {}, "Schmetterlingseffekt", ""},
                           {who.id, "face", "years", 41.0, "", ""}})
                    : good;
    });
    REQUIRE(done);
}

void TestStudyPrivacy::withdraw(bool recordings) {
    REQUIRE(m->database->write([&](WriteContext& w) {
        return StudyRepository(w.connection(), m_ruth).withdrawParticipant(m_participant, recordings);
    }));
}

void TestStudyPrivacy::exportHoldsParticipations() {
    const auto tim = AccountService(*m->database).login("tim", kPassword);
    REQUIRE(tim);
    const auto held = PrivacyRepository(*reader(), *tim).exportPerson(m_tim);
    REQUIRE(held);
    QCOMPARE(held->participations.size(), std::size_t{1});
    const PersonParticipation& mine = held->participations.front();
    QCOMPARE(mine.studyKey, std::string("private"));
    QCOMPARE(mine.participant.code, m_code);
    QCOMPARE(mine.identity, std::string("Timotheus Unverwechselbar"));
    QVERIFY(mine.runs.size() == 1 && mine.answers.size() == 2);
    QVERIFY(mine.sealed && mine.trials.empty() &&
            mine.runs.front().endedUtc.empty()); // they would tell which condition it was
    QVERIFY(!mine.participant.consentUtc.empty());
    QVERIFY(PrivacyRepository(*reader(), m_ruth).exportPerson(m_ruth.personId())->participations.empty());
    REQUIRE(m->database->write([&](WriteContext& w) {
        return StudyRepository(w.connection(), m_ruth).unblindStudy(m_study, "all are done");
    }));
    const auto after = PrivacyRepository(*reader(), *tim).exportPerson(m_tim);
    REQUIRE(after);
    QVERIFY(!after->participations.front().sealed && after->participations.front().trials.size() == 1);
}

/// An experimenter names the account; what the person gets and what is erased reaches the participation;
/// nothing else tells of it.
void TestStudyPrivacy::anAccountIsLinkedByItsLoginName() {
    const Actor rob = m->person(m_admin, "rob", {Role::researcher}).value();
    const StudyNumber other =
        m->database
            ->write([&](WriteContext& w) -> core::Result<StudyNumber> {
                StudyRepository studies(w.connection(), m_ruth);
                const auto made = studies.createStudy("other", "Other", someDesign("other"));
                const auto frozen = made ? studies.freezeStudy(*made) : tl::unexpected(made.error());
                return frozen ? made : core::Result<StudyNumber>(tl::unexpected(frozen.error()));
            })
            .value();
    const auto enrolled = [&](const Actor& actor, const std::string& account) {
        return m->database->write([&](WriteContext& w) {
            return StudyRepository(w.connection(), actor).enrolAccount(other, "", account);
        });
    };
    QCOMPARE(enrolled(rob, "nobody").error().code, core::ErrorCode::notFound);
    const auto tim = AccountService(*m->database).login("tim", kPassword);
    REQUIRE(tim);
    QCOMPARE(enrolled(*tim, "tim").error().code, core::ErrorCode::notAllowed);
    const auto who = enrolled(rob, "TIM"); // as at the login
    REQUIRE(who);
    const auto twice = enrolled(rob, "tim");
    QVERIFY(!twice && twice.error().code == core::ErrorCode::badInput &&
            twice.error().message.find(who->code) == std::string::npos);
    QCOMPARE(
        m->database
            ->write([&](WriteContext& w) { return StudyReader(w.connection(), rob).participantKeys(other); })
            .error()
            .code,
        core::ErrorCode::notAllowed);
    const auto keys = m->database->write(
        [&](WriteContext& w) { return StudyReader(w.connection(), m_ruth).participantKeys(other); });
    QVERIFY(keys && keys->size() == 1 && keys->front().person == m_tim && keys->front().account == "tim");
    const auto held = PrivacyRepository(*reader(), *tim).exportPerson(m_tim);
    REQUIRE(held);
    QCOMPARE(held->participations.size(), std::size_t{2});
    QCOMPARE(held->participations.back().participant.code, who->code);
    QCOMPARE(selectInteger(*reader(), "SELECT count(*) FROM audit WHERE action = 'enrolParticipant' AND "
                                      "target = 'participant_key' AND instr(detail_json, '\"account\":true')")
                 ->value_or(0),
             std::int64_t{2});
    QCOMPARE(selectInteger(
                 *reader(),
                 "SELECT count(*) FROM audit WHERE instr(detail_json, ?) OR instr(detail_json, '\"tim\"')",
                 {who->code})
                 ->value_or(-1),
             std::int64_t{0});
    REQUIRE(AccountService(*m->database).erasePerson(m_admin, kPassword, m_tim, "wish", false));
    QVERIFY(StudyReader(*reader(), m_ruth).participantByCode(other, who->code)->erased);
    const auto after = m->database->write(
        [&](WriteContext& w) { return StudyReader(w.connection(), m_ruth).participantKeys(other); });
    QVERIFY(after && after->empty());
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

/// Blind are those who conduct. Who is done with a blinded study, or has left it, gets their trials, without
/// the codes that experimenters know.
void TestStudyPrivacy::trialsOfABlindedStudyAreTheParticipants() {
    const auto tim = AccountService(*m->database).login("tim", kPassword);
    REQUIRE(tim);
    QVERIFY(PrivacyRepository(*reader(), *tim)
                .exportPerson(m_tim)
                ->participations.front()
                .sealed); // there are runs to come
    withdraw(false);
    const auto held = PrivacyRepository(*reader(), *tim).exportPerson(m_tim);
    REQUIRE(held);
    const PersonParticipation& mine = held->participations.front();
    QVERIFY(!mine.sealed && mine.trials.size() == 1 && mine.trials.front().session == m_session);
    QVERIFY(mine.runs.size() == 1 && mine.runs.front().sealedCode.empty() &&
            mine.runs.front().condition.empty() && mine.runs.front().endedUtc.empty());
    const auto byAdmin = PrivacyRepository(*reader(), m_admin).exportPerson(m_tim);
    REQUIRE(byAdmin);
    QVERIFY(byAdmin->participations.front().sealed && byAdmin->participations.front().trials.empty() &&
            !byAdmin->participations.front().runs.front().sealedCode.empty());
}

void TestStudyPrivacy::erasureNeedsWithdrawalAdministratorAndPassword() {
    AccountService accounts(*m->database);
    const auto early = accounts.eraseParticipant(m_admin, kPassword, m_participant, "wish");
    QCOMPARE(early.error().code, core::ErrorCode::wrongUse);
    QVERIFY2(early.error().message.find("withdraw first") != std::string::npos,
             early.error().message.c_str());
    withdraw(false);
    QCOMPARE(accounts.eraseParticipant(m_admin, "wrong password", m_participant, "wish").error().code,
             core::ErrorCode::notAllowed);
    QCOMPARE(accounts.eraseParticipant(m_ruth, kPassword, m_participant, "wish").error().code,
             core::ErrorCode::notAllowed);
    QCOMPARE(accounts.eraseParticipant(m_admin, kPassword, m_participant, "").error().code,
             core::ErrorCode::badInput);
    REQUIRE(accounts.eraseParticipant(m_admin, kPassword, m_participant, "wish"));
    REQUIRE(accounts.eraseParticipant(m_admin, kPassword, m_participant, "again")); // can be asked for again
}

void TestStudyPrivacy::erasureOverwritesButKeepsTrials() {
    withdraw(false);
    QVERIFY(onDisk(m->path(), "Unverwechselbar") && onDisk(m->path(), "Schmetterlingseffekt"));
    REQUIRE(AccountService(*m->database).eraseParticipant(m_admin, kPassword, m_participant, "wish"));
    QVERIFY(!onDisk(m->path(), "Unverwechselbar") && !onDisk(m->path(), "Schmetterlingseffekt"));
    const auto who = StudyReader(*reader(), m_ruth).participantByCode(m_study, m_code);
    REQUIRE(who);
    QVERIFY(who->erased && who->state == ParticipantState::withdrawn);
    QCOMPARE(
        selectInteger(*reader(), "SELECT count(*) FROM study_trial WHERE run_id = ?", {m_run})->value_or(0),
        std::int64_t{1});
    const auto answers = StudyReader(*reader(), m_ruth).questionnaireAnswers(m_study);
    for (const QuestionnaireAnswer& answer : *answers) {
        QVERIFY(!answer.number && answer.text.empty());
    }
    const auto keys = m->database->write(
        [&](WriteContext& w) { return StudyReader(w.connection(), m_ruth).participantKeys(m_study); });
    QVERIFY(keys->empty());
    QVERIFY(PrivacyRepository(*reader(), m_admin).exportPerson(m_tim)->participations.empty());
    const auto listed = PrivacyRepository(*reader(), m_admin).listErasures();
    QVERIFY(listed->size() == 1 && listed->front().participantCode == m_code &&
            listed->front().reason == "wish");
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

void TestStudyPrivacy::erasureOverwritesWhatWasSaidOfSittings() {
    const auto other = storeSession(*m->database, m_ruth, 1); // of no study
    REQUIRE(other);
    REQUIRE(m->database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), m_admin);
        auto said = sessions.addComment(m_session, "Krummstab trembled a little");
        said = said ? sessions.addComment(*other, "a Wanderfalke flew past") : said;
        return said ? sessions.voidSession(m_session, "Krummstab was called away")
                    : core::Result<void>(tl::unexpected(said.error()));
    }));
    QVERIFY(onDisk(m->path(), "Krummstab"));
    withdraw(false);
    REQUIRE(AccountService(*m->database).eraseParticipant(m_admin, kPassword, m_participant, "wish"));
    QVERIFY(!onDisk(m->path(), "Krummstab"));
    const auto comments = SessionReader(*reader(), m_ruth).comments(m_session);
    QVERIFY(comments && comments->size() == 1 &&
            comments->front().text.empty()); // that something was said stays
    QCOMPARE(SessionReader(*reader(), m_ruth).comments(*other)->front().text,
             std::string("a Wanderfalke flew past"));
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

void TestStudyPrivacy::recordingsGoWhereTheParticipantWishes_data() {
    QTest::addColumn<bool>("recordings");
    QTest::newRow("kept") << false;
    QTest::newRow("erased") << true;
}

void TestStudyPrivacy::recordingsGoWhereTheParticipantWishes() {
    QFETCH(bool, recordings);
    withdraw(recordings);
    REQUIRE(AccountService(*m->database).eraseParticipant(m_admin, kPassword, m_participant, "wish"));
    QCOMPARE(SessionReader(*reader(), Actor::maintenance()).session(m_session)->summary.recordingErased,
             recordings);
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

void TestStudyPrivacy::erasingAPersonErasesTheParticipant() {
    REQUIRE(AccountService(*m->database).erasePerson(m_admin, kPassword, m_tim, "wish", false));
    QVERIFY(!onDisk(m->path(), "Unverwechselbar") && !onDisk(m->path(), "Schmetterlingseffekt"));
    QVERIFY(StudyReader(*reader(), m_ruth).participantByCode(m_study, m_code)->erased);
    const auto answers = StudyReader(*reader(), m_ruth).questionnaireAnswers(m_study);
    QVERIFY(answers && answers->size() == 2); // that there were two stays
    for (const QuestionnaireAnswer& answer : *answers) {
        QVERIFY(!answer.number && answer.text.empty());
    }
    const auto handedIn = m->database->write([&](WriteContext& w) {
        return StudyRepository(w.connection(), m_ruth)
            .storeQuestionnaireAnswers({{m_participant, "face", "years", 12.0, "", ""}});
    });
    QVERIFY(!handedIn &&
            handedIn.error().code == core::ErrorCode::wrongUse); // nor comes anything in afterwards
    QVERIFY(!SessionReader(*reader(), Actor::maintenance()).session(m_session)->summary.recordingErased);
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

void TestStudyPrivacy::erasingAnExperimenterKeepsParticipantsRecordings() {
    const auto own = storeSession(*m->database, m_ruth, 1);
    REQUIRE(AccountService(*m->database).erasePerson(m_admin, kPassword, m_ruth.personId(), "left", true));
    QVERIFY(!SessionReader(*reader(), Actor::maintenance()).session(m_session)->summary.recordingErased);
    QVERIFY(SessionReader(*reader(), m_admin).session(*own)->summary.recordingErased);
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

void TestStudyPrivacy::restoredBackupsStayErased() {
    REQUIRE(Upkeep::backup(*m->database, m_admin, m->path("before")));
    withdraw(true);
    REQUIRE(AccountService(*m->database).eraseParticipant(m_admin, kPassword, m_participant, "wish"));
    REQUIRE(Upkeep::backup(*m->database, m_admin, m->path("after")));
    const auto carried = readErasureList(m->path("after") + "/erasures.json");
    QVERIFY(carried && carried->size() == 1 && carried->front().participantCode == m_code);
    m->database.reset();
    const auto restored = Upkeep::restore(requestFor(*m, m->path("before")), m->options);
    REQUIRE(restored);
    QCOMPARE(restored->erasuresApplied, 1);
    QVERIFY(!onDisk(m->path(), "Unverwechselbar") && !onDisk(m->path(), "Schmetterlingseffekt"));
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
    REQUIRE(m->reopen());
    QVERIFY(SessionReader(*reader(), Actor::maintenance()).session(m_session)->summary.recordingErased);
    QVERIFY(StudyReader(*reader(), m_admin).participantByCode(m_study, m_code)->erased);
}

void TestStudyPrivacy::nonceKeepsDigestsFromTelling() {
    // The same answer of two people, and of one person erased, have nothing in common that could be guessed
    // back.
    const auto hashes =
        selectInteger(*reader(), "SELECT count(DISTINCT answer_hash) FROM questionnaire_answer");
    QCOMPARE(hashes->value_or(0), std::int64_t{2});
    const auto other = m->database->write([&](WriteContext& w) {
        StudyRepository studies(w.connection(), m_ruth);
        const ParticipantNumber who = enrol(studies, m_ruth, m_study, true).value_or(0);
        return studies.storeQuestionnaireAnswers({{who, "face", "years", 41.0, "", ""}});
    });
    REQUIRE(other);
    QCOMPARE(
        selectInteger(*reader(), "SELECT count(DISTINCT answer_hash) FROM questionnaire_answer")->value_or(0),
        std::int64_t{3});
}

QTEST_GUILESS_MAIN(TestStudyPrivacy)
#include "test_study_privacy.moc"
