// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"
#include "study_site.h"

#include "database/integrity/verifier.h"
#include "database/query.h"
#include "database/repositories/session_seal.h"

#include <QCryptographicHash>
#include <QScopeGuard>
#include <bit>
#include <cmath>
#include <ctime>
#include <limits>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Sessions, recordings and scores come back as they were stored.
class TestSessions : public QObject {
    Q_OBJECT
private slots:
    void everythingComesBack();
    void everyFieldIsItsOwn();
    void listsChooseWhatIsAsked();
    void scoresComeBackBitForBit();
    void scoresAreNamedByTheirSeal();
    void scoresOfTrialsThatAreNotThereAreDamage();
    void contentIsSharedAndHashed();
    void endedSessionsAreClosed();
    void voidedAndArchivedStay();
    void aVoidedSessionCountsAgain();
    void aVoidingThatWasTakenBackKeepsItsTime();
    void attemptsAreNumbered();
    void aDemonstrationCountsItsOperators();
    void aSittingIsNoAttempt();
    void theLatestAttemptAwaitsReview();
    void commentsAreFoundAgain();
    void aLineIsOfItsSession();
    void badInputNamesTheField();
};

void TestSessions::everythingComesBack() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto id = storeSession(*f.database, Actor::simulated());
    REQUIRE(id);
    QCOMPARE(*id, SessionId{1});
    auto reader = f.database->openReader();
    SessionReader sessions(**reader, Actor::anonymous());
    const auto record = sessions.session(*id);
    REQUIRE(record);
    const NewSession expected = someSession();
    QCOMPARE(record->setup.seed, expected.seed);
    QCOMPARE(record->setup.exercise, expected.exercise);
    QCOMPARE(record->setup.level, expected.level);
    QCOMPARE(record->setup.contentJson, expected.contentJson);
    QCOMPARE(record->setup.deviceJson, expected.deviceJson);
    QCOMPARE(record->setup.mappingJson, expected.mappingJson);
    QCOMPARE(record->setup.supervisorJson, expected.supervisorJson);
    QCOMPARE(record->setup.versionsJson, expected.versionsJson);
    QCOMPARE(record->setup.channelTable, expected.channelTable);
    QCOMPARE(record->setup.operatorName, expected.operatorName);
    QCOMPARE(record->setup.forceLimit_N, expected.forceLimit_N);
    QCOMPARE(record->setup.ringFile, std::string()); // the ring is gone once the session has ended
    QVERIFY(record->summary.felt);
    QVERIFY(record->summary.state == SessionState::completed);
    QCOMPARE(record->summary.chunks, std::uint64_t{4});
    QCOMPARE(record->summary.recordingBytes, std::uint64_t{2800});
    QCOMPARE(record->summary.passed, std::optional(true));
    auto chunks = sessions.openChunks(*id);
    REQUIRE(chunks);
    QCOMPARE((*chunks)->chunkCount(), std::size_t{4});
    QCOMPARE(*(*chunks)->channelTable(), expected.channelTable);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const auto chunk = (*chunks)->chunk(i);
        REQUIRE(chunk);
        const auto stored = someChunk(i);
        QVERIFY(chunk->payload == stored.payload && chunk->payloadDigest == stored.payloadDigest &&
                chunk->forceHash == stored.forceHash);
        QCOMPARE(chunk->firstTick, stored.firstTick);
        QCOMPARE(chunk->frames, stored.frames);
    }
    QCOMPARE((*chunks)->chunk(4).error().code, core::ErrorCode::notFound);
    const auto seconds = sessions.secondSummaries(*id);
    REQUIRE(seconds);
    QCOMPARE(seconds->size(), std::size_t{4});
    QCOMPARE((*seconds)[2].maximumForce_N, 1.5);
    QCOMPARE(sessions.trials(*id)->front().sceneJson, std::string(R"({"R_m":0.02})"));
    QCOMPARE(sessions.events(*id)->front().kind, std::string("marked"));
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

// No field stands for another: two sessions that differ in everything, each field with a value that no other
// has.
void TestSessions::everyFieldIsItsOwn() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    qputenv("TZ", "XXX-5:45"); // a quarter to six ahead
    tzset();
    const auto back = qScopeGuard([] {
        qunsetenv("TZ");
        tzset();
    });
    NewSession one = someSession();
    NewSession other{
        "palpation",  3,       R"({"b":2})", 77,  "", false, R"({"d":1})", R"({"m":2})", R"({"s":3})",
        R"({"v":4})", "built", "chip",       2.5, 7,  true,  true,         "/run/other", {9, 8}};
    const std::vector<TrialRecord> trials{
        {0, 5, SessionState::stopped, 11, 22, true, false, R"({"t":0})"},
        {1, 0xfedcba9876543210ULL, SessionState::completed, 33, 44, false, true, R"({"t":1})"}};
    const std::vector<EventRecord> events{{17, 0.017, 1, "first", R"({"e":1})"},
                                          {18, 0.25, 2, "second", R"({"e":2})"}};
    const std::vector<recording::SecondSummary> seconds{{0, 1, 251, 0.01, 1.5, 0.5, 0.25, 0.125, 3},
                                                        {2, 3, 252, 0.02, 2.5, 0.75, 0.375, 0.0625, 4}};
    recording::Chunk chunk = someChunk(0, 33);
    const auto begun = f.database->write([&](WriteContext& w) -> core::Result<SessionId> {
        const auto first = SessionRepository(w.connection(), Actor::simulated()).beginSession(one);
        return first ? SessionRepository(w.connection(), *ada).beginSession(other) : first;
    });
    REQUIRE(begun);
    QCOMPARE(*begun, SessionId{2});
    const auto read = [&](SessionId id) {
        auto reader = f.database->openReader();
        return SessionReader(**reader, *ada).session(id).value();
    };
    QCOMPARE(read(1).setup.ringFile, one.ringFile);
    QVERIFY(read(2).setup.ringFile == "/run/other" && read(2).summary.state == SessionState::running &&
            read(2).endedUtc.empty());
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), *ada);
        auto sink = sessions.openSink(2);
        auto done = sink ? (*sink)->write({&chunk, 1}, seconds) : tl::unexpected(sink.error());
        for (const TrialRecord& trial : trials) {
            done = done ? sessions.storeTrial(2, trial) : done;
        }
        done = done ? sessions.storeEvents(2, events) : done;
        done = done ? sessions.finishSession(2, {SessionState::incomplete, 901, 802, 703, R"({"late":1})"})
                    : done;
        const auto comment = done ? sessions.addComment(2, "a word", 42) : tl::unexpected(done.error());
        done = comment ? sessions.setArchived(2, true) : tl::unexpected(comment.error());
        return done ? sessions.voidSession(2, "the chair fell") : done;
    }));
    const SessionRecord got = read(2);
    const SessionSummary& line = got.summary;
    QVERIFY(line.id == 2 && line.person == ada->personId() && line.personName == "ada" &&
            line.exercise == "palpation" && line.level == 3);
    QVERIFY(line.state == SessionState::voided && got.stateBeforeVoid == SessionState::incomplete);
    QVERIFY(got.voidReason == "the chair fell" && got.voidedBy == ada->personId());
    QCOMPARE(line.utcOffset_min, 345);
    QVERIFY(line.operatorName.empty() && !line.felt && line.familiarisation && !line.demonstration &&
            line.archived && !line.recordingErased && !line.passed);
    QVERIFY(line.ticks == 901 && line.frames == 802 && line.dropped == 703 && line.chunks == 1 &&
            line.recordingBytes == 33 && !line.sealed);
    QVERIFY(!line.startedUtc.empty() && got.endedUtc >= line.startedUtc);
    const NewSession& setup = got.setup;
    QVERIFY(setup.exercise == "palpation" && setup.level == 3 && setup.contentJson == R"({"b":2})" &&
            setup.seed == 77 && setup.operatorName.empty() && !setup.felt);
    QVERIFY(setup.deviceJson == R"({"d":1})" && setup.mappingJson == R"({"m":2})" &&
            setup.supervisorJson == R"({"s":3})" && setup.versionsJson == R"({"v":4})");
    QVERIFY(setup.buildId == "built" && setup.cpuClass == "chip" && setup.forceLimit_N == 2.5 &&
            setup.plannedTrials == 7);
    QVERIFY(setup.familiarisation && setup.realtime && setup.ringFile.empty() &&
            setup.channelTable == (std::vector<std::uint8_t>{9, 8}));
    QCOMPARE(got.contentSha256,
             QCryptographicHash::hash(R"({"b":2})", QCryptographicHash::Sha256).toHex().toStdString());
    QCOMPARE(got.loopJson, std::string(R"({"late":1})"));
    const SessionRecord first = read(1);
    QVERIFY(first.setup.buildId == "build" && first.setup.cpuClass == "cpu" &&
            first.setup.plannedTrials == 10 && !first.setup.realtime && !first.setup.familiarisation);
    QVERIFY(first.summary.felt && !first.summary.archived &&
            first.summary.person == Actor::kSimulatedPerson && !first.stateBeforeVoid && first.voidedBy == 0);

    auto reader = f.database->openReader();
    SessionReader sessions(**reader, *ada);
    const auto storedTrials = sessions.trials(2);
    REQUIRE(storedTrials);
    QCOMPARE(storedTrials->size(), trials.size());
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const TrialRecord &a = trials[i], &b = storedTrials->at(i);
        QVERIFY(a.index == b.index && a.seed == b.seed && a.state == b.state && a.firstTick == b.firstTick &&
                a.lastTick == b.lastTick && a.marked == b.marked && a.timedOut == b.timedOut &&
                a.sceneJson == b.sceneJson);
    }
    const auto storedEvents = sessions.events(2);
    REQUIRE(storedEvents);
    QCOMPARE(storedEvents->size(), events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
        const EventRecord &a = events[i], &b = storedEvents->at(i);
        QVERIFY(a.tick == b.tick && a.time_s == b.time_s && a.tool == b.tool && a.kind == b.kind &&
                a.detailJson == b.detailJson);
    }
    const auto storedSeconds = sessions.secondSummaries(2);
    REQUIRE(storedSeconds);
    QCOMPARE(storedSeconds->size(), seconds.size());
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        const recording::SecondSummary &a = seconds[i], &b = storedSeconds->at(i);
        QVERIFY(a.second == b.second && a.tool == b.tool && a.frames == b.frames &&
                a.pathLength_m == b.pathLength_m && a.maximumForce_N == b.maximumForce_N &&
                a.meanForce_N == b.meanForce_N && a.impulse_Ns == b.impulse_Ns &&
                a.timeOverLimit_s == b.timeOverLimit_s && a.events == b.events);
    }
    const auto comments = sessions.comments(2);
    REQUIRE(comments);
    QVERIFY(comments->size() == 1 && comments->front().id == 1 &&
            comments->front().author == ada->personId() && !comments->front().utc.empty() &&
            comments->front().text == "a word" && comments->front().tick == 42U);
}

void TestSessions::listsChooseWhatIsAsked() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        for (int i = 0; i < 6; ++i) { // 1, 3, 5 are ada's; 1 to 3 of level 1; 5 and 6 of another exercise; 2
                                      // has ended; 4 is archived
            NewSession setup = someSession();
            setup.level = i < 3 ? 1 : 2;
            setup.exercise = i < 4 ? "sphere_apex" : "palpation";
            CHIRON_TRY(SessionRepository(w.connection(), i % 2 == 0 ? *ada : Actor::simulated())
                           .beginSession(setup));
        }
        auto done = SessionRepository(w.connection(), Actor::simulated()).finishSession(2, {});
        return done ? SessionRepository(w.connection(), *ada).setArchived(4, true) : done;
    }));
    auto reader = f.database->openReader();
    const auto listed = [&](const SessionFilter& filter) {
        const auto found = SessionReader(**reader, *ada).listSessions(filter);
        std::vector<SessionId> ids;
        for (const SessionSummary& each : found.value_or(std::vector<SessionSummary>{})) {
            ids.push_back(each.id);
        }
        return ids;
    };
    using Ids = std::vector<SessionId>;
    const auto with = [&](auto change) {
        SessionFilter filter;
        change(filter);
        return listed(filter);
    };
    QCOMPARE(listed({}), (Ids{1, 2, 3, 5, 6}));
    QCOMPARE(with([](SessionFilter& s) { s.includeArchived = true; }), (Ids{1, 2, 3, 4, 5, 6}));
    QCOMPARE(with([&](SessionFilter& s) { s.person = ada->personId(); }), (Ids{1, 3, 5}));
    QCOMPARE(with([](SessionFilter& s) { s.exercise = "palpation"; }), (Ids{5, 6}));
    QCOMPARE(with([](SessionFilter& s) { s.level = 1; }), (Ids{1, 2, 3}));
    QCOMPARE(with([](SessionFilter& s) { s.state = SessionState::completed; }), (Ids{2}));
    QCOMPARE(with([](SessionFilter& s) { s.newestFirst = true; }), (Ids{6, 5, 3, 2, 1}));
    QCOMPARE(with([](SessionFilter& s) { s.limit = 1; }), (Ids{1}));
    QCOMPARE(with([](SessionFilter& s) { s.limit = 2, s.newestFirst = true; }), (Ids{6, 5}));
    QCOMPARE(with([](SessionFilter& s) { s.afterSession = 1; }), (Ids{2, 3, 5, 6}));
    QCOMPARE(with([](SessionFilter& s) { s.afterSession = 3, s.newestFirst = true; }), (Ids{2, 1}));
    QCOMPARE(with([](SessionFilter& s) { s.afterSession = 0, s.newestFirst = true, s.limit = 1; }), (Ids{6}));
}

void TestSessions::scoresComeBackBitForBit() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto id = storeSession(*f.database, Actor::simulated());
    REQUIRE(id);
    scoring::ScoreCard card;
    const double values[] = {0.1 + 0.2,  5e-324, std::numeric_limits<double>::max(),
                             -1.0 / 3.0, 2.0,    9007199254740993.0,
                             1e15 + 0.5};
    for (std::size_t i = 0; i < std::size(values); ++i) {
        card.metrics.push_back({"m" + std::to_string(i), 1, "N", values[i], "", std::nullopt});
    }
    card.metrics.push_back({"zero", 1, "N", -0.0, "", false});
    const auto set = f.database->write([&](WriteContext& w) {
        return ScoreRepository(w.connection(), Actor::simulated()).storeScores(*id, card);
    });
    REQUIRE(set);
    QCOMPARE(*set, 2);
    auto reader = f.database->openReader();
    ScoreRepository scores(**reader, Actor::anonymous());
    const auto back = scores.scores(*id);
    REQUIRE(back);
    for (std::size_t i = 0; i < std::size(values); ++i) {
        QCOMPARE(std::bit_cast<std::uint64_t>(*back->metrics[i].value),
                 std::bit_cast<std::uint64_t>(values[i]));
    }
    QCOMPARE(std::bit_cast<std::uint64_t>(*back->metrics.back().value),
             std::uint64_t{0}); // -0.0 is kept as 0.0
    QCOMPARE(back->metrics.back().passed, std::optional(false));
    QVERIFY(!back->passed);
    const auto first = scores.scores(*id, 1);
    REQUIRE(first);
    QCOMPARE(first->metrics.size(), std::size_t{2});
    QCOMPARE(first->metrics[1].reason, std::string("too short"));
    QVERIFY(!first->metrics[1].value);
    QCOMPARE(first->trials.size(), std::size_t{2});
    QCOMPARE(*first->trials[1][0].value, 1e-300);
    QCOMPARE(scores.scores(*id, 3).error().code, core::ErrorCode::notFound);
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestSessions::scoresAreNamedByTheirSeal() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto id = storeSession(*f.database, Actor::simulated());
    REQUIRE(id);
    scoring::ScoreCard card;
    card.metrics.push_back({"m", 1, "N", 0.25, "", std::nullopt});
    const auto storeAgain = [&] {
        return f.database->write([&](WriteContext& w) {
            return ScoreRepository(w.connection(), Actor::simulated()).storeScores(*id, card);
        });
    };
    REQUIRE(storeAgain());
    card.metrics[0].value = std::nextafter(0.25, 1.0);
    REQUIRE(storeAgain());
    auto reader = f.database->openReader();
    ScoreRepository scores(**reader, Actor::anonymous());
    std::vector<RowDigest> seals;
    for (const int set : {1, 2, 3}) {
        const auto seal = scores.scoreSeal(*id, set);
        REQUIRE(seal);
        const auto row =
            selectInteger(**reader, "SELECT id FROM score_set WHERE session_id = ? AND ordinal = ?",
                          {*id, std::int64_t{set}});
        QVERIFY(row && *row);
        const auto computed =
            database::scoreSeal(**reader, **row); // anew, from the digests of the stored rows
        REQUIRE(computed);
        QVERIFY(*seal == *computed);
        seals.push_back(*seal);
    }
    QVERIFY(seals[0] != seals[1] && seals[1] != seals[2] &&
            seals[0] != seals[2]); // one bit more is another seal
    const auto latest = scores.scoreSeal(*id);
    REQUIRE(latest);
    QVERIFY(*latest == seals[2]);
    QCOMPARE(scores.scoreSeal(*id, 4).error().code, core::ErrorCode::notFound);
}

// A set says how many trials it is of; a score of another one is none of it.
void TestSessions::scoresOfTrialsThatAreNotThereAreDamage() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto id = storeSession(*f.database, Actor::simulated());
    REQUIRE(id);
    const auto scoresOf = [&](int trials) {
        auto reader = f.database->openReader();
        const auto changed = f.database->write([&](WriteContext& w) {
            const auto triggers =
                selectText(w.connection(), "SELECT group_concat('DROP TRIGGER ' || name, ';') FROM "
                                           "sqlite_schema WHERE type = 'trigger' AND tbl_name = 'score_set'");
            return w.connection().execute(triggers.value().value_or("") +
                                          ";UPDATE score_set SET trials = " + std::to_string(trials));
        });
        return changed ? ScoreRepository(**reader, Actor::anonymous()).scores(*id)
                       : tl::unexpected(changed.error());
    };
    for (const int fewer : {0, 1}) {
        const auto refused = scoresOf(fewer);
        QVERIFY(!refused);
        QVERIFY2(refused.error().message.find("are damaged; run verify") != std::string::npos,
                 refused.error().message.c_str());
    }
    REQUIRE(scoresOf(2));
    QCOMPARE(scoresOf(2)->trials.size(), std::size_t{2});
}

void TestSessions::contentIsSharedAndHashed() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(storeSession(*f.database, Actor::simulated(), 1));
    const auto second = storeSession(*f.database, Actor::simulated(), 1);
    REQUIRE(second);
    auto reader = f.database->openReader();
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM content")->value(), std::int64_t{1});
    const auto record = SessionReader(**reader, Actor::anonymous()).session(*second);
    const QByteArray sha = QCryptographicHash::hash(QByteArray::fromStdString(someSession().contentJson),
                                                    QCryptographicHash::Sha256)
                               .toHex();
    QCOMPARE(record->contentSha256, sha.toStdString());
}

void TestSessions::endedSessionsAreClosed() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto id = storeSession(*f.database, Actor::simulated());
    REQUIRE(id);
    const auto job = [&](auto use) {
        return f.database->write([&](WriteContext& w) -> core::Result<void> {
            SessionRepository sessions(w.connection(), Actor::simulated());
            const auto outcome = use(sessions);
            return outcome ? core::Result<void>() : core::Result<void>(tl::unexpected(outcome.error()));
        });
    };
    QCOMPARE(job([&](SessionRepository& s) { return s.openSink(*id); }).error().code,
             core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) { return s.storeTrial(*id, {}); }).error().code,
             core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) { return s.storeEvents(*id, {}); }).error().code,
             core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) { return s.finishSession(*id, {}); }).error().code,
             core::ErrorCode::wrongUse);
    const auto running = f.database->write([](WriteContext& w) {
        return SessionRepository(w.connection(), Actor::simulated()).beginSession(someSession());
    });
    REQUIRE(running);
    const auto early = f.database->write([&](WriteContext& w) {
        return ScoreRepository(w.connection(), Actor::simulated()).storeScores(*running, someCard());
    });
    QCOMPARE(early.error().code, core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) {
                 return s.finishSession(*running, {SessionState::voided, 0, 0, 0, "{}"});
             })
                 .error()
                 .code,
             core::ErrorCode::badInput);
}

void TestSessions::voidedAndArchivedStay() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    const auto id = storeSession(*f.database, *ada);
    REQUIRE(id);
    const auto job = [&](auto use) {
        return f.database->write([&](WriteContext& w) {
            SessionRepository sessions(w.connection(), *ada);
            return use(sessions);
        });
    };
    QCOMPARE(job([&](SessionRepository& s) { return s.voidSession(*id, ""); }).error().code,
             core::ErrorCode::badInput);
    REQUIRE(job([&](SessionRepository& s) { return s.voidSession(*id, "the chair fell over"); }));
    QCOMPARE(job([&](SessionRepository& s) { return s.voidSession(*id, "twice"); }).error().code,
             core::ErrorCode::wrongUse);
    REQUIRE(job([&](SessionRepository& s) { return s.setArchived(*id, true); }));
    auto reader = f.database->openReader();
    SessionReader sessions(**reader, *ada);
    QVERIFY(sessions.listSessions()->empty());
    SessionFilter all;
    all.includeArchived = true;
    QCOMPARE(sessions.listSessions(all)->size(), std::size_t{1});
    const auto record = sessions.session(*id);
    REQUIRE(record);
    QVERIFY(record->summary.state == SessionState::voided);
    QVERIFY(record->stateBeforeVoid == SessionState::completed);
    QCOMPARE(record->voidReason, std::string("the chair fell over"));
    QCOMPARE(record->voidedBy, ada->personId());
    QVERIFY(sessions.openChunks(*id).has_value());
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestSessions::aVoidedSessionCountsAgain() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tom = f.person(*ada, "tom", {Role::trainer});
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    const auto id = storeSession(*f.database, *tim);
    REQUIRE(id);
    const auto job = [&](const Actor& actor, auto use) {
        return f.database->write([&](WriteContext& w) {
            SessionRepository sessions(w.connection(), actor);
            return use(sessions);
        });
    };
    const auto digest = [&] {
        auto reader = f.database->openReader();
        return selectText(**reader, "SELECT lower(hex(digest)) FROM session WHERE id = ?", {*id})
            ->value_or("");
    };
    const std::string counted = digest();
    QCOMPARE(job(*tom, [&](SessionRepository& s) { return s.reinstateSession(*id, "why not"); }).error().code,
             core::ErrorCode::wrongUse);
    REQUIRE(job(*tom, [&](SessionRepository& s) { return s.voidSession(*id, "the chair fell over"); }));
    QCOMPARE(job(*tim, [&](SessionRepository& s) { return s.reinstateSession(*id, "mine"); }).error().code,
             core::ErrorCode::notAllowed);
    QCOMPARE(job(*ada, [&](SessionRepository& s) { return s.reinstateSession(*id, ""); }).error().code,
             core::ErrorCode::badInput);
    REQUIRE(job(*ada, [&](SessionRepository& s) { return s.reinstateSession(*id, "it was another chair"); }));
    QCOMPARE(digest(), counted); // as if it had never been void ...
    auto reader = f.database->openReader();
    const auto record = SessionReader(**reader, *tim).session(*id);
    REQUIRE(record);
    QVERIFY(record->summary.state == SessionState::completed && !record->stateBeforeVoid &&
            record->voidedBy == 0 && record->voidReason.empty());
    QCOMPARE(record->decisions.size(), std::size_t{2}); // ... and both decisions are told, in their order
    QVERIFY(record->decisions[0].voiding && record->decisions[0].person == tom->personId());
    QCOMPARE(record->decisions[0].reason, std::string("the chair fell over"));
    QVERIFY(!record->decisions[0].utc.empty());
    QVERIFY(!record->decisions[1].voiding && record->decisions[1].person == ada->personId());
    QCOMPARE(record->decisions[1].reason, std::string("it was another chair"));
    const auto noted = [&](const char* action) {
        return selectInteger(
                   **reader,
                   "SELECT count(*) FROM audit WHERE action = ? AND target = 'session' AND target_id = ?",
                   {std::string(action), *id})
            ->value_or(0);
    };
    QVERIFY(noted("voidSession") == 1 && noted("reinstateSession") == 1);
    reader->reset();
    REQUIRE(job(*tom, [&](SessionRepository& s) {
        return s.voidSession(*id, "once more");
    })); // and it can be voided again
    for (const char* sql : {"UPDATE session_decision SET person_id = 1", "DELETE FROM session_decision"})
        QVERIFY(!f.database->write([&](WriteContext& w) { return w.connection().execute(sql); }));
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", false));
    reader = f.database->openReader();
    QCOMPARE(
        selectInteger(**reader, "SELECT count(*) FROM session_decision WHERE reason <> ''")->value_or(-1),
        std::int64_t{0});
    reader->reset();
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

// Its time is neither that of a later change of the session nor that of another voiding.
void TestSessions::aVoidingThatWasTakenBackKeepsItsTime() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    const auto first = storeSession(*f.database, *ada, 1), second = storeSession(*f.database, *ada, 1);
    REQUIRE(first);
    REQUIRE(second);
    const auto judge = [&](auto use) {
        return f.database->write([&](WriteContext& w) {
            SessionRepository sessions(w.connection(), *ada);
            return use(sessions);
        });
    };
    const auto voids = [&](SessionId id) {
        return judge([&](SessionRepository& s) { return s.voidSession(id, "the chair fell over"); });
    };
    const auto takesBack = [&](SessionId id) {
        return judge([&](SessionRepository& s) { return s.reinstateSession(id, "it did not"); });
    };
    // As if each entry had been made in another second. Returns that of the session's latest voiding.
    const auto spread = [&]() -> std::string {
        const auto done = f.database->write([](WriteContext& w) {
            return w.connection().execute("DROP TRIGGER IF EXISTS audit_fixed; UPDATE audit SET utc = "
                                          "printf('2030-01-01T00:%02d:%02d.000Z', "
                                          "sequence / 60, sequence % 60);");
        });
        auto reader = f.database->openReader();
        const auto utc = selectText(**reader,
                                    "SELECT utc FROM audit WHERE target = 'session' AND target_id = ? AND "
                                    "action = 'voidSession' ORDER BY sequence DESC LIMIT 1",
                                    {*first});
        return done && utc ? utc->value_or("") : std::string();
    };
    REQUIRE(voids(*first));
    REQUIRE(voids(*second));
    REQUIRE(judge([&](SessionRepository& s) { return s.setArchived(*first, true); }));
    const std::string once = spread();
    QVERIFY(!once.empty());
    REQUIRE(takesBack(*first));
    REQUIRE(voids(*first));
    const std::string again = spread();
    QVERIFY(again > once);
    REQUIRE(takesBack(*first));
    auto reader = f.database->openReader();
    const auto record = SessionReader(**reader, *ada).session(*first);
    REQUIRE(record);
    QCOMPARE(record->decisions.size(), std::size_t{4});
    QCOMPARE(record->decisions[0].utc, once);
    QCOMPARE(record->decisions[2].utc, again);
    QVERIFY(SessionReader(**reader, *ada).session(*second)->decisions.empty());
}

void TestSessions::attemptsAreNumbered() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    const auto stored = [&](const Actor& actor, int level, const char* hand, bool practice,
                            const char* exercise = "sphere_apex") {
        NewSession setup = someSession();
        setup.exercise = exercise;
        setup.level = level;
        setup.operatorName = hand;
        setup.familiarisation = practice;
        return storeSession(*f.database, actor, 1, 500, setup).value_or(0);
    };
    const SessionId first = stored(*tim, 1, "", false), practice = stored(*tim, 1, "", true),
                    shown = stored(*tim, 1, "expert", false);
    const SessionId second = stored(*tim, 1, "", false), higher = stored(*tim, 2, "", false),
                    others = stored(*ada, 1, "", false), elsewhere = stored(*tim, 1, "", false, "palpation"),
                    machine = stored(Actor::simulated(), 1, "", false);
    const SessionId third = stored(*tim, 1, "", false);
    REQUIRE(f.database->write([&](WriteContext& w) {
        return SessionRepository(w.connection(), *ada).voidSession(second, "the chair fell");
    }));
    auto reader = f.database->openReader();
    SessionReader sessions(**reader, *ada);
    const auto listed = sessions.listSessions();
    REQUIRE(listed);
    const std::map<SessionId, int> expected{{first, 1},     {practice, 0}, {shown, 0},
                                            {second, 2},    {higher, 1},   {others, 1},
                                            {elsewhere, 1}, {machine, 0},  {third, 3}};
    QCOMPARE(listed->size(), expected.size());
    for (const SessionSummary& session : *listed) {
        QCOMPARE(session.attempt, expected.at(session.id)); // a voided one keeps its number
        QCOMPARE(sessions.session(session.id)->summary.attempt, session.attempt);
    }
}

// On a demonstration site scripts stand for people, except those of the simulated account.
void TestSessions::aDemonstrationCountsItsOperators() {
    DatabaseFixture f;
    f.options.demonstration = true;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    const auto machine = storeSession(*f.database, Actor::simulated(), 1);
    const auto first = storeSession(*f.database, *ada, 1), second = storeSession(*f.database, *ada, 1);
    REQUIRE(machine);
    REQUIRE(first);
    REQUIRE(second);
    auto reader = f.database->openReader();
    SessionReader sessions(**reader, *ada);
    QCOMPARE(sessions.session(*machine)->summary.attempt, 0);
    QCOMPARE(sessions.session(*first)->summary.attempt, 1);
    QCOMPARE(sessions.session(*second)->summary.attempt, 2);
}

// Whatever exercise a study uses: known by the run it was recorded for, or, of earlier versions, by its
// trials.
void TestSessions::aSittingIsNoAttempt() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto ruth = f.person(*ada, "ruth", {Role::researcher});
    const auto made = makeStudies(*f.database, *ruth, "sittings");
    REQUIRE(made);
    NewSession setup = someSession();
    setup.operatorName.clear();
    const SessionId before = storeSession(*f.database, *ruth, 1, 500, setup).value_or(0);
    const SessionId byTrial = storeSession(*f.database, *ruth, 1, 500, setup).value_or(0);
    REQUIRE(f.database->write([&](WriteContext& w) {
        return StudyRepository(w.connection(), *ruth).storeStudyTrial(someTrial(made->run, 1, byTrial));
    }));
    setup.studyRun = made->run;
    const SessionId byRun = storeSession(*f.database, *ruth, 1, 500, setup).value_or(0);
    setup.studyRun = 0;
    const SessionId after = storeSession(*f.database, *ruth, 1, 500, setup).value_or(0);
    auto reader = f.database->openReader();
    const auto listed = SessionReader(**reader, *ada).listSessions();
    REQUIRE(listed);
    const std::map<SessionId, std::pair<int, bool>> expected{
        {before, {1, false}}, {byTrial, {0, true}}, {byRun, {0, true}}, {after, {2, false}}};
    QCOMPARE(listed->size(), expected.size());
    for (const SessionSummary& session : *listed) {
        QVERIFY(std::pair(session.attempt, session.ofStudy) == expected.at(session.id));
        QCOMPARE(session.toReview, session.id == after);
    }
}

void TestSessions::theLatestAttemptAwaitsReview() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tom = f.person(*ada, "tom", {Role::trainer});
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    const auto zoe = f.person(*ada, "zoe", {Role::trainee});
    NewSession setup = someSession();
    setup.operatorName.clear();
    const SessionId first = storeSession(*f.database, *tim, 1, 500, setup).value_or(0);
    const SessionId latest = storeSession(*f.database, *tim, 1, 500, setup).value_or(0);
    const SessionId own = storeSession(*f.database, *tom, 1, 500, setup).value_or(0);
    const SessionId ofZoe = storeSession(*f.database, *zoe, 1, 500, setup).value_or(0);
    NewSession other = setup;
    other.level = 3;
    const SessionId higher = storeSession(*f.database, *tim, 1, 500, other).value_or(0);
    other = setup;
    other.exercise = "palpation";
    const SessionId elsewhere = storeSession(*f.database, *tim, 1, 500, other).value_or(0);
    (void)storeSession(*f.database, Actor::simulated(), 1);
    const auto waiting = [&](const Actor& actor) {
        auto reader = f.database->openReader();
        SessionFilter filter;
        filter.toReview = true;
        std::vector<SessionId> ids;
        for (const SessionSummary& session :
             SessionReader(**reader, actor).listSessions(filter).value_or(std::vector<SessionSummary>{})) {
            ids.push_back(session.toReview ? session.id : -1);
        }
        return ids;
    };
    const auto write = [&](auto use) {
        return f.database->write([&](WriteContext& w) -> core::Result<void> {
            SessionRepository sessions(w.connection(), *tom);
            return use(sessions);
        });
    };
    using Ids = std::vector<SessionId>;
    // Of several tries the latest, of each person at each exercise and level; never one's own.
    QCOMPARE(waiting(*tom), (Ids{latest, ofZoe, higher, elsewhere}));
    QCOMPARE(waiting(*ada), (Ids{latest, own, ofZoe, higher, elsewhere}));
    REQUIRE(write([&](SessionRepository& s) { return s.voidSession(latest, "slipped"); }));
    QCOMPARE(waiting(*tom), (Ids{first, ofZoe, higher, elsewhere})); // what is void needs nobody's eye
    REQUIRE(write([&](SessionRepository& s) { return s.reinstateSession(latest, "did not slip"); }));
    QCOMPARE(waiting(*tom), (Ids{latest, ofZoe, higher, elsewhere}));
    REQUIRE(write([&](SessionRepository& s) { return s.setArchived(latest, true); }));
    QCOMPARE(waiting(*tom), (Ids{first, ofZoe, higher, elsewhere})); // nor what is put away
    REQUIRE(write([&](SessionRepository& s) { return s.setArchived(latest, false); }));
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        return drop(SessionRepository(w.connection(), *zoe).addComment(ofZoe, "my hand shook"));
    }));
    QCOMPARE(waiting(*tom), (Ids{latest, ofZoe, higher, elsewhere})); // what one says oneself is no review
    REQUIRE(write([&](SessionRepository& s) { return drop(s.addComment(latest, "steady")); }));
    // No earlier one takes its place, and the others wait as before.
    QCOMPARE(waiting(*tom), (Ids{ofZoe, higher, elsewhere}));
    QCOMPARE(waiting(*ada), (Ids{own, ofZoe, higher, elsewhere}));
}

void TestSessions::commentsAreFoundAgain() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tom = f.person(*ada, "tom", {Role::trainer});
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    const auto zoe = f.person(*ada, "zoe", {Role::trainee});
    const SessionId ofTim = storeSession(*f.database, *tim, 1).value_or(0),
                    ofZoe = storeSession(*f.database, *zoe, 1).value_or(0);
    (void)storeSession(*f.database, *tim, 1); // nobody wrote anything
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository byTom(w.connection(), *tom), byZoe(w.connection(), *zoe);
        auto good = drop(byTom.addComment(ofTim, "press less", 100));
        good = good ? drop(byTom.addComment(ofTim, "and look")) : good;
        good = good ? byTom.setArchived(ofTim, true) : good;
        return good ? drop(byZoe.addComment(ofZoe, "my hand slipped")) : good;
    }));
    const auto found = [&](const Actor& actor, const CommentedFilter& which = {}) {
        auto reader = f.database->openReader();
        std::vector<std::pair<SessionId, std::size_t>> all;
        for (const CommentedSession& each : SessionReader(**reader, actor)
                                                .commentedSessions(which)
                                                .value_or(std::vector<CommentedSession>{})) {
            all.emplace_back(each.session.id, each.comments.size());
        }
        return all;
    };
    using Found = std::vector<std::pair<SessionId, std::size_t>>;
    QVERIFY(found(*tim) == (Found{{ofTim, 2}})); // received, on an archived session, too
    QVERIFY(found(*tom) == (Found{{ofTim, 2}})); // written
    QVERIFY(found(*zoe) == (Found{{ofZoe, 1}}));
    QVERIFY(found(*ada).empty());
    const CommentedFilter toRead{.toRead = true};
    QVERIFY(found(*tim, toRead) == (Found{{ofTim, 2}}));
    QVERIFY(found(*tom, toRead).empty() && found(*zoe, toRead).empty()); // what one wrote oneself
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository byTom(w.connection(), *tom), byTim(w.connection(), *tim),
            byAda(w.connection(), *ada);
        auto good = drop(byTim.addComment(ofTim, "I will"));
        good = good ? drop(byAda.addComment(ofZoe, "rest your arm")) : good;
        return good ? drop(byTom.addComment(ofZoe, "yes")) : good;
    }));
    QVERIFY(found(*tom, toRead) ==
            (Found{{ofTim, 3}})); // answered; what ada wrote before tom was not for him
    QVERIFY(found(*ada, toRead) == (Found{{ofZoe, 3}}));
    QVERIFY(found(*zoe, toRead) == (Found{{ofZoe, 3}}));
    QVERIFY(found(*tom) == (Found{{ofZoe, 3}, {ofTim, 3}}));
    QVERIFY(found(*tom, {.most = 1}) == (Found{{ofZoe, 3}}));
    auto reader = f.database->openReader();
    QCOMPARE(SessionReader(**reader, Actor::anonymous()).commentedSessions().error().code,
             core::ErrorCode::notAllowed);
}

// What a list says of a session is its own: its latest scores, and what was written on it.
void TestSessions::aLineIsOfItsSession() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    REQUIRE(tim);
    const SessionId again = storeSession(*f.database, *tim, 1).value_or(0),
                    once = storeSession(*f.database, *tim, 1).value_or(0);
    scoring::ScoreCard worse = someCard();
    worse.passed = false;
    worse.metrics[1] = {"time", 1, "s", 2.0, "", true};
    worse.metrics.push_back({"force_max", 1, "N", 3.0, "", false});
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        auto good = drop(ScoreRepository(w.connection(), Actor::maintenance()).storeScores(again, worse));
        SessionRepository byAda(w.connection(), *ada), byTim(w.connection(), *tim);
        good = good ? drop(byAda.addComment(again, "slower")) : good;
        good = good ? drop(byTim.addComment(again, "I will be")) : good;
        return good ? drop(byTim.addComment(once, "my hand shook")) : good;
    }));
    auto reader = f.database->openReader();
    SessionReader sessions(**reader, *ada);
    const auto listed = sessions.listSessions();
    REQUIRE(listed);
    QCOMPARE(listed->size(), std::size_t{2});
    for (const SessionSummary& line : {listed->at(0), sessions.session(again)->summary}) {
        QCOMPARE(line.id, again);
        QCOMPARE(line.passed, std::optional(false));
        QVERIFY(line.gates == 3 && line.gatesMet == 2);
        QVERIFY(line.comments == 2 && line.reviewed);
    }
    for (const SessionSummary& line : {listed->at(1), sessions.session(once)->summary}) {
        QCOMPARE(line.id, once);
        QCOMPARE(line.passed, std::optional(true));
        QVERIFY(line.gates == 1 && line.gatesMet == 1);
        QVERIFY(line.comments == 1 && !line.reviewed); // by its own person
    }
}

void TestSessions::badInputNamesTheField() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto begin = [&](auto change) {
        NewSession session = someSession();
        change(session);
        return f.database->write([&](WriteContext& w) {
            return SessionRepository(w.connection(), Actor::simulated()).beginSession(session);
        });
    };
    QVERIFY(begin([](NewSession& s) { s.level = 0; }).error().message.find("level 0") != std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.exercise.clear(); }).error().message.find("exercise") !=
            std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.plannedTrials = -3; }).error().message.find("-3") !=
            std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.contentJson.clear(); }).error().message.find("content") !=
            std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.deviceJson = "\xff"; }).error().message.find("UTF-8") !=
            std::string::npos);
    QCOMPARE(begin([](NewSession& s) { s.operatorName = "'); DELETE FROM session; --"; }).value_or(0),
             SessionId{1});
}

QTEST_GUILESS_MAIN(TestSessions)
#include "test_sessions.moc"
