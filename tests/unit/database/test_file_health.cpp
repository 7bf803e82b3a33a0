// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/integrity/file_health.h"
#include "database/query.h"
#include "support/damaged_file.h"

#include <QDir>
#include <QFile>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

/// A closed site with a session in it.
core::Result<void> makeClosed(DatabaseFixture& f) {
    auto done = f.create();
    const auto ada = done ? f.administrator() : core::Result<Actor>(tl::unexpected(done.error()));
    const auto session =
        ada ? storeSession(*f.database, *ada, 40) : core::Result<SessionId>(tl::unexpected(ada.error()));
    f.database.reset();
    return session ? core::Result<void>() : tl::unexpected(session.error());
}

} // namespace

/// What is wrong with a file that does not open, and that looking changes nothing.
class TestFileHealth : public QObject {
    Q_OBJECT
private slots:
    void aSoundFileIsSound();
    void damageIsTold_data();
    void damageIsTold();
    void whatIsNotDamagedIsNotCalledSo();
    void aLogBesideMayHoldTheRest();
    void aPageOfTheAccountsIsMissedAtOpening();
    void aLookIsStopped();
};

void TestFileHealth::aSoundFileIsSound() {
    DatabaseFixture f;
    REQUIRE(makeClosed(f));
    QCOMPARE(examineFile(f.path()).health, FileHealth::sound);
    REQUIRE(checkAtOpening(f.path()));
    REQUIRE(f.reopen());
    QCOMPARE(examineFile(f.path()).health, FileHealth::sound); // also beside a writer
    REQUIRE(checkAtOpening(f.path()));
}

void TestFileHealth::damageIsTold_data() {
    QTest::addColumn<QString>("how");
    for (const QString& how : tests::kDamages)
        QTest::newRow(qPrintable(how)) << how;
}

void TestFileHealth::damageIsTold() {
    QFETCH(QString, how);
    DatabaseFixture f;
    REQUIRE(makeClosed(f));
    QVERIFY(tests::damage(QString::fromStdString(f.path()), how));
    const QByteArray before = contentOf(f.path());
    const FileState state = examineFile(f.path());
    QCOMPARE(state.health, FileHealth::damaged);
    QVERIFY(!state.detail.empty());
    QVERIFY(contentOf(f.path()) == before);
    const auto opened = checkAtOpening(f.path());
    const auto site = opened ? drop(Database::openForWriting(f.path(), f.options)) : opened;
    QVERIFY2(!site, "nobody could log in, and it opens");
    QCOMPARE(site.error().code, core::ErrorCode::storage);
}

void TestFileHealth::whatIsNotDamagedIsNotCalledSo() {
    DatabaseFixture f;
    QCOMPARE(examineFile(f.path()).health, FileHealth::missing);
    REQUIRE(makeClosed(f));
    QCOMPARE(examineFile(f.path("").substr(0, f.path("").size() - 1)).health,
             FileHealth::unreadable); // a folder
    const auto withHeader = [&](int at, char value) {
        const std::string name = f.path("other.db");
        QFile::remove(QString::fromStdString(name));
        QFile::copy(QString::fromStdString(f.path()), QString::fromStdString(name));
        QFile file(QString::fromStdString(name));
        return file.open(QIODevice::ReadWrite) && file.seek(at) && file.putChar(value) && file.flush()
                   ? examineFile(name).health
                   : FileHealth::sound;
    };
    QCOMPARE(withHeader(70, 'x'), FileHealth::foreign); // the application's id
    QCOMPARE(withHeader(63, 99), FileHealth::newer);    // the schema's number
}

// A program that was killed: the header counts pages that stand in the log alone.
void TestFileHealth::aLogBesideMayHoldTheRest() {
    DatabaseFixture f;
    REQUIRE(makeClosed(f));
    REQUIRE(f.reopen());
    const auto ada = AccountService(*f.database).login("ada", kPassword);
    REQUIRE(storeSession(*f.database, *ada, 40));
    const std::string copy = f.path("copy.db");
    for (const char* part : {"", "-wal"})
        QVERIFY(QFile::copy(QString::fromStdString(f.path() + part), QString::fromStdString(copy + part)));
    QCOMPARE(examineFile(copy).health, FileHealth::sound);
    REQUIRE(checkAtOpening(copy));
}

void TestFileHealth::aPageOfTheAccountsIsMissedAtOpening() {
    DatabaseFixture f;
    REQUIRE(makeClosed(f));
    std::int64_t page = 0;
    {
        auto connection = Connection::open(f.path(), Connection::Mode::readOnly);
        page = selectInteger(**connection, "SELECT rootpage FROM sqlite_schema WHERE name = 'credential'")
                   ->value_or(0);
    }
    QFile file(QString::fromStdString(f.path()));
    QVERIFY(page > 1 && file.open(QIODevice::ReadWrite) && file.seek((page - 1) * 4096));
    QCOMPARE(file.write(QByteArray(4096, '\x5a')), 4096);
    file.close();
    const auto opened = checkAtOpening(f.path());
    QVERIFY(!opened && opened.error().message.find("damaged") != std::string::npos);
    QCOMPARE(examineFile(f.path()).health, FileHealth::damaged);
}

void TestFileHealth::aLookIsStopped() {
    DatabaseFixture f;
    REQUIRE(makeClosed(f));
    const std::atomic<bool> stop = true;
    QCOMPARE(examineFile(f.path(), &stop).health, FileHealth::sound); // nothing is claimed
}

QTEST_GUILESS_MAIN(TestFileHealth)
#include "test_file_health.moc"
