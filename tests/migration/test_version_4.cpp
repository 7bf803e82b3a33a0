// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_site.h"

#include "database/integrity/verifier.h"

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// What the fourth version of the schema brought: earlier names of people.
class TestVersion4 : public QObject {
    Q_OBJECT
private slots:
    void version3VerifiesAndOpens();
};

void TestVersion4::version3VerifiesAndOpens() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    auto steps = builtInMigrations();
    steps.resize(3);
    auto connection = Connection::open(f.path(), Connection::Mode::readWrite);
    REQUIRE(MigrationRunner(steps).migrate(**connection));
    connection->reset();
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{3});
    QVERIFY(verifyDatabase(f.path(), f.options).ok()); // as it is, without the table of names
    REQUIRE(f.reopen());
    QCOMPARE(f.database->schemaVersion(), MigrationRunner().newest());
    AccountService accounts(*f.database);
    const auto ada = accounts.login("ada", kPassword);
    REQUIRE(ada);
    QVERIFY(accounts.earlierNames(*ada, ada->personId())->empty());
    REQUIRE(accounts.changeNames(*ada, ada->personId(), "augusta", "Augusta Ada King"));
    QCOMPARE(accounts.earlierNames(*ada, ada->personId())->front().name, std::string("ada"));
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

QTEST_GUILESS_MAIN(TestVersion4)
#include "test_version_4.moc"
