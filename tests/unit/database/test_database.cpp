// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/query.h"
#include "database/schema/migration_runner.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <atomic>
#include <csignal>
#include <sqlite3.h>
#include <sys/resource.h>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Opening, the lock, the writer thread, SQL storage.
class TestDatabase : public QObject {
    Q_OBJECT
private slots:
    void createsOpensAndKeepsItsIdentity();
    void createRefusesAnExistingFile();
    void secondWriterIsRefusedAndNamed();
    void lockOfADeadProcessIsNoObstacle();
    void readersWorkBesideTheWriterAndCannotWrite();
    void readersNeverCheckpoint();
    void foreignAndDamagedFilesAreErrors();
    void noWriterWithoutAWriteAheadLog();
};

void TestDatabase::createsOpensAndKeepsItsIdentity() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const std::string uuid = f.database->uuid();
    QCOMPARE(uuid.size(), std::size_t{36});
    // A new file comes of no older one, of which a copy would be kept.
    QVERIFY(QDir(f.folder.path()).entryList({QStringLiteral("*before*")}).isEmpty());
    QCOMPARE(f.database->schemaVersion(), MigrationRunner().newest());
    REQUIRE(f.reopen());
    QCOMPARE(f.database->uuid(), uuid);
    QVERIFY(!f.database->isDemonstration());
    auto reader = f.database->openReader();
    REQUIRE(reader);
    QCOMPARE(selectInteger(**reader, "PRAGMA application_id")->value(), std::int64_t{kApplicationId});
    QCOMPARE(selectText(**reader, "PRAGMA journal_mode")->value(), std::string("wal"));
    QCOMPARE(
        selectInteger(**reader,
                      "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND sql NOT LIKE '%STRICT%' "
                      "AND name NOT LIKE 'sqlite_%'")
            ->value(),
        std::int64_t{0});
    const auto pragmas = f.database->write([](WriteContext& w) -> core::Result<std::int64_t> {
        return selectInteger(w.connection(), "PRAGMA synchronous")->value() * 100 +
               selectInteger(w.connection(), "PRAGMA foreign_keys")->value() * 10 +
               selectInteger(w.connection(), "PRAGMA secure_delete")->value();
    });
    REQUIRE(pragmas);
    QCOMPARE(*pragmas, std::int64_t{211}); // synchronous FULL is 2
}

// Where files cannot be mapped (some network drives) SQLite stays with its old journal, under which readers
// would shut out the writer.
void TestDatabase::noWriterWithoutAWriteAheadLog() {
    DatabaseFixture f;
    REQUIRE(f.create());
    f.database.reset();
    {
        auto connection = Connection::create(f.path());
        REQUIRE(connection);
        QCOMPARE(selectText(**connection, "PRAGMA journal_mode=DELETE")->value(), std::string("delete"));
    }
    sqlite3_vfs* const usual = sqlite3_vfs_find(nullptr);
    sqlite3_vfs* const unmapped = sqlite3_vfs_find("unix-dotfile");
    QVERIFY(usual && unmapped);
    sqlite3_vfs_register(unmapped, 1);
    const auto writer = Connection::open(f.path(), Connection::Mode::readWrite);
    const auto reader = Connection::open(f.path(), Connection::Mode::readOnly);
    sqlite3_vfs_register(usual, 1);
    QVERIFY(!writer);
    QCOMPARE(writer.error().code, core::ErrorCode::storage);
    QVERIFY2(writer.error().message.find(f.path() + ": the file system does not allow write-ahead logging") ==
                 0,
             writer.error().message.c_str());
    REQUIRE(reader); // reading needs none
    REQUIRE(f.reopen());
}

void TestDatabase::createRefusesAnExistingFile() {
    DatabaseFixture f;
    QFile file(QString::fromStdString(f.path()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("a letter to grandmother");
    file.close();
    const auto made = Database::create(f.path(), f.options);
    QVERIFY(!made);
    QCOMPARE(made.error().code, core::ErrorCode::badInput);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("a letter to grandmother"));
}

void TestDatabase::secondWriterIsRefusedAndNamed() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto second = Database::openForWriting(f.path(), f.options);
    QVERIFY(!second);
    QCOMPARE(second.error().code, core::ErrorCode::locked);
    QVERIFY(second.error().message.find(std::to_string(QCoreApplication::applicationPid())) !=
            std::string::npos);
    QVERIFY(second.error().message.find("test_database") != std::string::npos);
    f.database.reset();
    REQUIRE(Database::openForWriting(f.path(), f.options));
}

void TestDatabase::lockOfADeadProcessIsNoObstacle() {
    DatabaseFixture f;
    REQUIRE(f.create());
    f.database.reset();
    QProcess sleeper;
    sleeper.start(QStringLiteral("sleep"), {QStringLiteral("60")});
    QVERIFY(sleeper.waitForStarted());
    const qint64 pid = sleeper.processId();
    QFile lock(QString::fromStdString(f.path() + ".lock"));
    QVERIFY(lock.open(QIODevice::WriteOnly));
    lock.write(QByteArray::number(pid) + "\nsleep\n" + QSysInfo::machineHostName().toUtf8() + "\n");
    lock.close();
    QCOMPARE(Database::openForWriting(f.path(), f.options).error().code, core::ErrorCode::locked);
    sleeper.kill();
    QVERIFY(sleeper.waitForFinished());
    REQUIRE(Database::openForWriting(f.path(), f.options));
    QVERIFY(lock.open(QIODevice::WriteOnly | QIODevice::Truncate)); // killed before it could sign the lock
    lock.close();
    REQUIRE(Database::openForWriting(f.path(), f.options));
}

void TestDatabase::readersWorkBesideTheWriterAndCannotWrite() {
    DatabaseFixture f;
    REQUIRE(f.create());
    auto beside = Database::openReadOnly(f.path(), f.options);
    REQUIRE(beside);
    REQUIRE(storeSession(*f.database, Actor::simulated()));
    auto reader = (*beside)->openReader();
    REQUIRE(reader);
    const auto listed = SessionReader(**reader, Actor::anonymous()).listSessions();
    REQUIRE(listed);
    QCOMPARE(listed->size(), std::size_t{1});
    const auto job = (*beside)->write([](WriteContext&) -> core::Result<void> { return {}; });
    QCOMPARE(job.error().code, core::ErrorCode::wrongUse);
    QVERIFY(!(*reader)->execute("DELETE FROM meta"));
    const auto began = SessionRepository(**reader, Actor::simulated()).beginSession(someSession());
    QCOMPARE(began.error().code, core::ErrorCode::wrongUse);
}

void TestDatabase::readersNeverCheckpoint() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(storeSession(*f.database, Actor::simulated()));
    QFile main(QString::fromStdString(f.path()));
    const auto bytes = [&] {
        (void)main.open(QIODevice::ReadOnly);
        const QByteArray all = main.readAll();
        main.close();
        return all;
    };
    const QByteArray before = bytes();
    QVERIFY(QFileInfo(QString::fromStdString(f.path() + "-wal")).size() > 0);
    for (int i = 0; i < 3; ++i) {
        auto beside = Database::openReadOnly(f.path(), f.options);
        REQUIRE(beside);
        auto reader = (*beside)->openReader();
        REQUIRE(SessionReader(**reader, Actor::anonymous()).listSessions());
    }
    QVERIFY(bytes() == before);
}

void TestDatabase::foreignAndDamagedFilesAreErrors() {
    DatabaseFixture f;
    QCOMPARE(Database::openReadOnly(f.path("none.db"), f.options).error().code, core::ErrorCode::notFound);
    const std::string foreign = f.path("foreign.db");
    {
        auto connection = Connection::create(foreign);
        REQUIRE(connection);
        REQUIRE(
            (*connection)->execute("CREATE TABLE a (b); PRAGMA application_id=1; PRAGMA user_version=1;"));
    }
    QCOMPARE(Database::openForWriting(foreign, f.options).error().code, core::ErrorCode::storage);
    QVERIFY(Database::openReadOnly(foreign, f.options).error().message.find("another program") !=
            std::string::npos);
    QFile noise(QString::fromStdString(f.path("noise.db")));
    QVERIFY(noise.open(QIODevice::WriteOnly));
    noise.write(QByteArray(5000, 'x'));
    noise.close();
    QCOMPARE(Database::openForWriting(f.path("noise.db"), f.options).error().code, core::ErrorCode::storage);
    REQUIRE(f.create());
    f.database.reset();
    QFile good(QString::fromStdString(f.path()));
    QVERIFY(good.open(QIODevice::ReadWrite));
    good.seek(100); // the schema's first page: its b-tree header
    good.write(QByteArray(200, '\xff'));
    good.close();
    QCOMPARE(Database::openForWriting(f.path(), f.options).error().code, core::ErrorCode::storage);
}

QTEST_GUILESS_MAIN(TestDatabase)
#include "test_database.moc"
