// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_site.h"

#include "database/integrity/verifier.h"
#include "database/privacy/erasure.h"
#include "database/query.h"

#include <algorithm>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// What is done to some rows is done to no other: each test has the rows that a statement means and, beside
/// them, those that differ in one of its conditions.
class TestRowsBeside : public QObject {
    Q_OBJECT
public:
    /// What a row of onlyTheErasedMayBeBlank() is known by.
    enum class Row { participant, session, free };
    Q_ENUM(Row)
private slots:
    void init();
    void wrongWordsAreCountedForTheirPersonAlone();
    void aMomentIsOfItsSession();
    void eventsAreNumberedWithinTheirSession();
    void onlyWhoIsThereIsErased();
    void anAuditIsOfItsPerson();
    void participantsAreExistingPeople();
    void oneParticipantIsErasedAlone();
    void onlyTheErasedMayBeBlank_data();
    void onlyTheErasedMayBeBlank();
    void aRunningSessionKeepsItsPersonAlone();
    void aRunningSessionKeepsItsParticipantAlone();
    void aRestoreErasesThatParticipantAlone();
    void aRestoredErasureNamesAnAdministratorOfTheSite();
    void aSittingIsClosedByItsOwnStudy();
    void aBlindingIsOfItsOwnStudy();
    void aTrialIsOfTheDeviceOfItsSession();
    void aRestoreAsksOnlyAdministratorsWhoCanAgree_data();
    void aRestoreAsksOnlyAdministratorsWhoCanAgree();

private:
    std::unique_ptr<Connection> reader() { return *m->database->openReader(); }
    template <class Job> auto studies(Job job) {
        return m->database->write([&](WriteContext& w) {
            StudyRepository of(w.connection(), m_ruth);
            return job(of, w.connection());
        });
    }
    template <class Job> auto sessions(Job job) {
        return m->database->write([&](WriteContext& w) {
            SessionRepository of(w.connection(), m_ruth);
            return job(of);
        });
    }
    /// With a key, two answers, a run whose first trial was recorded and whose second was not; said of the
    /// recordings, which were voided, counted again and voided for good: `words`.
    struct Taken {
        Participant who;
        SessionId session = 0;
        SessionId free =
            0; ///< of the same run, and no trial of it was stored: only its sitting says whose it is
    };
    Taken takePart(const std::string& words);
    /// Changes the closed file past every rule, as somebody could who has it.
    void tamper(const std::string& sql, std::vector<Value> values);

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous(), m_ruth = Actor::anonymous();
    StudyNumber m_study = 0;
};

void TestRowsBeside::init() {
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    m_admin = m->administrator().value();
    m_ruth = m->person(m_admin, "ruth", {Role::researcher}).value();
    const auto study = studies([&](StudyRepository& s, Connection&) -> core::Result<StudyNumber> {
        const auto made = s.createStudy("beside", "Beside", someDesign("beside"));
        const auto frozen = made ? s.freezeStudy(*made) : tl::unexpected(made.error());
        return frozen ? made : tl::unexpected(frozen.error());
    });
    REQUIRE(study);
    m_study = *study;
}

TestRowsBeside::Taken TestRowsBeside::takePart(const std::string& words) {
    Taken taken;
    taken.session = storeSession(*m->database, m_ruth, 2).value_or(0);
    const auto begun =
        studies([&](StudyRepository& s, Connection& connection) -> core::Result<StudyRunNumber> {
            const auto who = s.enrolParticipant(m_study, "called " + words, 0, "");
            const auto good = who ? s.recordConsent(who->id, consentDigest()) : tl::unexpected(who.error());
            if (who)
                taken.who = *who;
            return good ? s.beginRun({who->id, codeOf(connection, m_study, "soft"), 0, 1, "descending@1"})
                        : tl::unexpected(good.error());
        });
    if (!begun)
        qFatal("%s", begun.error().message.c_str());
    NewSession sitting = someSession();
    sitting.studyRun = *begun;
    taken.free = storeSession(*m->database, m_ruth, 2, 2000, sitting).value_or(0);
    const auto done = studies([&](StudyRepository& s, Connection&) -> core::Result<void> {
        auto good = s.storeStudyTrial(someTrial(*begun, 0, taken.session));
        good = good ? s.storeStudyTrial(someTrial(*begun, 1)) : good;
        good = good ? s.finishRun(*begun, StudyRunState::completed) : good;
        return good ? s.storeQuestionnaireAnswers({{taken.who.id, "face", "remarks", {}, words, ""},
                                                   {taken.who.id, "face", "years", 41.0, "", ""}})
                    : good;
    });
    const auto said = m->database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository s(w.connection(), m_admin);
        core::Result<void> good;
        for (const SessionId session : {taken.session, taken.free}) {
            const auto comment =
                good ? s.addComment(session, words + " trembled") : tl::unexpected(good.error());
            good = comment ? s.voidSession(session, words + " went home")
                           : core::Result<void>(tl::unexpected(comment.error()));
            good = good ? s.reinstateSession(session, words + " came back") : good;
            good = good ? s.voidSession(session, words + " went home after all") : good;
        }
        return good;
    });
    if (!done || !said)
        qFatal("%s", (!done ? done.error() : said.error()).message.c_str());
    return taken;
}

void TestRowsBeside::tamper(const std::string& sql, std::vector<Value> values) {
    auto connection = Connection::open(m->path(), Connection::Mode::readWrite);
    REQUIRE(connection);
    auto query = Query::run(**connection, sql, std::move(values));
    REQUIRE(query);
    REQUIRE(query->next());
}

void TestRowsBeside::wrongWordsAreCountedForTheirPersonAlone() {
    const auto tim = m->person(m_admin, "tim", {Role::trainee}),
               zoe = m->person(m_admin, "zoe", {Role::trainee});
    AccountService accounts(*m->database);
    const std::array<std::pair<const Actor*, int>, 2> wrong{std::pair{&*tim, 3}, std::pair{&*zoe, 1}};
    for (const auto& [who, times] : wrong)
        for (int i = 0; i < times; ++i) {
            QVERIFY(!accounts.login(who->name(), "not the word 12"));
            m->clock->advance_s(3600);
        }
    for (const auto& [who, times] : wrong) {
        const auto held = PrivacyRepository(*reader(), m_admin).exportPerson(who->personId());
        REQUIRE(held);
        QCOMPARE(held->failedLogins, times);
        QVERIFY(held->hasPassword);
    }
    QCOMPARE(PrivacyRepository(*reader(), m_admin).exportPerson(m_ruth.personId())->failedLogins, 0);
    for (const auto& [who, times] : wrong) {
        REQUIRE(accounts.login(who->name(), kPassword));
        QCOMPARE(selectText(*reader(),
                            "SELECT detail_json FROM audit WHERE action = 'login' AND target_id = ? ORDER BY "
                            "sequence DESC LIMIT 1",
                            {who->personId()})
                     ->value_or(""),
                 "{\"wrong_before\":" + std::to_string(times) + "}");
        QCOMPARE(PrivacyRepository(*reader(), m_admin).exportPerson(who->personId())->failedLogins, 0);
    }
    // The tombstone vouches for who was there by that person's own digest.
    const auto digest =
        selectText(*reader(), "SELECT lower(hex(digest)) FROM person WHERE id = ?", {tim->personId()})
            ->value_or("");
    REQUIRE(accounts.erasePerson(m_admin, kPassword, tim->personId(), "wish", false));
    const auto digests =
        selectText(*reader(), "SELECT digests_json FROM erasure WHERE person_id = ?", {tim->personId()})
            ->value_or("");
    QVERIFY2(!digest.empty() && digests.find("\"person\":\"" + digest + "\"") != std::string::npos,
             digests.c_str());
}

void TestRowsBeside::aMomentIsOfItsSession() {
    const auto ended = storeSession(*m->database, m_ruth); // 1000 ticks
    REQUIRE(ended);
    const auto longer = sessions([](SessionRepository& s) -> core::Result<SessionId> {
        const auto id = s.beginSession(someSession());
        auto done = id ? s.finishSession(*id, {SessionState::stopped, 2000, 2000, 0, "{}"})
                       : core::Result<void>(tl::unexpected(id.error()));
        return done ? id : tl::unexpected(done.error());
    });
    const auto running = sessions([](SessionRepository& s) { return s.beginSession(someSession()); });
    REQUIRE(longer);
    REQUIRE(running);
    const auto comment = [&](SessionId id, std::uint64_t tick) {
        return sessions([&](SessionRepository& s) { return s.addComment(id, "here", tick); });
    };
    for (const auto& [id, last] : {std::pair{*ended, 1000ULL}, std::pair{*longer, 2000ULL}}) {
        REQUIRE(comment(id, last));
        const auto beyond = comment(id, last + 1);
        QVERIFY(!beyond && beyond.error().code == core::ErrorCode::badInput);
        QVERIFY2(beyond.error().message.find(std::to_string(last + 1)) != std::string::npos,
                 beyond.error().message.c_str());
    }
    REQUIRE(comment(*running, 123456)); // how long it will be is not known yet
}

void TestRowsBeside::eventsAreNumberedWithinTheirSession() {
    const auto first = sessions([](SessionRepository& s) { return s.beginSession(someSession()); });
    const auto second = sessions([](SessionRepository& s) { return s.beginSession(someSession()); });
    REQUIRE(first);
    REQUIRE(second);
    const EventRecord event{17, 0.017, 0, "marked", "{}"};
    const std::vector<EventRecord> two{event, event}, three{event, event, event};
    for (const auto& [id, events] :
         {std::pair{*first, three}, std::pair{*second, two}, std::pair{*first, two}, std::pair{*second, two}})
        REQUIRE(sessions([&](SessionRepository& s) { return s.storeEvents(id, events); }));
    const auto ordinals = [&](SessionId id) {
        return selectText(*reader(),
                          "SELECT group_concat(ordinal) FROM (SELECT ordinal FROM event WHERE session_id = ? "
                          "ORDER BY rowid)",
                          {id})
            ->value_or("");
    };
    QCOMPARE(ordinals(*first), std::string("0,1,2,3,4"));
    QCOMPARE(ordinals(*second), std::string("0,1,2,3"));
}

void TestRowsBeside::onlyWhoIsThereIsErased() {
    AccountService accounts(*m->database);
    const auto nobody = accounts.erasePerson(m_admin, kPassword, 4711, "wish", false);
    QVERIFY(!nobody);
    QCOMPARE(nobody.error().code, core::ErrorCode::notFound);
    const auto machine =
        accounts.erasePerson(m_admin, kPassword, Actor::simulated().personId(), "wish", false);
    QVERIFY(!machine);
    QVERIFY(PrivacyRepository(*reader(), m_admin).listErasures()->empty());
    QCOMPARE(selectInteger(*reader(), "SELECT count(*) FROM person WHERE name LIKE 'erased-%'")->value_or(-1),
             std::int64_t{0});
}

void TestRowsBeside::anAuditIsOfItsPerson() {
    const auto tim = m->person(m_admin, "tim", {Role::trainee});
    REQUIRE(tim);
    // Sessions, studies and participants have numbers of their own: some of them are his.
    while (storeSession(*m->database, m_ruth, 1).value_or(0) < tim->personId()) {
    }
    while (takePart("somebody").who.id < tim->personId()) {
    }
    REQUIRE(storeSession(*m->database, *tim, 1));
    REQUIRE(sessions([&](SessionRepository& s) {
        return s.addComment(tim->personId(), "of the session with his number");
    }));
    AccountService accounts(*m->database);
    REQUIRE(accounts.setRoles(m_admin, tim->personId(), {Role::trainee, Role::trainer}));
    const auto whole = AuditRepository(*reader(), m_admin).listAudit();
    REQUIRE(whole);
    for (const Actor& person : {*tim, m_ruth, m_admin}) {
        const auto held = PrivacyRepository(*reader(), m_admin).exportPerson(person.personId());
        REQUIRE(held);
        std::vector<std::int64_t> wanted, got;
        for (const AuditEntry& entry : held->audit)
            got.push_back(entry.sequence);
        const auto connection = reader();
        auto query = Query::run(
            *connection,
            "SELECT sequence, actor_kind, actor_id, target, target_id FROM audit ORDER BY sequence");
        int others = 0;
        for (auto row = query->next(); row && *row; row = query->next()) {
            const bool by = query->text(1) == "person" && query->integer(2) == person.personId();
            const bool about = (query->text(3) == "person" || query->text(3) == "credential") &&
                               query->integer(4) == person.personId();
            if (by || about)
                wanted.push_back(query->integer(0));
            others +=
                !by && !about &&
                        (query->integer(2) == person.personId() || query->integer(4) == person.personId())
                    ? 1
                    : 0;
        }
        QVERIFY(person.personId() != tim->personId() || others > 0); // something else has the number
        QVERIFY(wanted == got && !got.empty());
        QVERIFY(wanted.size() < whole->size());
    }
}

void TestRowsBeside::participantsAreExistingPeople() {
    const auto tim = m->person(m_admin, "tim", {Role::trainee});
    REQUIRE(tim);
    const auto enrolled = [&](PersonId person) {
        return studies([&](StudyRepository& s, Connection&) {
            return s.enrolParticipant(m_study, "somebody", person, "");
        });
    };
    QVERIFY(!enrolled(4711));
    QVERIFY(!enrolled(Actor::simulated().personId()));
    REQUIRE(enrolled(tim->personId()));
    QVERIFY(!enrolled(tim->personId())); // twice
    REQUIRE(enrolled(m_ruth.personId()));
}

void TestRowsBeside::oneParticipantIsErasedAlone() {
    const Taken before = takePart("Wanderfalke"), gone = takePart("Krummstab"), after = takePart("Sperling");
    const auto free = storeSession(*m->database, m_ruth, 2); // of no study
    REQUIRE(sessions([&](SessionRepository& s) { return s.addComment(*free, "a Reiher flew past"); }));
    const auto seal =
        selectText(*reader(), "SELECT lower(hex(seal)) FROM session WHERE id = ?", {gone.session})
            ->value_or("");
    const auto keyHash =
        selectText(*reader(), "SELECT lower(hex(key_hash)) FROM participant_key WHERE id = ?", {gone.who.id})
            ->value_or("");
    REQUIRE(
        studies([&](StudyRepository& s, Connection&) { return s.withdrawParticipant(gone.who.id, true); }));
    const auto erased =
        AccountService(*m->database).eraseParticipant(m_admin, kPassword, gone.who.id, "wish");
    REQUIRE(erased);
    const auto connection = reader();
    QVERIFY(SessionReader(*connection, Actor::maintenance()).session(gone.session)->summary.recordingErased);
    QVERIFY(SessionReader(*connection, Actor::maintenance()).session(gone.free)->summary.recordingErased);
    QCOMPARE(
        selectInteger(*connection, "SELECT count(*) FROM session WHERE recording_erased = 1")->value_or(-1),
        std::int64_t{2});
    for (const Taken* other : {&before, &after}) {
        const auto text = [&](const char* sql, std::int64_t id) {
            return selectText(*connection, sql, {id})->value_or("");
        };
        QVERIFY(!text("SELECT text FROM session_comment WHERE session_id = ?", other->session).empty());
        QVERIFY(!text("SELECT void_reason FROM session WHERE id = ?", other->session).empty());
        QVERIFY(!text("SELECT key_json FROM participant_key WHERE id = ?", other->who.id).empty());
        QCOMPARE(
            selectInteger(*connection,
                          "SELECT count(*) FROM session_decision WHERE session_id IN (?, ?) AND reason <> ''",
                          {other->session, other->free})
                ->value_or(-1),
            std::int64_t{4});
        QCOMPARE(
            selectInteger(
                *connection,
                "SELECT count(*) FROM questionnaire_answer WHERE participant_id = ? AND answer_json <> ''",
                {other->who.id})
                ->value_or(-1),
            std::int64_t{2});
        QCOMPARE(selectInteger(*connection,
                               "SELECT count(*) FROM chunk WHERE session_id = ? AND length(payload) > 0",
                               {other->session})
                     ->value_or(-1),
                 std::int64_t{2});
    }
    QCOMPARE(selectInteger(*connection,
                           "SELECT count(*) FROM chunk WHERE session_id = ? AND length(payload) > 0",
                           {gone.session})
                 ->value_or(-1),
             std::int64_t{0});
    QCOMPARE(
        selectInteger(*connection, "SELECT count(*) FROM session_decision WHERE reason <> ''")->value_or(-1),
        std::int64_t{8}); // of the other two
    QCOMPARE(selectText(*connection, "SELECT text FROM session_comment WHERE session_id = ?", {*free})
                 ->value_or(""),
             std::string("a Reiher flew past"));
    const auto digests =
        selectText(*connection, "SELECT digests_json FROM participant_erasure WHERE id = ?", {gone.who.id})
            ->value_or("");
    QVERIFY2(!keyHash.empty() && digests.find("\"key\":\"" + keyHash + "\"") != std::string::npos,
             digests.c_str());
    auto answers = Query::run(*connection,
                              "SELECT participant_id, id, lower(hex(answer_hash)) FROM questionnaire_answer");
    int own = 0;
    for (auto row = answers->next(); row && *row; row = answers->next()) {
        const std::string entry = "\"" + answers->text(1) + "\":\"" + answers->text(2) + "\"";
        QCOMPARE(digests.find(entry) != std::string::npos, answers->integer(0) == gone.who.id);
        own += answers->integer(0) == gone.who.id ? 1 : 0;
    }
    QCOMPARE(own, 2);
    QVERIFY2(!seal.empty() && digests.find("\"" + std::to_string(gone.session) + "\":\"" + seal + "\"") !=
                                  std::string::npos,
             digests.c_str());
}

// A text may be missing where its person was erased, and nowhere else.
void TestRowsBeside::onlyTheErasedMayBeBlank_data() {
    QTest::addColumn<QString>("table");
    QTest::addColumn<QString>("sql");
    QTest::addColumn<Row>("row");
    QTest::newRow("key") << "participant_key"
                         << "UPDATE participant_key SET key_json = '' WHERE id = ?" << Row::participant;
    QTest::newRow("answer") << "questionnaire_answer"
                            << "UPDATE questionnaire_answer SET answer_json = '' WHERE participant_id = ?"
                            << Row::participant;
    for (const auto& [row, of] : {std::pair{Row::session, "a session"}, std::pair{Row::free, "a sitting"}}) {
        QTest::addRow("comment of %s", of)
            << "session_comment"
            << "UPDATE session_comment SET text = '' WHERE session_id = ?" << row;
        QTest::addRow("reason of %s", of) << "session"
                                          << "UPDATE session SET void_reason = '' WHERE id = ?" << row;
        QTest::addRow("decision on %s", of)
            << "session_decision"
            << "UPDATE session_decision SET reason = '' WHERE session_id = ?" << row;
        QTest::addRow("recording of %s", of) << "chunk"
                                             << "UPDATE chunk SET payload = x'' WHERE session_id = ?" << row;
    }
}

void TestRowsBeside::onlyTheErasedMayBeBlank() {
    QFETCH(QString, table);
    QFETCH(QString, sql);
    QFETCH(Row, row);
    const auto tim = m->person(m_admin, "tim", {Role::trainee});
    REQUIRE(storeSession(*m->database, *tim, 2));
    const Taken other = takePart("Wanderfalke"), gone = takePart("Krummstab");
    REQUIRE(
        studies([&](StudyRepository& s, Connection&) { return s.withdrawParticipant(gone.who.id, true); }));
    REQUIRE(AccountService(*m->database).eraseParticipant(m_admin, kPassword, gone.who.id, "wish"));
    REQUIRE(AccountService(*m->database).erasePerson(m_admin, kPassword, tim->personId(), "wish", true));
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
    tamper(sql.toStdString(), {row == Row::session ? other.session
                               : row == Row::free  ? other.free
                                                   : other.who.id});
    const VerifyReport report = verifyDatabase(m->path(), m->options);
    QVERIFY(std::any_of(report.findings.begin(), report.findings.end(),
                        [&](const Finding& f) { return f.table == table.toStdString(); }));
}

void TestRowsBeside::aRunningSessionKeepsItsPersonAlone() {
    const auto tim = m->person(m_admin, "tim", {Role::trainee}),
               zoe = m->person(m_admin, "zoe", {Role::trainee});
    REQUIRE(tim);
    REQUIRE(zoe);
    REQUIRE(storeSession(*m->database, *tim, 1));
    REQUIRE(storeSession(*m->database, *zoe, 1));
    const auto ofTim = [&](auto job) {
        return m->database->write([&](WriteContext& w) {
            SessionRepository of(w.connection(), *tim);
            return job(of);
        });
    };
    const auto running = ofTim([](SessionRepository& s) { return s.beginSession(someSession()); });
    REQUIRE(running);
    AccountService accounts(*m->database);
    const auto erased = [&](const Actor& who) {
        return accounts.erasePerson(m_admin, kPassword, who.personId(), "wish", true);
    };
    const auto early = erased(*tim);
    QVERIFY(!early);
    QCOMPARE(early.error().code, core::ErrorCode::wrongUse);
    REQUIRE(erased(*zoe)); // whose own has ended
    REQUIRE(ofTim([&](SessionRepository& s) {
        return s.finishSession(*running, {SessionState::stopped, 1, 1, 0, "{}"});
    }));
    REQUIRE(erased(*tim));
}

void TestRowsBeside::aRunningSessionKeepsItsParticipantAlone() {
    const Taken first = takePart("Wanderfalke"), second = takePart("Krummstab");
    const auto running = sessions([](SessionRepository& s) { return s.beginSession(someSession()); });
    REQUIRE(running);
    REQUIRE(studies([&](StudyRepository& s, Connection& connection) -> core::Result<void> {
        const auto run =
            s.beginRun({first.who.id, codeOf(connection, m_study, "hard"), 1, 1, "descending@1"});
        return run ? s.storeStudyTrial(someTrial(*run, 0, *running))
                   : core::Result<void>(tl::unexpected(run.error()));
    }));
    for (const Taken* each : {&first, &second})
        REQUIRE(studies(
            [&](StudyRepository& s, Connection&) { return s.withdrawParticipant(each->who.id, false); }));
    AccountService accounts(*m->database);
    const auto early = accounts.eraseParticipant(m_admin, kPassword, first.who.id, "wish");
    QCOMPARE(early.error().code, core::ErrorCode::wrongUse);
    QCOMPARE(early.error().message, std::string("a session of this participant has not ended yet"));
    REQUIRE(accounts.eraseParticipant(m_admin, kPassword, second.who.id, "wish"));
    REQUIRE(sessions([&](SessionRepository& s) {
        return s.finishSession(*running, {SessionState::stopped, 1, 1, 0, "{}"});
    }));
    REQUIRE(accounts.eraseParticipant(m_admin, kPassword, first.who.id, "wish"));
}

void TestRowsBeside::aRestoreErasesThatParticipantAlone() {
    const Taken first = takePart("Wanderfalke"), gone = takePart("Krummstab"), last = takePart("Sperling");
    REQUIRE(Upkeep::backup(*m->database, m_admin, m->path("before")));
    REQUIRE(
        studies([&](StudyRepository& s, Connection&) { return s.withdrawParticipant(gone.who.id, false); }));
    REQUIRE(AccountService(*m->database).eraseParticipant(m_admin, kPassword, gone.who.id, "wish"));
    m->database.reset();
    const auto restored = Upkeep::restore(requestFor(*m, m->path("before")), m->options);
    REQUIRE(restored);
    QCOMPARE(restored->erasuresApplied, 1);
    REQUIRE(m->reopen());
    for (const auto& [taken, erased] :
         {std::pair{&first, false}, std::pair{&gone, true}, std::pair{&last, false}})
        QCOMPARE(StudyReader(*reader(), m_admin).participantByCode(m_study, taken->who.code)->erased, erased);
}

void TestRowsBeside::aRestoredErasureNamesAnAdministratorOfTheSite() {
    const auto tim = m->person(m_admin, "tim", {Role::trainee}),
               tom = m->person(m_admin, "tom", {Role::trainee});
    REQUIRE(Upkeep::backup(*m->database, m_admin, m->path("before")));
    const auto zoe = m->person(m_admin, "zoe", {Role::admin});
    REQUIRE(zoe);
    AccountService accounts(*m->database);
    REQUIRE(accounts.erasePerson(*zoe, kPassword, tim->personId(), "of zoe", true));
    REQUIRE(accounts.erasePerson(m_admin, kPassword, tom->personId(), "of ada", true));
    m->database.reset();
    REQUIRE(Upkeep::restore(requestFor(*m, m->path("before")), m->options)); // zoe was not there then
    REQUIRE(m->reopen());
    const auto erasures = PrivacyRepository(*reader(), m_admin).listErasures();
    REQUIRE(erasures);
    QCOMPARE(erasures->size(), std::size_t{2});
    for (const Erasure& erasure : *erasures)
        QCOMPARE(erasure.administrator, m_admin.personId());
}

// A blinded study beside one that was unblinded: by its trials, and before those by its title.
void TestRowsBeside::aSittingIsClosedByItsOwnStudy() {
    const auto open = makeStudies(*m->database, m_ruth, "open"),
               closed = makeStudies(*m->database, m_ruth, "closed");
    REQUIRE(open);
    REQUIRE(closed);
    REQUIRE(studies(
        [&](StudyRepository& s, Connection&) { return s.unblindStudy(open->frozen, "all are done"); }));
    const auto titled = [&](const std::string& key, StudyNumber study) {
        NewSession setup = someSession();
        setup.exercise = "comparison";
        setup.contentJson =
            R"({"level":{"title":{"en":")" + key + " / " + codeOf(*reader(), study, "hard") + R"("}}})";
        return sessions([&](SessionRepository& s) { return s.beginSession(setup); }).value_or(0);
    };
    const auto ofTrial = [&](StudyRunNumber run) {
        const SessionId id =
            sessions([](SessionRepository& s) { return s.beginSession(someSession()); }).value_or(0);
        const auto stored = studies(
            [&](StudyRepository& s, Connection&) { return s.storeStudyTrial(someTrial(run, 1, id)); });
        return stored ? id : 0;
    };
    const SessionId openTitle = titled("open", open->frozen), closedTitle = titled("closed", closed->frozen),
                    crossed = titled("open", closed->frozen);
    const SessionId openTrial = ofTrial(open->run), closedTrial = ofTrial(closed->run);
    const SessionId free = storeSession(*m->database, m_ruth, 1).value_or(0);
    const auto connection = reader();
    for (const auto& [id, sealed] : {std::pair{openTitle, false},
                                     {closedTitle, true},
                                     {crossed, false},
                                     {openTrial, false},
                                     {closedTrial, true},
                                     {free, false}}) {
        QVERIFY(id > 0);
        const auto session = SessionReader(*connection, m_ruth).session(id);
        QCOMPARE(!session, sealed);
        QVERIFY(session || session.error().code == core::ErrorCode::notAllowed);
    }
    const auto listed = SessionReader(*connection, m_ruth).listSessions();
    REQUIRE(listed);
    for (const SessionSummary& line : *listed) // a list keeps back what the session itself keeps back
        QCOMPARE(line.sealed, line.id == closedTitle || line.id == closedTrial);
}

// A study that was unblinded shows its conditions, trials and codes, although the one beside it is still
// blinded.
void TestRowsBeside::aBlindingIsOfItsOwnStudy() {
    const auto open = makeStudies(*m->database, m_ruth, "open"),
               closed = makeStudies(*m->database, m_ruth, "closed");
    REQUIRE(open);
    REQUIRE(closed);
    REQUIRE(studies(
        [&](StudyRepository& s, Connection&) { return s.unblindStudy(open->frozen, "all are done"); }));
    const auto connection = reader();
    StudyReader reads(*connection, m_ruth);
    for (const auto& [of, told] : {std::pair{&*open, true}, std::pair{&*closed, false}}) {
        const auto runs = reads.runs(of->running);
        REQUIRE(runs);
        QCOMPARE(runs->size(), std::size_t{1});
        QCOMPARE(runs->front().condition, std::string(told ? "hard" : ""));
        QCOMPARE(runs->front().procedures, std::string(told ? "descending@1" : ""));
        const auto trials = reads.studyTrials(of->run);
        REQUIRE(trials);
        QCOMPARE(trials->size(), std::size_t{told ? 1U : 0U});
        const auto codes = reads.conditionCodes(of->frozen);
        REQUIRE(codes);
        QCOMPARE(codes->size(), std::size_t{2});
        for (const SealedCondition& each : *codes)
            QCOMPARE(each.condition.empty(), !told);
    }
}

void TestRowsBeside::aTrialIsOfTheDeviceOfItsSession() {
    const auto made = makeStudies(*m->database, m_ruth, "devices");
    REQUIRE(made);
    const auto on = [&](bool felt, const std::string& device) {
        NewSession setup = someSession();
        setup.felt = felt;
        setup.deviceJson = device;
        return sessions([&](SessionRepository& s) { return s.beginSession(setup); }).value_or(0);
    };
    const std::array<SessionId, 3> of{on(true, R"({"tools":[{"model":"first","driver":"x"}]})"),
                                      on(false, R"({"tools":[{"driver":"second"}]})"),
                                      on(true, R"({"tools":[{"model":"third"},{"model":"other"}]})")};
    const std::array<std::size_t, 3> order{2, 1, 0}; // not the order in which they were stored
    for (int i = 0; i < 3; ++i)
        REQUIRE(studies([&](StudyRepository& s, Connection&) {
            return s.storeStudyTrial(someTrial(made->run, i + 1, of[order[static_cast<std::size_t>(i)]]));
        }));
    const auto qualities =
        StudyReader(*reader(), m_ruth).trialQuality(made->frozen); // of a blinded study, too
    REQUIRE(qualities);
    for (const ParticipantQuality& quality : *qualities) {
        const bool running = quality.participant == made->running;
        QCOMPARE(QString::fromStdString(quality.device),
                 running ? QStringLiteral("first, second, third") : QString());
        QVERIFY(running ? quality.felt == false : !quality.felt); // one trial of it was only shown
    }
    REQUIRE(studies(
        [&](StudyRepository& s, Connection&) { return s.unblindStudy(made->frozen, "all are done"); }));
    const auto trials = StudyReader(*reader(), m_ruth).studyTrials(made->run);
    REQUIRE(trials);
    QCOMPARE(trials->size(), std::size_t{4});
    QVERIFY(!trials->at(0).felt && trials->at(0).device.empty()); // of no session
    const std::array<const char*, 3> names{"third", "second", "first"};
    for (std::size_t i = 0; i < 3; ++i) {
        const StudyTrial& trial = trials->at(i + 1);
        QCOMPARE(trial.session, of[order[i]]);
        QCOMPARE(trial.felt.value_or(false), i != 1);
        QVERIFY2(trial.device.find(names[i]) != std::string::npos, trial.device.c_str());
    }
}

void TestRowsBeside::aRestoreAsksOnlyAdministratorsWhoCanAgree_data() {
    QTest::addColumn<QString>("sql");
    QTest::addColumn<bool>("asks");
    QTest::newRow("an administrator")
        << "UPDATE person SET display_name = display_name WHERE kind = ?" << true;
    QTest::newRow("disabled") << "UPDATE person SET enabled = 0 WHERE kind = ? AND instr(roles, 'admin') > 0"
                              << false;
    QTest::newRow("enabled people without the role")
        << "UPDATE person SET roles = 'trainer' WHERE kind = ?" << false;
}

// A file in which nobody can agree any more is replaced without asking.
void TestRowsBeside::aRestoreAsksOnlyAdministratorsWhoCanAgree() {
    QFETCH(QString, sql);
    QFETCH(bool, asks);
    REQUIRE(Upkeep::backup(*m->database, m_admin, m->path("backup")));
    REQUIRE(AccountService(*m->database)
                .changePassword(m_admin, kPassword,
                                "newer horse 77")); // the word of the backup is no longer hers
    m->database.reset();
    tamper(sql.toStdString(), {std::string("person")});
    const auto restored = Upkeep::restore(requestFor(*m, m->path("backup")), m->options);
    QCOMPARE(restored.has_value(), !asks);
}

QTEST_GUILESS_MAIN(TestRowsBeside)
#include "test_rows_beside.moc"
