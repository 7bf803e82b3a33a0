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
    void endedSessionsAreClosed();
    void voidedAndArchivedStay();
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
