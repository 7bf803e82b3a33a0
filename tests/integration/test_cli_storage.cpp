// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

// Backup, restore, export, migrate and verify, as a technician scripts them.
class TestCliStorage : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aSoundDatabaseVerifies();
    void backupAndRestore();
    void restoreRefusesDamage();
    void exportIsANewFolder();
    void migrateKeepsACurrentDatabase();
    void verifyFindsDamage();
    void refusals_data();
    void refusals();

private:
    CliRun asAlice(const QStringList& arguments, const QString& database = {});
    QJsonObject verified(const QString& database);

    QTemporaryDir m_folder;
    QString m_database;
};

namespace {
const QString kAlice = QStringLiteral("correct horse battery");

QJsonObject object(const CliRun& run) {
    return QJsonDocument::fromJson(run.out).object();
}
} // namespace

CliRun TestCliStorage::asAlice(const QStringList& arguments, const QString& database) {
    return runCli(arguments + QStringList{"--as", "alice", "--json", "--database",
                                          database.isEmpty() ? m_database : database},
                  {}, {{"CHIRON_PASSWORD", kAlice}});
}

QJsonObject TestCliStorage::verified(const QString& database) {
    return object(runCli({"verify", "--json", "--database", database}));
}

void TestCliStorage::initTestCase() {
    m_database = m_folder.filePath("site.db");
    const CliRun made =
        runCli({"init", "--admin", "alice", "--database", m_database}, {}, {{"CHIRON_PASSWORD", kAlice}});
    QVERIFY2(made.exitCode == 0, made.err.constData());
    QCOMPARE(asAlice({"user", "add", "bob", "--role", "trainee"}).exitCode, 0);
}

void TestCliStorage::aSoundDatabaseVerifies() {
    const CliRun run = runCli({"verify", "--json", "--database", m_database});
    QVERIFY2(run.exitCode == 0, run.out.constData());
    QCOMPARE(object(run)["ok"].toBool(false), true);
    QVERIFY(object(run)["findings"].toArray().isEmpty());
    QVERIFY(object(run)["rows_checked"].toInt() > 0);
}

void TestCliStorage::backupAndRestore() {
    const QString backup = m_folder.filePath("backup");
    const CliRun made = asAlice({"backup", backup});
    QVERIFY2(made.exitCode == 0, made.err.constData());
    QCOMPARE(object(made)["folder"].toString(), backup);
    QCOMPARE(asAlice({"backup", backup}).exitCode, 3); // never over an old one
    QCOMPARE(asAlice({"user", "add", "late", "--role", "trainee"}).exitCode, 0);
    const CliRun restored = asAlice({"restore", backup});
    QVERIFY2(restored.exitCode == 0, restored.err.constData());
    QVERIFY(QFile::exists(object(restored)["kept_old_file"].toString()));
    const QJsonArray people = QJsonDocument::fromJson(asAlice({"user", "list"}).out).array();
    QCOMPARE(people.size(), 2); // alice and bob, as it was
    QCOMPARE(verified(m_database)["ok"].toBool(false), true);
}

void TestCliStorage::restoreRefusesDamage() {
    const QString backup = m_folder.filePath("damaged");
    const CliRun made = asAlice({"backup", backup});
    QCOMPARE(made.exitCode, 0);
    QFile file(QDir(backup).filePath(object(made)["database"].toString()));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.seek(file.size() / 2));
    QCOMPARE(file.write("damage"), 6);
    file.close();
    const CliRun refused = asAlice({"restore", backup});
    QVERIFY(refused.ended && refused.exitCode != 0);
    QVERIFY(refused.out.isEmpty());
    QCOMPARE(verified(m_database)["ok"].toBool(false), true); // what stood there still stands
}

void TestCliStorage::exportIsANewFolder() {
    const QString folder = m_folder.filePath("export");
    const CliRun made = asAlice({"export-site", folder});
    QVERIFY2(made.exitCode == 0, made.err.constData());
    QVERIFY(QDir(folder).entryList(QDir::Files).size() > 1);
    QCOMPARE(asAlice({"export-site", folder}).exitCode, 3);
}

void TestCliStorage::migrateKeepsACurrentDatabase() {
    const CliRun run = asAlice({"migrate"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QVERIFY(object(run)["schema_version"].toInt() >= 1);
}

// One page of the file is overwritten: verify says so with exit status 1 and one document, and does not
// crash.
void TestCliStorage::verifyFindsDamage() {
    const QString copy = m_folder.filePath("copy.db");
    QVERIFY(QFile::copy(m_database, copy));
    QFile file(copy);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.size() > 3 * 4096);
    QVERIFY(file.seek(4096 + 100));
    QCOMPARE(file.write(QByteArray(3000, '\xa5')), 3000);
    file.close();
    const CliRun run = runCli({"verify", "--json", "--database", copy});
    QVERIFY(run.ended);
    QCOMPARE(run.exitCode, 1);
    QCOMPARE(object(run)["ok"].toBool(true), false);
    const QJsonArray findings = object(run)["findings"].toArray();
    QVERIFY(!findings.isEmpty());
    for (const QJsonValue& finding : findings)
        QVERIFY(!finding["kind"].toString().isEmpty() && !finding["detail"].toString().isEmpty());
}

void TestCliStorage::refusals_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    const QString folder = m_folder.path();
    for (const char* command : {"backup", "restore", "export-site"}) {
        QTest::addRow("%s without folder", command) << QStringList{command} << 2;
        QTest::addRow("%s as nobody", command)
            << QStringList{command, folder + "/x", "--database", m_database} << 2;
        QTest::addRow("%s without password", command)
            << QStringList{command, folder + "/x", "--as", "alice", "--database", m_database} << 2;
    }
    QTest::newRow("migrate as nobody") << QStringList{"migrate", "--database", m_database} << 2;
    QTest::newRow("verify nothing") << QStringList{"verify", "--database", folder + "/none.db"} << 3;
    QTest::newRow("verify a folder") << QStringList{"verify", "--database", folder} << 3;
}

void TestCliStorage::refusals() {
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    const CliRun run = runCli(arguments);
    QVERIFY(run.ended);
    QCOMPARE(run.exitCode, exitCode);
    QVERIFY(run.out.isEmpty());
    QVERIFY(run.err.startsWith("chiron-cli: ") && run.err.count('\n') == 1);
}

QTEST_GUILESS_MAIN(TestCliStorage)
#include "test_cli_storage.moc"
