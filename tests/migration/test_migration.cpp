// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_site.h"

#include "database/integrity/verifier.h"
#include "database/query.h"
#include "database/schema/migration_runner.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QThread>
#include <csignal>
#include <cstdio>
#include <sys/resource.h>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

// What the first step after version 1 may do: a table large enough to take a while.
std::vector<Migration> withSecond(const std::string& more = {}) {
    std::vector<Migration> migrations = builtInMigrations();
    migrations.resize(1);
    migrations.push_back({2, "0002_test.sql",
                          "CREATE TABLE second_version (id INTEGER PRIMARY KEY, text TEXT NOT NULL) STRICT;"
                          "INSERT INTO second_version (text) WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL "
                          "SELECT i + 1 FROM n WHERE i < 20000) "
                          "SELECT hex(randomblob(100)) FROM n;" +
                              more});
    return migrations;
}

core::Result<std::string> migrate(const std::string& file, const MigrationRunner& runner) {
    auto connection = Connection::open(file, Connection::Mode::readWrite);
    return connection ? runner.migrate(**connection) : tl::unexpected(connection.error());
}

} // namespace

/// Old files open, newer ones are left alone, a step that does not finish has not happened.
class TestMigration : public QObject {
    Q_OBJECT
private slots:
    void stepsFollowOn();
    void storedVersion1Opens();
    void newerIsRefusedUnchanged();
    void newerInTheLogIsRefusedUnchanged();
    void stepBacksUpFirst();
    void failingStepHasNotHappened();
    void killInTheMiddleHasNotHappened_data();
    void killInTheMiddleHasNotHappened();
    void killWhileCreatingLeavesAllOrNothing();
    void fullDiskHasNotHappened();
};

void TestMigration::stepsFollowOn() {
    const auto migrations = builtInMigrations();
    QVERIFY(!migrations.empty());
    int expected = 0;
    for (const Migration& migration : migrations) {
        QVERIFY(migration.version == ++expected && !migration.sql.empty());
    }
}

void TestMigration::storedVersion1Opens() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    const VerifyReport before = verifyDatabase(f.path(), f.options);
    QVERIFY2(before.ok(), before.ok() ? ""
                                      : (before.findings[0].kind + " " + before.findings[0].table + " " +
                                         before.findings[0].detail)
                                            .c_str());
    REQUIRE(f.reopen());
    QCOMPARE(f.database->uuid(), std::string("38ca1321-52ad-46e0-998e-2c5f7a51be49"));
    const auto ada = AccountService(*f.database).login("ada", kPassword);
    REQUIRE(ada);
    auto reader = f.database->openReader();
    SessionReader sessions(**reader, *ada);
    const auto record = sessions.session(1);
    REQUIRE(record);
    QCOMPARE(record->summary.personName, std::string("tim"));
    QCOMPARE(record->setup.seed, std::uint64_t{0xfedcba9876543210});
    const auto scores = ScoreRepository(**reader, *ada).scores(1);
    REQUIRE(scores);
    QCOMPARE(*scores->metrics[0].value, 0.1 + 0.2);
    auto chunks = sessions.openChunks(1);
    REQUIRE(chunks);
    QVERIFY((*chunks)->chunk(1)->payload == someChunk(1).payload);
    QVERIFY(sessions.session(2)->summary.state == SessionState::voided);
    QCOMPARE(sessions.comments(1)->front().text, std::string("steady"));
    REQUIRE(storeSession(*f.database, *ada));
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestMigration::newerIsRefusedUnchanged() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    {
        auto connection = Connection::create(f.path());
        REQUIRE(
            (*connection)->execute("PRAGMA user_version=" + std::to_string(MigrationRunner().newest() + 1)));
    }
    const QByteArray before = contentOf(f.path());
    const QStringList files = QDir(f.folder.path()).entryList();
    for (const auto& opened :
         {Database::openForWriting(f.path(), f.options), Database::openReadOnly(f.path(), f.options)}) {
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, core::ErrorCode::storage);
        QVERIFY(opened.error().message.find("newer") != std::string::npos);
    }
    QVERIFY(contentOf(f.path()) == before);
    QCOMPARE(QDir(f.folder.path()).entryList(), files); // nothing beside it either
}

void TestMigration::newerInTheLogIsRefusedUnchanged() {
    // A newer program was killed: its version stands in the write-ahead log only.
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path("live.db")));
    auto live = Connection::open(f.path("live.db"), Connection::Mode::readWrite);
    REQUIRE(live);
    REQUIRE((*live)->execute("PRAGMA user_version=99"));
    copyTo(f.path(), contentOf(f.path("live.db")));
    copyTo(f.path() + "-wal", contentOf(f.path("live.db") + "-wal"));
    const QByteArray before = contentOf(f.path());
    const QByteArray log = contentOf(f.path() + "-wal");
    QVERIFY(!log.isEmpty());
    QVERIFY(Database::openForWriting(f.path(), f.options).error().message.find("newer") != std::string::npos);
    QVERIFY(Database::openReadOnly(f.path(), f.options).error().message.find("newer") != std::string::npos);
    QVERIFY(contentOf(f.path()) == before);
    QVERIFY(contentOf(f.path() + "-wal") == log);
}

void TestMigration::stepBacksUpFirst() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    const auto copy = migrate(f.path(), MigrationRunner(withSecond()));
    REQUIRE(copy);
    QCOMPARE(*copy, f.path() + ".before-v2");
    QCOMPARE(numberIn(*copy, "PRAGMA user_version"), std::int64_t{1});
    QCOMPARE(numberIn(*copy, "SELECT count(*) FROM session"), std::int64_t{2});
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{2});
    QCOMPARE(numberIn(f.path(), "SELECT count(*) FROM second_version"), std::int64_t{20000});
    QCOMPARE(numberIn(f.path(), "SELECT count(*) FROM session"), std::int64_t{2});
    const auto again = migrate(f.path(), MigrationRunner(withSecond())); // nothing left to do, no second copy
    REQUIRE(again);
    QVERIFY(again->empty());
    // The program that knows version 1 only now leaves it alone.
    std::vector<Migration> first = builtInMigrations();
    first.resize(1);
    QVERIFY(MigrationRunner(first).inspect(f.path()).error().message.find("newer") != std::string::npos);
}

void TestMigration::failingStepHasNotHappened() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    const auto failed =
        migrate(f.path(), MigrationRunner(withSecond("INSERT INTO no_such_table VALUES (1);")));
    QVERIFY(!failed);
    QCOMPARE(failed.error().code, core::ErrorCode::storage);
    QVERIFY(failed.error().message.find("0002_test.sql") != std::string::npos);
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{1});
    QCOMPARE(numberIn(f.path(), "SELECT count(*) FROM sqlite_schema WHERE name = 'second_version'"),
             std::int64_t{0});
    QVERIFY(QFile::exists(QString::fromStdString(f.path() + ".before-v2")));
    const auto second = migrate(f.path(), MigrationRunner(withSecond()));
    REQUIRE(second);
    QCOMPARE(*second, f.path() + ".before-v2-2"); // the first copy is not overwritten
    QVERIFY(verifyDatabase(f.path() + ".before-v2", f.options).findings.size() <=
            1); // but for its missing key: sound
}

void TestMigration::killInTheMiddleHasNotHappened_data() {
    QTest::addColumn<int>("delay_ms"); // -1: just before the commit
    QTest::newRow("before the commit") << -1;
    for (const int delay : {0, 3, 10, 20, 40, 80}) {
        QTest::addRow("%d ms", delay) << delay;
    }
}

void TestMigration::killInTheMiddleHasNotHappened() {
    QFETCH(int, delay_ms);
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    QProcess helper;
    helper.start(QCoreApplication::applicationFilePath(),
                 {delay_ms < 0 ? "--migrate-and-die" : "--migrate", QString::fromStdString(f.path())});
    QVERIFY(helper.waitForReadyRead(20000));
    if (delay_ms >= 0) {
        QThread::msleep(static_cast<unsigned long>(delay_ms));
        helper.kill();
    }
    QVERIFY(helper.waitForFinished());
    const std::int64_t version = numberIn(f.path(), "PRAGMA user_version");
    const std::int64_t table =
        numberIn(f.path(), "SELECT count(*) FROM sqlite_schema WHERE name = 'second_version'");
    // A kill that comes by the clock may come after the end, on a busy machine however soon it was meant.
    QVERIFY((version == 1 || (version == 2 && delay_ms >= 0)) && table == version - 1);
    if (version == 2) {
        QCOMPARE(numberIn(f.path(), "SELECT count(*) FROM second_version"), std::int64_t{20000});
        return;
    }
    REQUIRE(f.reopen()); // the old file is as usable as before
    REQUIRE(AccountService(*f.database).login("ada", kPassword));
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestMigration::killWhileCreatingLeavesAllOrNothing() {
    for (const int delay_ms : {0, 2, 5, 10, 20, 30, 50, 80}) {
        DatabaseFixture f;
        QProcess helper;
        helper.start(QCoreApplication::applicationFilePath(), {"--create", QString::fromStdString(f.path())});
        QVERIFY(helper.waitForReadyRead(20000));
        QThread::msleep(static_cast<unsigned long>(delay_ms));
        helper.kill();
        QVERIFY(helper.waitForFinished());
        if (QFile::exists(QString::fromStdString(f.path()))) {
            REQUIRE(f.reopen());
            f.database.reset();
            QVERIFY(verifyDatabase(f.path(), f.options).ok());
        } else {
            REQUIRE(f.create()); // whatever is left of the first attempt
        }
    }
}

void TestMigration::fullDiskHasNotHappened() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &old), 0);
    rlimit small = old;
    small.rlim_cur = 600'000; // room for the copy, not for the step
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto failed = migrate(f.path(), MigrationRunner(withSecond()));
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &old), 0);
    QVERIFY(!failed);
    QCOMPARE(failed.error().code, core::ErrorCode::storage);
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{1});
    REQUIRE(migrate(f.path(), MigrationRunner(withSecond())));
}

namespace {

int helperMain(const std::string& mode, const std::string& file) {
    DatabaseFixture f;
    f.folder.remove(); // its options are what is wanted; a killed process leaves its folder
    std::puts("ready");
    std::fflush(stdout);
    if (mode == "--create") {
        return Database::create(file, f.options) ? 0 : 1;
    }
    MigrationRunner runner(withSecond());
    if (mode == "--migrate-and-die") {
        runner.beforeCommit = [] { std::raise(SIGKILL); };
    }
    return migrate(file, runner) ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc == 3 && QByteArray(argv[1]).startsWith("--")) {
        return helperMain(argv[1], argv[2]);
    }
    TestMigration test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_migration.moc"
