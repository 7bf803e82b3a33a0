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
#include <cstdio>
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
    void exportSiteHoldsEverythingButSecrets();
    void fullDiskLeavesNoHalfBackup();
    void killedBackupLeavesTheDatabaseUsable();
};

void TestUpkeep::backupIsWholeAndVerified() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    const std::string folder = f.path("backup");
    const auto info = Upkeep::backup(*f.database, *ada, folder);
    REQUIRE(info);
    QVERIFY(info->auditCount > 0 && info->auditHash.size() == 64 && info->blake2b.size() == 64);
    QCOMPARE(QDir(QString::fromStdString(folder)).entryList(QDir::Files),
             (QStringList{"chiron.db", "erasures.json", "manifest.json"}));
    QVERIFY(!QDir(QString::fromStdString(folder + ".partial")).exists());
    const QJsonObject manifest = QJsonDocument::fromJson(contentOf(folder + "/manifest.json")).object();
    QCOMPARE(manifest["audit_count"].toInteger(), info->auditCount);
    QCOMPARE(manifest["files"].toObject()["chiron.db"].toString().toStdString(), info->blake2b);
    auto copy = Database::openReadOnly(folder + "/chiron.db", f.options); // readable as it is
    REQUIRE(copy);
    QCOMPARE(Upkeep::backup(*f.database, *ada, folder).error().code,
             core::ErrorCode::badInput);                       // never over another one
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
    REQUIRE(f.database->write([](WriteContext& w) {
        return w.connection().execute("UPDATE chunk SET payload = zeroblob(700) WHERE id = 2");
    }));
    const auto refused = Upkeep::backup(*f.database, *ada, f.path("backup"));
    QCOMPARE(refused.error().code, core::ErrorCode::doesNotHold);
    QVERIFY(refused.error().message.find("sequence=1") != std::string::npos);
    QVERIFY(!QDir(QString::fromStdString(f.path("backup"))).exists());
    QVERIFY(!QDir(QString::fromStdString(f.path("backup.partial"))).exists());
}

void TestUpkeep::exportSiteHoldsEverythingButSecrets() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator("Åda \"quoted\"");
    REQUIRE(ada);
    REQUIRE(storeSession(*f.database, *ada));
    const std::string folder = f.path("export");
    REQUIRE(Upkeep::exportSite(*f.database, *ada, folder));
    const auto others = QFile::ReadGroup | QFile::ExeGroup | QFile::ReadOther | QFile::ExeOther;
    QVERIFY(!(QFile::permissions(QString::fromStdString(folder)) & others)); // people's names lie in it
    const QByteArray scores = contentOf(folder + "/tables/score.jsonl");
    const QList<QByteArray> lines = scores.trimmed().split('\n');
    QCOMPARE(lines.size(), 4);
    const QJsonObject path = QJsonDocument::fromJson(lines[0]).object();
    QCOMPARE(path["value"].toDouble(), 0.1 + 0.2);
    QVERIFY(QJsonDocument::fromJson(lines[1]).object()["value"].isNull());
    QVERIFY(contentOf(folder + "/tables/person.jsonl").contains("Åda \\\"quoted\\\""));
    const QJsonObject chunk =
        QJsonDocument::fromJson(contentOf(folder + "/tables/chunk.jsonl").split('\n')[0]).object();
    const auto payload = someChunk(0).payload;
    QCOMPARE(
        QByteArray::fromHex(chunk["payload"].toString().toLatin1()),
        QByteArray(reinterpret_cast<const char*>(payload.data()), static_cast<qsizetype>(payload.size())));
    QVERIFY(!QFile::exists(QString::fromStdString(folder + "/tables/credential.jsonl")));
    QDir tables(QString::fromStdString(folder + "/tables"));
    for (const QString& name : tables.entryList(QDir::Files)) {
        QVERIFY(!contentOf(tables.filePath(name).toStdString()).contains("argon2"));
    }
    const QJsonObject files =
        QJsonDocument::fromJson(contentOf(folder + "/manifest.json")).object()["files"].toObject();
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
    const auto refused =
        beside ? Upkeep::backup(**beside, *ada, f.path("backup")) : tl::unexpected(beside.error());
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
        helper.start(QCoreApplication::applicationFilePath(), {"--backups", QString::fromStdString(f.path()),
                                                               QString::fromStdString(f.path("killed"))});
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
    f.folder.remove(); // its options are what is wanted; a killed process leaves its folder
    auto database = Database::openForWriting(file, f.options);
    auto ada = database ? AccountService(**database).login("ada", kPassword)
                        : core::Result<Actor>(tl::unexpected(database.error()));
    if (!ada) {
        return 1;
    }
    std::puts("ready");
    std::fflush(stdout);
    for (int i = 0;; ++i) {
        if (!Upkeep::backup(**database, *ada,
                            folder + "-" + std::to_string(QCoreApplication::applicationPid()) + "-" +
                                std::to_string(i))) {
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
