// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/integrity/verifier.h"
#include "database/query.h"

#include <QCryptographicHash>
#include <bit>
#include <limits>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Sessions, recordings and scores come back as they were stored.
class TestSessions : public QObject {
    Q_OBJECT
private slots:
    void everythingComesBack();
    void scoresComeBackBitForBit();
    void contentIsSharedAndHashed();
    void chunksFollowOnWithoutGap();
    void batchIsAllOrNothing();
    void secondThatGoesOnIsRenewed();
    void endedSessionsAreClosed();
    void unfinishedSessionsAreRecovered();
    void clockSetBackReordersNothing();
    void voidedAndArchivedStay();
    void badInputNamesTheField();
    void thousandsOfSessionsUseTheIndexes();
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
        QVERIFY(chunk->payload == stored.payload && chunk->payloadDigest == stored.payloadDigest && chunk->forceHash == stored.forceHash);
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

void TestSessions::scoresComeBackBitForBit() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto id = storeSession(*f.database, Actor::simulated());
    REQUIRE(id);
    scoring::ScoreCard card;
    const double values[] = {0.1 + 0.2, 5e-324, std::numeric_limits<double>::max(), -1.0 / 3.0, 2.0, 9007199254740993.0, 1e15 + 0.5};
    for (std::size_t i = 0; i < std::size(values); ++i) {
        card.metrics.push_back({"m" + std::to_string(i), 1, "N", values[i], "", std::nullopt});
    }
    card.metrics.push_back({"zero", 1, "N", -0.0, "", false});
    const auto set = f.database->write([&](WriteContext& w) { return ScoreRepository(w.connection(), Actor::simulated()).storeScores(*id, card); });
    REQUIRE(set);
    QCOMPARE(*set, 2);
    auto reader = f.database->openReader();
    ScoreRepository scores(**reader, Actor::anonymous());
    const auto back = scores.scores(*id);
    REQUIRE(back);
    for (std::size_t i = 0; i < std::size(values); ++i) {
        QCOMPARE(std::bit_cast<std::uint64_t>(*back->metrics[i].value), std::bit_cast<std::uint64_t>(values[i]));
    }
    QCOMPARE(std::bit_cast<std::uint64_t>(*back->metrics.back().value), std::uint64_t{0}); // -0.0 is kept as 0.0
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

void TestSessions::contentIsSharedAndHashed() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(storeSession(*f.database, Actor::simulated(), 1));
    const auto second = storeSession(*f.database, Actor::simulated(), 1);
    REQUIRE(second);
    auto reader = f.database->openReader();
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM content")->value(), std::int64_t{1});
    const auto record = SessionReader(**reader, Actor::anonymous()).session(*second);
    const QByteArray sha = QCryptographicHash::hash(QByteArray::fromStdString(someSession().contentJson), QCryptographicHash::Sha256).toHex();
    QCOMPARE(record->contentSha256, sha.toStdString());
}

namespace {
// Runs on the writer with a running session and its sink.
core::Result<void> withSink(Database& database, const std::function<core::Result<void>(recording::TrialSink&, SessionId)>& use) {
    return database.write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), Actor::simulated());
        const auto id = sessions.beginSession(someSession());
        auto sink = id ? sessions.openSink(*id) : core::Result<std::unique_ptr<recording::TrialSink>>(tl::unexpected(id.error()));
        return sink ? use(**sink, *id) : core::Result<void>(tl::unexpected(sink.error()));
    });
}
} // namespace

void TestSessions::chunksFollowOnWithoutGap() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(withSink(*f.database, [](recording::TrialSink& sink, SessionId) -> core::Result<void> {
        const recording::Chunk first = someChunk(0);
        const recording::Chunk third = someChunk(2);
        auto done = sink.write({&first, 1}, {});
        if (!done) {
            return done;
        }
        const auto gap = sink.write({&third, 1}, {});
        const auto again = sink.write({&first, 1}, {});
        return !gap && gap.error().code == core::ErrorCode::wrongUse && !again ? core::Result<void>() : core::fail(core::ErrorCode::doesNotHold, "gap was accepted");
    }));
}

void TestSessions::batchIsAllOrNothing() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(withSink(*f.database, [](recording::TrialSink& sink, SessionId) -> core::Result<void> {
        const recording::Chunk good[] = {someChunk(0), someChunk(1)};
        recording::SecondSummary bad{0, 0, 250, 0.1, std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0};
        const auto refused = sink.write(good, {&bad, 1});
        if (refused) {
            return core::fail(core::ErrorCode::doesNotHold, "a NaN was stored");
        }
        bad.maximumForce_N = 1.0;
        return sink.write(good, {&bad, 1}); // from the same place again
    }));
    auto reader = f.database->openReader();
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM chunk")->value(), std::int64_t{2});
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM second_summary")->value(), std::int64_t{1});
}

void TestSessions::secondThatGoesOnIsRenewed() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(withSink(*f.database, [](recording::TrialSink& sink, SessionId) -> core::Result<void> {
        recording::SecondSummary second{0, 1, 250, 0.1, 1.0, 0.5, 0.1, 0.0, 1};
        auto done = sink.write({}, {&second, 1});
        second.frames = 1000;
        second.maximumForce_N = 2.0;
        return done ? sink.write({}, {&second, 1}) : done;
    }));
    auto reader = f.database->openReader();
    const auto seconds = SessionReader(**reader, Actor::anonymous()).secondSummaries(1);
    REQUIRE(seconds);
    QCOMPARE(seconds->size(), std::size_t{1});
    QCOMPARE(seconds->front().frames, 1000u);
    QCOMPARE(seconds->front().maximumForce_N, 2.0);
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
    QCOMPARE(job([&](SessionRepository& s) { return s.openSink(*id); }).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) { return s.storeTrial(*id, {}); }).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) { return s.storeEvents(*id, {}); }).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) { return s.finishSession(*id, {}); }).error().code, core::ErrorCode::wrongUse);
    const auto running = f.database->write([](WriteContext& w) { return SessionRepository(w.connection(), Actor::simulated()).beginSession(someSession()); });
    REQUIRE(running);
    const auto early = f.database->write([&](WriteContext& w) { return ScoreRepository(w.connection(), Actor::simulated()).storeScores(*running, someCard()); });
    QCOMPARE(early.error().code, core::ErrorCode::wrongUse);
    QCOMPARE(job([&](SessionRepository& s) { return s.finishSession(*running, {SessionState::voided, 0, 0, 0, "{}"}); }).error().code, core::ErrorCode::badInput);
}

void TestSessions::unfinishedSessionsAreRecovered() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(withSink(*f.database, [](recording::TrialSink& sink, SessionId) {
        const recording::Chunk chunk = someChunk(0);
        return sink.write({&chunk, 1}, {});
    }));
    REQUIRE(f.reopen()); // the program died and starts again
    auto reader = f.database->openReader();
    const auto open = SessionReader(**reader, Actor::maintenance()).listUnfinished();
    REQUIRE(open);
    QCOMPARE(open->size(), std::size_t{1});
    QCOMPARE(open->front().setup.ringFile, std::string("/run/ring"));
    const SessionId id = open->front().summary.id;
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), Actor::maintenance());
        auto sink = sessions.openSink(id); // goes on where the dead program stopped
        if (!sink) {
            return tl::unexpected(sink.error());
        }
        const recording::Chunk chunk = someChunk(1);
        auto done = (*sink)->write({&chunk, 1}, {});
        return done ? sessions.finishSession(id, {SessionState::interrupted, 500, 500, 0, "{}"}) : done;
    }));
    QVERIFY(SessionReader(**reader, Actor::maintenance()).listUnfinished()->empty());
    const auto record = SessionReader(**reader, Actor::anonymous()).session(id);
    QVERIFY(record->summary.state == SessionState::interrupted);
    QCOMPARE(record->summary.chunks, std::uint64_t{2});
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestSessions::clockSetBackReordersNothing() {
    DatabaseFixture f;
    REQUIRE(f.create());
    for (int i = 0; i < 3; ++i) {
        REQUIRE(storeSession(*f.database, Actor::simulated(), 1));
    }
    // As if the wall clock had been set back between the sessions: labels run backwards.
    REQUIRE(f.database->write([](WriteContext& w) { return w.connection().execute("UPDATE session SET started_utc = '20' || (40 - id) || '-01-01T00:00:00.000Z'"); }));
    auto reader = f.database->openReader();
    const auto listed = SessionReader(**reader, Actor::anonymous()).listSessions();
    REQUIRE(listed);
    QVERIFY((*listed)[0].startedUtc > (*listed)[2].startedUtc);
    QVERIFY((*listed)[0].id == 1 && (*listed)[1].id == 2 && (*listed)[2].id == 3);
    SessionFilter newest;
    newest.newestFirst = true;
    newest.limit = 2;
    const auto last = SessionReader(**reader, Actor::anonymous()).listSessions(newest);
    QVERIFY(last->size() == 2 && last->front().id == 3);
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
    QCOMPARE(job([&](SessionRepository& s) { return s.voidSession(*id, ""); }).error().code, core::ErrorCode::badInput);
    REQUIRE(job([&](SessionRepository& s) { return s.voidSession(*id, "the chair fell over"); }));
    QCOMPARE(job([&](SessionRepository& s) { return s.voidSession(*id, "twice"); }).error().code, core::ErrorCode::wrongUse);
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

void TestSessions::badInputNamesTheField() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto begin = [&](auto change) {
        NewSession session = someSession();
        change(session);
        return f.database->write([&](WriteContext& w) { return SessionRepository(w.connection(), Actor::simulated()).beginSession(session); });
    };
    QVERIFY(begin([](NewSession& s) { s.level = 0; }).error().message.find("level 0") != std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.exercise.clear(); }).error().message.find("exercise") != std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.plannedTrials = -3; }).error().message.find("-3") != std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.contentJson.clear(); }).error().message.find("content") != std::string::npos);
    QVERIFY(begin([](NewSession& s) { s.deviceJson = "\xff"; }).error().message.find("UTF-8") != std::string::npos);
    QCOMPARE(begin([](NewSession& s) { s.operatorName = "'); DELETE FROM session; --"; }).value_or(0), SessionId{1});
}

void TestSessions::thousandsOfSessionsUseTheIndexes() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    for (int batch = 0; batch < 10; ++batch) {
        REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
            for (int i = 0; i < 1000; ++i) {
                NewSession session = someSession();
                session.level = 1 + i % 4;
                const Actor actor = i % 10 == 0 ? *ada : Actor::simulated();
                if (const auto id = SessionRepository(w.connection(), actor).beginSession(session); !id) {
                    return tl::unexpected(id.error());
                }
            }
            return {};
        }));
    }
    auto reader = f.database->openReader();
    SessionReader sessions(**reader, *ada);
    QCOMPARE(sessions.listSessions()->size(), std::size_t{10000});
    SessionFilter own;
    own.person = ada->personId();
    own.level = 1;
    QCOMPARE(sessions.listSessions(own)->size(), std::size_t{500});
    const auto plan = [&](const std::string& where, const std::vector<Value>& values) {
        auto query = Query::run(**reader, "EXPLAIN QUERY PLAN " + SessionReader::listSql(where, true), values);
        std::string text;
        while (query && *query->next()) {
            text += query->text(3) + "\n";
        }
        return text;
    };
    const std::string person = plan(" WHERE s.person_id = ? AND s.archived = ?", {ada->personId(), std::int64_t{0}, std::int64_t{50}});
    QVERIFY2(person.find("session_by_person") != std::string::npos && person.find("TEMP B-TREE") == std::string::npos, person.c_str());
    const std::string exercise = plan(" WHERE s.exercise = ? AND s.level = ?", {std::string("sphere_apex"), std::int64_t{1}, std::int64_t{50}});
    QVERIFY2(exercise.find("session_by_exercise") != std::string::npos && exercise.find("TEMP B-TREE") == std::string::npos, exercise.c_str());
    const std::string all = plan("", {std::int64_t{50}});
    QVERIFY2(all.find("TEMP B-TREE") == std::string::npos && all.find("SCAN p") == std::string::npos && all.find("SCAN k") == std::string::npos, all.c_str());
    const std::string scores = plan("", {std::int64_t{50}});
    QVERIFY2(scores.find("SCAN score_set") == std::string::npos, scores.c_str()); // the latest result through its index
}

QTEST_GUILESS_MAIN(TestSessions)
#include "test_sessions.moc"
