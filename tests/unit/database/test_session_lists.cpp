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

/// Lists of sessions: their order, and how they are found.
class TestSessionLists : public QObject {
    Q_OBJECT
private slots:
    void clockSetBackReordersNothing();
    void thousandsOfSessionsUseTheIndexes();
};

void TestSessionLists::clockSetBackReordersNothing() {
    DatabaseFixture f;
    REQUIRE(f.create());
    for (int i = 0; i < 3; ++i) {
        REQUIRE(storeSession(*f.database, Actor::simulated(), 1));
    }
    // As if the wall clock had been set back between the sessions: labels run backwards.
    REQUIRE(f.database->write([](WriteContext& w) {
        return w.connection().execute(
            "UPDATE session SET started_utc = '20' || (40 - id) || '-01-01T00:00:00.000Z'");
    }));
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

void TestSessionLists::thousandsOfSessionsUseTheIndexes() {
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
                CHIRON_TRY(SessionRepository(w.connection(), actor).beginSession(session));
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
        auto query =
            Query::run(**reader, "EXPLAIN QUERY PLAN " + SessionReader::listSql(where, true), values);
        std::string text;
        while (query && *query->next()) {
            text += query->text(3) + "\n";
        }
        return text;
    };
    const std::string person = plan(" WHERE s.person_id = ? AND s.archived = ?",
                                    {ada->personId(), std::int64_t{0}, std::int64_t{50}});
    QVERIFY2(person.find("session_by_person") != std::string::npos &&
                 person.find("TEMP B-TREE") == std::string::npos,
             person.c_str());
    const std::string exercise = plan(" WHERE s.exercise = ? AND s.level = ?",
                                      {std::string("sphere_apex"), std::int64_t{1}, std::int64_t{50}});
    QVERIFY2(exercise.find("session_by_exercise") != std::string::npos &&
                 exercise.find("TEMP B-TREE") == std::string::npos,
             exercise.c_str());
    const std::string all = plan("", {std::int64_t{50}});
    QVERIFY2(all.find("TEMP B-TREE") == std::string::npos && all.find("SCAN p") == std::string::npos &&
                 all.find("SCAN k") == std::string::npos,
             all.c_str());
    const std::string scores = plan("", {std::int64_t{50}});
    QVERIFY2(scores.find("SCAN score_set") == std::string::npos,
             scores.c_str()); // the latest result through its index
}

QTEST_GUILESS_MAIN(TestSessionLists)
#include "test_session_lists.moc"
