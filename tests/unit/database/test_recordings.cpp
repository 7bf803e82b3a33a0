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

namespace {
// Runs on the writer with a running session and its sink.
core::Result<void> withSink(Database& database,
                            const std::function<core::Result<void>(recording::TrialSink&, SessionId)>& use) {
    return database.write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), Actor::simulated());
        const auto id = sessions.beginSession(someSession());
        auto sink = id ? sessions.openSink(*id)
                       : core::Result<std::unique_ptr<recording::TrialSink>>(tl::unexpected(id.error()));
        return sink ? use(**sink, *id) : core::Result<void>(tl::unexpected(sink.error()));
    });
}
} // namespace

/// The sink: chunks and summaries, and what a crash leaves of them.
class TestRecordings : public QObject {
    Q_OBJECT
private slots:
    void chunksFollowOnWithoutGap();
    void batchIsAllOrNothing();
    void secondThatGoesOnIsRenewed();
    void unfinishedSessionsAreRecovered();
};

void TestRecordings::chunksFollowOnWithoutGap() {
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
        return !gap && gap.error().code == core::ErrorCode::wrongUse && !again
                   ? core::Result<void>()
                   : core::fail(core::ErrorCode::doesNotHold, "gap was accepted");
    }));
}

void TestRecordings::batchIsAllOrNothing() {
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

void TestRecordings::secondThatGoesOnIsRenewed() {
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

void TestRecordings::unfinishedSessionsAreRecovered() {
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
        CHIRON_TRY(sink);
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

QTEST_GUILESS_MAIN(TestRecordings)
#include "test_recordings.moc"
