// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_site.h"

#include "database/integrity/verifier.h"

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// What the seventh version of the schema brought: a voided session may be counted again.
class TestVersion7 : public QObject {
    Q_OBJECT
private slots:
    void version6VerifiesAndOpens();
    void aVoidingOfEarlierVersionsIsTakenBack();
};

void TestVersion7::version6VerifiesAndOpens() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    auto steps = builtInMigrations();
    steps.resize(6);
    auto connection = Connection::open(f.path(), Connection::Mode::readWrite);
    REQUIRE(MigrationRunner(steps).migrate(**connection));
    connection->reset();
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{6});
    QVERIFY(verifyDatabase(f.path(), f.options).ok()); // as it is, without the table of decisions
    REQUIRE(f.reopen());
    QCOMPARE(f.database->schemaVersion(), MigrationRunner().newest());
    f.database.reset();
    QCOMPARE(numberIn(f.path(), "SELECT count(*) FROM session_decision"), std::int64_t{0});
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

// Session 2 of the stored site was voided by version 1: who, why and when are kept as the file and its audit
// have them.
void TestVersion7::aVoidingOfEarlierVersionsIsTakenBack() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    REQUIRE(f.reopen());
    const auto ada = AccountService(*f.database).login("ada", kPassword);
    REQUIRE(ada);
    auto reader = f.database->openReader();
    const auto before = SessionReader(**reader, *ada).session(2);
    REQUIRE(before);
    QVERIFY(before->summary.state == SessionState::voided && before->decisions.empty());
    const auto when =
        selectText(**reader, "SELECT utc FROM audit WHERE action = 'voidSession' AND target_id = 2");
    reader->reset();
    REQUIRE(f.database->write([&](WriteContext& w) {
        return SessionRepository(w.connection(), *ada).reinstateSession(2, "it was the other one");
    }));
    reader = f.database->openReader();
    const auto after = SessionReader(**reader, *ada).session(2);
    REQUIRE(after);
    QVERIFY(after->summary.state == *before->stateBeforeVoid);
    QCOMPARE(after->decisions.size(), std::size_t{2});
    const SessionDecision& voiding = after->decisions.front();
    QVERIFY(voiding.voiding && voiding.person == before->voidedBy && voiding.reason == before->voidReason);
    QCOMPARE(voiding.utc, when->value_or("?"));
    reader->reset();
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

QTEST_GUILESS_MAIN(TestVersion7)
#include "test_version_7.moc"
