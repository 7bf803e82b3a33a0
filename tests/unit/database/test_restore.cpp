// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/integrity/verifier.h"
#include "database/query.h"
#include "database/repositories/audit_repository.h"
#include "database/repositories/privacy_repository.h"
#include "database/upkeep/upkeep.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QThread>
#include <algorithm>
#include <csignal>
#include <sys/resource.h>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Restoring a backup: all of it, or nothing happened.
class TestRestore : public QObject {
    Q_OBJECT
private slots:
    void restoreBringsBackAndKeepsTheOld();
    void restoreAppliesLaterErasures();
    void restoreErasesNobodyElseWithTheNumber();
    void restoreElsewhereNeedsTheKey();
    void restoreRefusesChangedBackups_data();
    void restoreRefusesChangedBackups();
    void restoreRefusesADevice_data();
    void restoreRefusesADevice();
    void restoreNeedsAnAdministratorAndTheLock();
    void restoreNeedsAnAdministratorOfWhatItReplaces();
    void restoreReplacesADamagedFile();
    void restoreKeepsTheOldLogWithTheOldFile();
    void restoreErasesWhatWasRunning();
};

void TestRestore::restoreBringsBackAndKeepsTheOld() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto first = storeSession(*f.database, *ada);
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    REQUIRE(storeSession(*f.database, *ada)); // after the backup
    f.database.reset();
    const auto info = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(info);
    QCOMPARE(info->erasuresApplied, 0);
    const auto countIn = [](const std::string& file) {
        auto connection = Connection::open(file, Connection::Mode::readOnly);
        return connection ? selectInteger(**connection, "SELECT count(*) FROM session")->value_or(-1) : -1;
    };
    QCOMPARE(countIn(f.path()), std::int64_t{1});
    QCOMPARE(countIn(info->keptOldFile), std::int64_t{2}); // nothing is lost
    QVERIFY(verifyDatabase(f.path(), f.options).ok());     // also the head file follows
    REQUIRE(f.reopen());
    const auto again = AccountService(*f.database).login("ada", kPassword);
    REQUIRE(again);
    auto reader = f.database->openReader();
    const auto scores = ScoreRepository(**reader, *again).scores(*first);
    REQUIRE(scores);
    QCOMPARE(*scores->metrics[0].value, 0.1 + 0.2);
    const auto audit = AuditRepository(**reader, *again).listAudit();
    QVERIFY(
        std::any_of(audit->begin(), audit->end(), [](const AuditEntry& e) { return e.action == "restore"; }));
    const auto next = storeSession(*f.database, *again);
    REQUIRE(next);
    reader->reset();
    f.database.reset();
    const auto twice = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(twice); // a second time: the first kept file stays
    QCOMPARE(twice->keptOldFile, info->keptOldFile + "-2");
    QCOMPARE(countIn(info->keptOldFile), std::int64_t{2});
}

// A program that was killed leaves its newest rows in the log alone: they go with the file that is kept, and
// never into the restored one.
void TestRestore::restoreKeepsTheOldLogWithTheOldFile() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    REQUIRE(f.reopen()); // all that went before is in the file, and the log is empty
    REQUIRE(storeSession(*f.database, *ada));
    QByteArray file = contentOf(f.path());
    const QByteArray log = contentOf(f.path() + "-wal");
    QVERIFY(!log.isEmpty());
    f.database.reset();
    const auto putBack = [](const std::string& name, const QByteArray& bytes) {
        QFile out(QString::fromStdString(name));
        return out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size();
    };
    QVERIFY(putBack(f.path(), file) && putBack(f.path() + "-wal", log)); // as the kill left them
    const auto info = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(info);
    const auto countIn = [](const std::string& name) {
        auto connection = Connection::open(name, Connection::Mode::readWrite);
        return connection ? selectInteger(**connection, "SELECT count(*) FROM session")->value_or(-1) : -1;
    };
    QCOMPARE(countIn(info->keptOldFile), std::int64_t{2});
    QCOMPARE(countIn(f.path()), std::int64_t{1});
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
    // Where the file is damaged its log cannot go into it: both are kept as they are.
    QFile::remove(QString::fromStdString(f.path() + "-wal"));
    file.fill('x', 8192);
    QVERIFY(putBack(f.path(), file) && putBack(f.path() + "-wal", log));
    const auto second = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(second);
    QCOMPARE(contentOf(second->keptOldFile), file);
    QCOMPARE(contentOf(second->keptOldFile + "-wal"), log);
    QCOMPARE(countIn(f.path()), std::int64_t{1});
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

// The backup was made while a session ran: its ring's file is named there, in a folder that tells whose it
// is.
void TestRestore::restoreErasesWhatWasRunning() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    NewSession begun = someSession();
    begun.ringFile = "/home/timotheus-unverwechselbar/ring";
    const auto id = f.database->write(
        [&](WriteContext& w) { return SessionRepository(w.connection(), *tim).beginSession(begun); });
    REQUIRE(id);
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    REQUIRE(f.database->write([&](WriteContext& w) {
        SessionEnd end;
        end.state = SessionState::stopped;
        return SessionRepository(w.connection(), *tim).finishSession(*id, end);
    }));
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true));
    f.database.reset();
    QVERIFY(!contentOf(f.path()).contains("timotheus-unverwechselbar"));
    QVERIFY(contentOf(f.path("backup") + "/chiron.db").contains("timotheus-unverwechselbar"));
    const auto info = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(info);
    QCOMPARE(info->erasuresApplied, 1);
    QVERIFY(!contentOf(f.path()).contains("timotheus-unverwechselbar"));
}

void TestRestore::restoreAppliesLaterErasures() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "timotheus-unverwechselbar", {Role::trainee});
    REQUIRE(storeSession(*f.database, *tim));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true));
    f.database.reset();
    QVERIFY(contentOf(f.path("backup") + "/chiron.db").contains("timotheus-unverwechselbar"));
    const auto info = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(info);
    QCOMPARE(info->erasuresApplied, 1);
    QVERIFY(!contentOf(f.path()).contains("timotheus-unverwechselbar"));
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
    // The same where only the site's list remembers (the file itself is lost).
    QFile::remove(QString::fromStdString(f.path()));
    const auto second = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(second);
    QCOMPARE(second->erasuresApplied, 1);
    REQUIRE(f.reopen());
    auto reader = f.database->openReader();
    QCOMPARE(PrivacyRepository(**reader, *ada).listErasures()->size(), std::size_t{1});
    // And elsewhere, from the list that lies beside the key.
    RestoreRequest elsewhere = requestFor(f, f.path("backup"));
    elsewhere.targetFile = f.path("elsewhere.db");
    elsewhere.siteKeyFile = f.path() + ".site/site.key";
    const auto third = Upkeep::restore(elsewhere, f.options);
    REQUIRE(third);
    QCOMPARE(third->erasuresApplied, 1);
    QVERIFY(!contentOf(elsewhere.targetFile).contains("timotheus-unverwechselbar"));
    // A later backup carries the list itself.
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("later")));
    QVERIFY(contentOf(f.path("later") + "/erasures.json").contains("wish"));
}

void TestRestore::restoreErasesNobodyElseWithTheNumber() {
    // After a restore to before somebody came, the next newcomer gets that person's number.
    DatabaseFixture f;
    REQUIRE(f.create());
    auto ada = f.administrator();
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("before")));
    const auto tim = f.person(*ada, "timotheus-unverwechselbar", {Role::trainee});
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("with tim")));
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true));
    f.database.reset();
    REQUIRE(Upkeep::restore(requestFor(f, f.path("before")), f.options));
    REQUIRE(f.reopen());
    ada = AccountService(*f.database).login("ada", kPassword);
    const auto nora = f.person(*ada, "nora-unverwechselbar", {Role::trainee});
    QCOMPARE(nora->personId(), tim->personId());
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("with nora")));
    f.database.reset();
    const auto kept = Upkeep::restore(requestFor(f, f.path("with nora")), f.options);
    REQUIRE(kept);
    QCOMPARE(kept->erasuresApplied, 0);
    QVERIFY(contentOf(f.path()).contains("nora-unverwechselbar"));
    // Erasing the second one does not make the first one's erasure forgotten.
    REQUIRE(f.reopen());
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, nora->personId(), "wish", true));
    f.database.reset();
    for (const char* backup : {"with tim", "with nora"}) {
        const auto again = Upkeep::restore(requestFor(f, f.path(backup)), f.options);
        REQUIRE(again);
        QCOMPARE(again->erasuresApplied, 1);
    }
}

void TestRestore::restoreElsewhereNeedsTheKey() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    RestoreRequest request = requestFor(f, f.path("backup"));
    request.targetFile = f.path("elsewhere.db");
    QCOMPARE(Upkeep::restore(request, f.options).error().code, core::ErrorCode::notFound);
    QVERIFY(!QFile::exists(QString::fromStdString(request.targetFile)));
    request.siteKeyFile = f.path() + ".site/site.key";
    request.password = "not the word";
    QVERIFY(!Upkeep::restore(request, f.options));
    QVERIFY(
        !QFile::exists(QString::fromStdString(request.targetFile + ".site"))); // no key is left lying about
    request.password = kPassword;
    const auto info = Upkeep::restore(request, f.options);
    REQUIRE(info);
    QVERIFY(info->keptOldFile.empty());
    QVERIFY(verifyDatabase(request.targetFile, f.options).ok());
    REQUIRE(Database::openForWriting(request.targetFile, f.options));
    // Another site's key is no key for this backup.
    DatabaseFixture other;
    REQUIRE(other.create());
    other.database.reset();
    request.targetFile = other.path();
    QCOMPARE(Upkeep::restore(request, other.options).error().code, core::ErrorCode::doesNotHold);
    QVERIFY(verifyDatabase(other.path(), other.options).ok());
}

void TestRestore::restoreRefusesChangedBackups_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("offset");
    QTest::newRow("database") << "chiron.db" << 9000;
    QTest::newRow("erasures") << "erasures.json" << 0;
    QTest::newRow("manifest") << "manifest.json" << 20;
    QTest::newRow("database missing") << "chiron.db" << -1;
    QTest::newRow("manifest missing") << "manifest.json" << -1;
}

void TestRestore::restoreRefusesChangedBackups() {
    QFETCH(QString, file);
    QFETCH(int, offset);
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    f.database.reset();
    QFile damaged(QString::fromStdString(f.path("backup") + "/") + file);
    if (offset < 0) {
        QVERIFY(damaged.remove());
    } else {
        QVERIFY(damaged.open(QIODevice::ReadWrite));
        damaged.seek(offset);
        const char byte = static_cast<char>(damaged.peek(1)[0] ^ 4);
        damaged.write(&byte, 1);
        damaged.close();
    }
    const QByteArray before = contentOf(f.path());
    QVERIFY(!Upkeep::restore(requestFor(f, f.path("backup")), f.options));
    QCOMPARE(contentOf(f.path()), before);
    QVERIFY(!QFile::exists(QString::fromStdString(f.path() + ".restoring")));
    REQUIRE(f.reopen());
}

void TestRestore::restoreRefusesADevice_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("said");
    QTest::newRow("manifest") << "manifest.json"
                              << "not a regular file";
    QTest::newRow("database") << "chiron.db"
                              << "missing or changed";
    QTest::newRow("erasures") << "erasures.json"
                              << "missing or changed";
}

// A link to /dev/zero has no end and needs no disk: whoever read it whole would take all memory.
void TestRestore::restoreRefusesADevice() {
    QFETCH(QString, file);
    QFETCH(QString, said);
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    f.database.reset();
    const QString name = QString::fromStdString(f.path("backup") + "/") + file;
    QVERIFY(QFile::remove(name) && QFile::link(QStringLiteral("/dev/zero"), name));
    const QByteArray before = contentOf(f.path());
    const auto refused = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    QVERIFY(!refused);
    QVERIFY2(QString::fromStdString(refused.error().message).contains(said), refused.error().message.c_str());
    QCOMPARE(contentOf(f.path()), before);
    QVERIFY(!QFile::exists(QString::fromStdString(f.path() + ".restoring")));
    REQUIRE(f.reopen());
}

void TestRestore::restoreNeedsAnAdministratorAndTheLock() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(f.person(*ada, "tim", {Role::trainee, Role::trainer}));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    QCOMPARE(Upkeep::restore(requestFor(f, f.path("backup")), f.options).error().code,
             core::ErrorCode::locked);
    f.database.reset();
    RestoreRequest request = requestFor(f, f.path("backup"));
    request.name = "tim";
    QCOMPARE(Upkeep::restore(request, f.options).error().code, core::ErrorCode::notAllowed);
    request.name = "ada";
    request.password = "wrong word 12";
    QCOMPARE(Upkeep::restore(request, f.options).error().code, core::ErrorCode::notAllowed);
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestRestore::restoreNeedsAnAdministratorOfWhatItReplaces() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto zoe = f.person(*ada, "zoe", {Role::admin});
    REQUIRE(zoe);
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    AccountService accounts(*f.database);
    REQUIRE(accounts.setRoles(*ada, zoe->personId(), {Role::trainee}));
    REQUIRE(accounts.changePassword(*ada, kPassword, "newer horse 77"));
    f.database.reset();
    // Zoe was an administrator when the backup was made, and is none now.
    RestoreRequest request = requestFor(f, f.path("backup"));
    request.name = "zoe";
    const auto refused = Upkeep::restore(request, f.options);
    QCOMPARE(refused.error().code, core::ErrorCode::notAllowed);
    QVERIFY2(refused.error().message.find("must agree") != std::string::npos,
             refused.error().message.c_str());
    // Ada's word of that time is not her word of today.
    request.name = "ada";
    QCOMPARE(Upkeep::restore(request, f.options).error().code, core::ErrorCode::notAllowed);
    request.presentName = "ada";
    request.presentPassword = "newer horse 77";
    REQUIRE(Upkeep::restore(request, f.options));
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestRestore::restoreReplacesADamagedFile() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    f.database.reset();
    QFile file(QString::fromStdString(f.path()));
    QVERIFY(file.open(QIODevice::ReadWrite));
    file.write(QByteArray(8192, 'x'));
    file.close();
    QVERIFY(!verifyDatabase(f.path(), f.options).ok());
    const auto info = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(info);
    QVERIFY(contentOf(info->keptOldFile).startsWith("xxxx"));
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

QTEST_GUILESS_MAIN(TestRestore)
#include "test_restore.moc"
