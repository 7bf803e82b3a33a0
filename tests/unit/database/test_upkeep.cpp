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
#include <csignal>
#include <sys/resource.h>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Backup, restore, export: whole or not there.
class TestUpkeep : public QObject {
    Q_OBJECT
private slots:
    void backupIsWholeAndVerified();
    void backupOfADamagedDatabaseIsRefused();
    void restoreBringsBackAndKeepsTheOld();
    void restoreAppliesLaterErasures();
    void restoreElsewhereNeedsTheKey();
    void restoreRefusesChangedBackups_data();
    void restoreRefusesChangedBackups();
    void restoreNeedsAnAdministratorAndTheLock();
    void restoreReplacesADamagedFile();
    void exportSiteHoldsEverythingButSecrets();
    void fullDiskLeavesNoHalfBackup();
    void killedBackupLeavesTheDatabaseUsable();
};

namespace {
RestoreRequest requestFor(const DatabaseFixture& f, const std::string& folder) { return {folder, f.path(), "ada", kPassword, ""}; }

QByteArray contentOf(const std::string& name) {
    QFile file(QString::fromStdString(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
} // namespace

void TestUpkeep::backupIsWholeAndVerified() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    const std::string folder = f.path("backup");
    const auto info = Upkeep::backup(*f.database, *ada, folder);
    REQUIRE(info);
    QVERIFY(info->auditCount > 0 && info->auditHash.size() == 64 && info->blake2b.size() == 64);
    QCOMPARE(QDir(QString::fromStdString(folder)).entryList(QDir::Files), (QStringList{"chiron.db", "erasures.json", "manifest.json"}));
    QVERIFY(!QDir(QString::fromStdString(folder + ".partial")).exists());
    const QJsonObject manifest = QJsonDocument::fromJson(contentOf(folder + "/manifest.json")).object();
    QCOMPARE(manifest["audit_count"].toInteger(), info->auditCount);
    QCOMPARE(manifest["files"].toObject()["chiron.db"].toString().toStdString(), info->blake2b);
    auto copy = Database::openReadOnly(folder + "/chiron.db", f.options); // readable as it is
    REQUIRE(copy);
    QCOMPARE(Upkeep::backup(*f.database, *ada, folder).error().code, core::ErrorCode::badInput); // never over another one
    auto beside = Database::openReadOnly(f.path(), f.options); // also beside a writer
    REQUIRE(beside);
    REQUIRE(Upkeep::backup(**beside, *ada, f.path("second")));
    auto reader = f.database->openReader();
    QCOMPARE(AuditRepository(**reader, *ada).listAudit(1)->front().action, std::string("backup"));
}

void TestUpkeep::backupOfADamagedDatabaseIsRefused() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    REQUIRE(f.database->write([](WriteContext& w) { return w.connection().execute("UPDATE chunk SET payload = zeroblob(700) WHERE id = 2"); }));
    const auto refused = Upkeep::backup(*f.database, *ada, f.path("backup"));
    QCOMPARE(refused.error().code, core::ErrorCode::doesNotHold);
    QVERIFY(refused.error().message.find("sequence=1") != std::string::npos);
    QVERIFY(!QDir(QString::fromStdString(f.path("backup"))).exists());
    QVERIFY(!QDir(QString::fromStdString(f.path("backup.partial"))).exists());
}

void TestUpkeep::restoreBringsBackAndKeepsTheOld() {
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
    QVERIFY(std::any_of(audit->begin(), audit->end(), [](const AuditEntry& e) { return e.action == "restore"; }));
    const auto next = storeSession(*f.database, *again);
    REQUIRE(next);
    reader->reset();
    f.database.reset();
    REQUIRE(Upkeep::restore(requestFor(f, f.path("backup")), f.options)); // a second time: the first kept file stays
    QCOMPARE(countIn(info->keptOldFile), std::int64_t{2});
}

void TestUpkeep::restoreAppliesLaterErasures() {
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
    // A later backup carries the list itself.
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("later")));
    QVERIFY(contentOf(f.path("later") + "/erasures.json").contains("wish"));
}

void TestUpkeep::restoreElsewhereNeedsTheKey() {
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

void TestUpkeep::restoreRefusesChangedBackups_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("offset");
    QTest::newRow("database") << "chiron.db" << 9000;
    QTest::newRow("erasures") << "erasures.json" << 0;
    QTest::newRow("manifest") << "manifest.json" << 20;
    QTest::newRow("database missing") << "chiron.db" << -1;
    QTest::newRow("manifest missing") << "manifest.json" << -1;
}

void TestUpkeep::restoreRefusesChangedBackups() {
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

void TestUpkeep::restoreNeedsAnAdministratorAndTheLock() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(f.person(*ada, "tim", {Role::trainee, Role::trainer}));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
    QCOMPARE(Upkeep::restore(requestFor(f, f.path("backup")), f.options).error().code, core::ErrorCode::locked);
    f.database.reset();
    RestoreRequest request = requestFor(f, f.path("backup"));
    request.name = "tim";
    QCOMPARE(Upkeep::restore(request, f.options).error().code, core::ErrorCode::notAllowed);
    request.name = "ada";
    request.password = "wrong word 12";
    QCOMPARE(Upkeep::restore(request, f.options).error().code, core::ErrorCode::notAllowed);
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestUpkeep::restoreReplacesADamagedFile() {
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

void TestUpkeep::exportSiteHoldsEverythingButSecrets() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator("Åda \"quoted\"");
    REQUIRE(ada);
    REQUIRE(storeSession(*f.database, *ada));
    const std::string folder = f.path("export");
    REQUIRE(Upkeep::exportSite(*f.database, *ada, folder));
    const QByteArray scores = contentOf(folder + "/tables/score.jsonl");
    const QList<QByteArray> lines = scores.trimmed().split('\n');
    QCOMPARE(lines.size(), 4);
    const QJsonObject path = QJsonDocument::fromJson(lines[0]).object();
    QCOMPARE(path["value"].toDouble(), 0.1 + 0.2);
    QVERIFY(QJsonDocument::fromJson(lines[1]).object()["value"].isNull());
    QVERIFY(contentOf(folder + "/tables/person.jsonl").contains("Åda \\\"quoted\\\""));
    const QJsonObject chunk = QJsonDocument::fromJson(contentOf(folder + "/tables/chunk.jsonl").split('\n')[0]).object();
    const auto payload = someChunk(0).payload;
    QCOMPARE(QByteArray::fromHex(chunk["payload"].toString().toLatin1()), QByteArray(reinterpret_cast<const char*>(payload.data()), static_cast<qsizetype>(payload.size())));
    QVERIFY(!QFile::exists(QString::fromStdString(folder + "/tables/credential.jsonl")));
    QDir tables(QString::fromStdString(folder + "/tables"));
    for (const QString& name : tables.entryList(QDir::Files)) {
        QVERIFY(!contentOf(tables.filePath(name).toStdString()).contains("argon2"));
    }
    const QJsonObject files = QJsonDocument::fromJson(contentOf(folder + "/manifest.json")).object()["files"].toObject();
    QCOMPARE(files.size(), tables.entryList(QDir::Files).size() + 2);
}

void TestUpkeep::fullDiskLeavesNoHalfBackup() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada, 60));
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &old), 0);
    rlimit small = old;
    small.rlim_cur = 40000; // less than the copy needs
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    auto beside = Database::openReadOnly(f.path(), f.options);
    const auto refused = beside ? Upkeep::backup(**beside, *ada, f.path("backup")) : tl::unexpected(beside.error());
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &old), 0);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::storage);
    QVERIFY(!QDir(QString::fromStdString(f.path("backup"))).exists());
    QVERIFY(!QDir(QString::fromStdString(f.path("backup.partial"))).exists());
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("backup")));
}

void TestUpkeep::killedBackupLeavesTheDatabaseUsable() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    for (int i = 0; i < 5; ++i) {
        REQUIRE(storeSession(*f.database, *ada, 40));
    }
    f.database.reset();
    // Another process makes backup after backup; it is killed at moments spread over its work.
    for (int delay_ms = 5; delay_ms < 400; delay_ms += 40) {
        QProcess helper;
        helper.start(QCoreApplication::applicationFilePath(), {"--backups", QString::fromStdString(f.path()), QString::fromStdString(f.path("killed"))});
        QVERIFY(helper.waitForStarted());
        QVERIFY(helper.waitForReadyRead(20000)); // it says so before the first one
        QThread::msleep(static_cast<unsigned long>(delay_ms));
        helper.kill();
        QVERIFY(helper.waitForFinished());
        REQUIRE(f.reopen()); // the dead process's lock is no obstacle
        f.database.reset();
    }
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
    // A folder that carries its final name is whole: it can be restored.
    QStringList made = QDir(f.folder.path()).entryList({"killed*"}, QDir::Dirs);
    made.removeIf([](const QString& name) { return name.endsWith(".partial"); });
    if (!made.isEmpty()) {
        REQUIRE(Upkeep::restore(requestFor(f, f.folder.filePath(made.last()).toStdString()), f.options));
    }
    REQUIRE(f.reopen());
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("after")));
}

namespace {

// The process that is killed: backups of a database, one after the other, until then.
int makeBackups(const std::string& file, const std::string& folder) {
    DatabaseFixture f;
    auto database = Database::openForWriting(file, f.options);
    auto ada = database ? AccountService(**database).login("ada", kPassword) : core::Result<Actor>(tl::unexpected(database.error()));
    if (!ada) {
        return 1;
    }
    std::puts("ready");
    std::fflush(stdout);
    for (int i = 0;; ++i) {
        if (!Upkeep::backup(**database, *ada, folder + "-" + std::to_string(QCoreApplication::applicationPid()) + "-" + std::to_string(i))) {
            return 1;
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc == 4 && std::string(argv[1]) == "--backups") {
        return makeBackups(argv[2], argv[3]);
    }
    TestUpkeep test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_upkeep.moc"
