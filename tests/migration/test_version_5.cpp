// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_site.h"

#include "database/integrity/verifier.h"

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// What the fifth version of the schema brought: the run of a study that a session was recorded for.
class TestVersion5 : public QObject {
    Q_OBJECT
private slots:
    void version4VerifiesAndOpens();
};

void TestVersion5::version4VerifiesAndOpens() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    auto steps = builtInMigrations();
    steps.resize(4);
    auto connection = Connection::open(f.path(), Connection::Mode::readWrite);
    REQUIRE(MigrationRunner(steps).migrate(**connection));
    connection->reset();
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{4});
    QVERIFY(verifyDatabase(f.path(), f.options).ok()); // as it is, without the table of sittings
    REQUIRE(f.reopen());
    QCOMPARE(f.database->schemaVersion(), MigrationRunner().newest());
    QCOMPARE(numberIn(f.path(), "SELECT count(*) FROM study_sitting"), std::int64_t{0});
    QCOMPARE(numberIn(f.path(), "SELECT count(*) FROM recorded_sitting"),
             numberIn(f.path(), "SELECT count(DISTINCT session_id) FROM study_trial"));
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

QTEST_GUILESS_MAIN(TestVersion5)
#include "test_version_5.moc"
