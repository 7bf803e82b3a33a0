// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/backup_list.h"
#include "session/backup_schedule.h"
#include "session/same_disk.h"

#include <QDir>
#include <QFile>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QTimeZone>
#include <QtTest>

using namespace chiron;
using namespace chiron::session;
using namespace std::chrono_literals;

/// When the day's backup is due, and where it goes.
class TestBackupSchedule : public QObject {
    Q_OBJECT
private slots:
    void oneADay_data();
    void oneADay();
    void theDayIsThePersons();
    void failuresWaitLonger();
    void thePlanNamesTheFolder();
    void oneDiskIsNoticed();
    void theDaysBackupIsMadeOnce();
    void aDeviceIsNoManifest();
};

void TestBackupSchedule::oneADay_data() {
    QTest::addColumn<bool>("on");
    QTest::addColumn<QString>("good");
    QTest::addColumn<bool>("due");
    QTest::newRow("none yet") << true << QString() << true;
    QTest::newRow("today") << true << QStringLiteral("2026-11-20T06:00:00.000Z") << false;
    QTest::newRow("today, later than now") << true << QStringLiteral("2026-11-20T23:00:00.000Z") << false;
    QTest::newRow("yesterday") << true << QStringLiteral("2026-11-19T23:59:59.000Z") << true;
    QTest::newRow("the clock was a month ahead")
        << true << QStringLiteral("2026-12-20T06:00:00.000Z") << true;
    QTest::newRow("off") << false << QStringLiteral("2026-11-01T06:00:00.000Z") << false;
    QTest::newRow("no time at all") << true << QStringLiteral("yesterday") << true;
}

void TestBackupSchedule::oneADay() {
    QFETCH(bool, on);
    QFETCH(QString, good);
    QFETCH(bool, due);
    database::BackupStanding standing;
    standing.plan.on = on;
    standing.goodUtc = good.toStdString();
    QCOMPARE(isBackupDue(standing, QDateTime(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC)), due);
}

void TestBackupSchedule::theDayIsThePersons() {
    database::BackupStanding standing;
    standing.goodUtc = "2026-11-19T23:30:00.000Z";
    const QTimeZone east(3600 * 2);
    QVERIFY(!isBackupDue(
        standing, QDateTime(QDate(2026, 11, 20), QTime(9, 0), east))); // half past one of the same day there
    QVERIFY(isBackupDue(standing, QDateTime(QDate(2026, 11, 20), QTime(9, 0), Qt::UTC)));
}

void TestBackupSchedule::failuresWaitLonger() {
    QCOMPARE(waitAfterFailures(0), std::chrono::milliseconds(0));
    QCOMPARE(waitAfterFailures(1), std::chrono::milliseconds(15min));
    QCOMPARE(waitAfterFailures(2), std::chrono::milliseconds(30min));
    QCOMPARE(waitAfterFailures(5), std::chrono::milliseconds(4h));
    QCOMPARE(waitAfterFailures(500), std::chrono::milliseconds(4h));
}

void TestBackupSchedule::thePlanNamesTheFolder() {
    database::BackupPlan plan;
    QCOMPARE(folderOfPlan(plan, "", "/data/site.db"), std::string("/data/backups"));
    QCOMPARE(folderOfPlan(plan, "/media/station", "/data/site.db"), std::string("/media/station"));
    plan.folder = "/media/plan";
    QCOMPARE(folderOfPlan(plan, "/media/station", "/data/site.db"), std::string("/media/plan"));
}

void TestBackupSchedule::oneDiskIsNoticed() {
    QTemporaryDir folder;
    const std::string site = folder.filePath(QStringLiteral("site.db")).toStdString();
    QVERIFY(onOneDisk(folder.filePath(QStringLiteral("backups/not/there/yet")).toStdString(), site));
    if (!QFileInfo::exists(QStringLiteral("/dev/shm")) ||
        QStorageInfo(folder.path()) == QStorageInfo(QStringLiteral("/dev/shm")))
        QSKIP("there is no second file system here");
    QVERIFY(!onOneDisk("/dev/shm/backups", site));
}

void TestBackupSchedule::theDaysBackupIsMadeOnce() {
    QTemporaryDir folder;
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    auto database =
        database::Database::create(folder.filePath(QStringLiteral("site.db")).toStdString(), options);
    QVERIFY(database);
    const DailyWork first = backUpIfDue(**database, {}, nullptr);
    QVERIFY2(first.due && first.made, first.made ? "" : first.made.error().message.c_str());
    const auto listed = listBackups(defaultBackupFolder((*database)->file()));
    QCOMPARE(listed.size(), std::size_t{1});
    QVERIFY(listed.front().automatic && listed.front().folder == first.made->made.folder);
    QVERIFY(looksWhole(listed.front().folder, (*database)->file(), options));
    QVERIFY(!backUpIfDue(**database, {}, nullptr).due);
    QFile copy(QString::fromStdString(listed.front().folder + "/chiron.db"));
    QVERIFY(copy.open(QIODevice::ReadWrite) && copy.seek(copy.size() / 2) && copy.putChar('!'));
    copy.close();
    QCOMPARE(looksWhole(listed.front().folder, (*database)->file(), options).error().code,
             core::ErrorCode::doesNotHold);
}

/// Whoever looks through a folder for backups reads every manifest in it, /dev/zero among them.
void TestBackupSchedule::aDeviceIsNoManifest() {
    QTemporaryDir folder;
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    auto database =
        database::Database::create(folder.filePath(QStringLiteral("site.db")).toStdString(), options);
    QVERIFY(database);
    const DailyWork made = backUpIfDue(**database, {}, nullptr);
    QVERIFY2(made.made, made.made ? "" : made.made.error().message.c_str());
    const std::string backup = made.made->made.folder;
    const QString manifest = QString::fromStdString(backup + "/manifest.json");
    QVERIFY(QFile::remove(manifest) && QFile::link(QStringLiteral("/dev/zero"), manifest));
    QVERIFY(listBackups(defaultBackupFolder((*database)->file())).empty());
    const auto whole = looksWhole(backup, (*database)->file(), options);
    QVERIFY(!whole);
    QCOMPARE(whole.error().code, core::ErrorCode::badInput);
    const database::VerifyReport report = verifyBackup(backup, (*database)->file(), options);
    QVERIFY(!report.ok());
}

QTEST_GUILESS_MAIN(TestBackupSchedule)
#include "test_backup_schedule.moc"
