// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/audit/site_key.h"
#include "database/query.h"
#include "database/repositories/audit_repository.h"
#include "database/upkeep/manifest.h"
#include "database/upkeep/upkeep.h"

#include <QDir>
#include <QFile>
#include <atomic>
#include <csignal>
#include <sys/mount.h>
#include <sys/resource.h>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

const Actor kProgram = Actor::maintenance();

BackupStanding standingOf(DatabaseFixture& f) {
    const auto reader = f.database->openReader();
    return Upkeep::backupStanding(**reader, kProgram).value();
}

QStringList foldersIn(const std::string& place) {
    return QDir(QString::fromStdString(place)).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
}

core::Result<void> setPlan(DatabaseFixture& f, const Actor& actor, const BackupPlan& plan) {
    return f.database->write(
        [&](WriteContext& w) { return Upkeep::setBackupPlan(w.connection(), actor, plan); });
}

QString prefixOf(DatabaseFixture& f) {
    return QStringLiteral("chiron-auto-") + QString::fromStdString(f.database->uuid()).left(8) +
           QLatin1Char('-');
}

} // namespace

/// The schedule's backups: what is planned, what is kept, and what a failure leaves.
class TestDailyBackup : public QObject {
    Q_OBJECT
private slots:
    void aSiteHasAPlanFromTheBeginning();
    void thePlanIsAnAdministrators();
    void whatIsMadeIsWholeAndNoted();
    void olderOnesGoAndNoOthers();
    void theNumberTellsWhatIsOlder();
    void whatAKillLeftIsNoBackupAndGoes();
    void aFailureIsNotedAndLeavesNothing_data();
    void aFailureIsNotedAndLeavesNothing();
    void aFullDiskLeavesNothing();
    void tooLittleRoomIsToldBeforehand();
    void whatIsStoppedIsNoFailure();
    void aRestoreTakesOne();
};

void TestDailyBackup::aSiteHasAPlanFromTheBeginning() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const BackupStanding standing = standingOf(f);
    QVERIFY(standing.plan == (BackupPlan{true, "", 14}));
    QVERIFY(standing.triedUtc.empty() && standing.goodUtc.empty() && standing.problem.empty());
    DatabaseFixture shown;
    shown.options.demonstration = true;
    REQUIRE(shown.create());
    QVERIFY(!standingOf(shown).plan.on);
}

void TestDailyBackup::thePlanIsAnAdministrators() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tina = f.person(*ada, "tina", {Role::trainee});
    REQUIRE(setPlan(f, *ada, {false, "/media/backup", 3}));
    QCOMPARE(setPlan(f, *tina, {true, "", 9}).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(setPlan(f, kProgram, {true, "", 9}).error().code, core::ErrorCode::notAllowed);
    for (const int keep : {0, -1, kMostBackupsKept + 1})
        QCOMPARE(setPlan(f, *ada, {true, "", keep}).error().code, core::ErrorCode::badInput);
    for (const int keep : {1, kMostBackupsKept, 3})
        REQUIRE(setPlan(f, *ada, {false, "/media/backup", keep}));
    auto reader = f.database->openReader();
    QCOMPARE(Upkeep::backupStanding(**reader, *tina).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(AuditRepository(**reader, *ada).listAudit(1)->front().action, std::string("setBackupPlan"));
    reader->reset();
    REQUIRE(f.reopen());
    QVERIFY(standingOf(f).plan == (BackupPlan{false, "/media/backup", 3}));
    QCOMPARE(Upkeep::dailyBackup(*f.database, *ada, f.path("b"), 3).error().code,
             core::ErrorCode::notAllowed); // the schedule's alone
    const auto made = [&](int keep) { return Upkeep::dailyBackup(*f.database, kProgram, f.path("b"), keep); };
    QCOMPARE(made(0).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(made(kMostBackupsKept + 1).error().code, core::ErrorCode::wrongUse);
    REQUIRE(made(1));
    REQUIRE(made(kMostBackupsKept));
}

void TestDailyBackup::whatIsMadeIsWholeAndNoted() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    const auto key = SiteKey::load(f.database->siteFolder());
    for (const std::int64_t number : {1, 2}) {
        const auto done = Upkeep::dailyBackup(*f.database, kProgram, f.path("place"), 14);
        REQUIRE(done);
        QCOMPARE(done->removed, 0);
        const auto manifest = readManifest(done->made.folder, **key);
        REQUIRE(manifest);
        QCOMPARE(manifest->automaticNumber, number);
        const BackupStanding standing = standingOf(f);
        QVERIFY(!standing.goodUtc.empty() && standing.triedUtc == standing.goodUtc &&
                standing.problem.empty());
        QCOMPARE(standing.goodFolder, done->made.folder);
        QCOMPARE(standing.goodBytes, done->made.bytes);
    }
    QCOMPARE(foldersIn(f.path("place")).size(), 2);
    auto reader = f.database->openReader();
    QCOMPARE(AuditRepository(**reader, *ada).listAudit(1)->front().action, std::string("dailyBackup"));
    REQUIRE(Upkeep::backup(*f.database, *ada, f.path("by_hand")));
    QCOMPARE(readManifest(f.path("by_hand"), **key)->automaticNumber, std::int64_t{0});
    QVERIFY(!contentOf(f.path("by_hand") + "/manifest.json").contains("automatic_number"));
}

void TestDailyBackup::olderOnesGoAndNoOthers() {
    DatabaseFixture f, other;
    REQUIRE(f.create());
    REQUIRE(other.create());
    const auto ada = f.administrator();
    const std::string place = f.path("place");
    REQUIRE(Upkeep::dailyBackup(*other.database, kProgram, place, 1));
    REQUIRE(Upkeep::backup(*f.database, *ada,
                           place + "/" + prefixOf(f).toStdString() + "by-hand")); // named as the schedule's
    QVERIFY(QDir().mkpath(QString::fromStdString(place) + "/" + prefixOf(f) + "notes")); // no backup at all
    const QStringList others = foldersIn(place);
    std::string last;
    for (int i = 0; i < 5; ++i) {
        const auto done = Upkeep::dailyBackup(*f.database, kProgram, place, 2);
        REQUIRE(done);
        QCOMPARE(done->removed, i < 2 ? 0 : 1);
        last = done->made.folder;
    }
    const QStringList now = foldersIn(place);
    QCOMPARE(now.size(), others.size() + 2);
    for (const QString& name : others)
        QVERIFY2(now.contains(name), qPrintable(name));
    QVERIFY(QFile::exists(QString::fromStdString(last)));
    QCOMPARE(Upkeep::dailyBackup(*f.database, kProgram, place, 1)->removed, 2); // fewer are wanted now
}

// A clock that was wrong gave the oldest one the latest name and date.
void TestDailyBackup::theNumberTellsWhatIsOlder() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const std::string place = f.path("place");
    const auto first = Upkeep::dailyBackup(*f.database, kProgram, place, 14);
    REQUIRE(first);
    const QString future = QString::fromStdString(place) + "/" + prefixOf(f) + "29991231-000000";
    QVERIFY(QDir().rename(QString::fromStdString(first->made.folder), future));
    const auto second = Upkeep::dailyBackup(*f.database, kProgram, place, 14);
    const auto third = Upkeep::dailyBackup(*f.database, kProgram, place, 2);
    REQUIRE(third);
    QVERIFY(!QFile::exists(future));
    QVERIFY(QFile::exists(QString::fromStdString(second->made.folder)));
}

void TestDailyBackup::whatAKillLeftIsNoBackupAndGoes() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const std::string place = f.path("place");
    REQUIRE(Upkeep::dailyBackup(*f.database, kProgram, place, 14));
    const QString whole = foldersIn(place).front();
    for (const char* ending : {".partial", ".removing"}) {
        const QString half =
            QString::fromStdString(place) + "/" + prefixOf(f) + "20200101-000000" + QLatin1String(ending);
        QVERIFY(QDir().mkpath(half) &&
                QFile::copy(QString::fromStdString(place) + "/" + whole + "/chiron.db", half + "/chiron.db"));
    }
    QVERIFY(QDir().mkpath(QString::fromStdString(place) +
                          "/chiron-auto-another0-20200101-000000.partial")); // another site's, under way
    REQUIRE(Upkeep::dailyBackup(*f.database, kProgram, place, 14));
    const QStringList now = foldersIn(place);
    QCOMPARE(now.size(), 3);
    QVERIFY(now.contains(whole) &&
            now.contains(QStringLiteral("chiron-auto-another0-20200101-000000.partial")));
}

void TestDailyBackup::aFailureIsNotedAndLeavesNothing_data() {
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"a file in the way", "a folder that cannot be made", "damaged content"})
        QTest::newRow(kind) << QString::fromLatin1(kind);
}

void TestDailyBackup::aFailureIsNotedAndLeavesNothing() {
    QFETCH(QString, kind);
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    REQUIRE(Upkeep::dailyBackup(*f.database, kProgram, f.path("place"), 14));
    const BackupStanding before = standingOf(f);
    std::string place = f.path("place");
    if (kind.startsWith(QLatin1String("a file"))) {
        place = f.path("taken");
        QFile file(QString::fromStdString(place));
        QVERIFY(file.open(QIODevice::WriteOnly));
    } else if (kind.startsWith(QLatin1String("a folder"))) {
        place = "/proc/chiron/backups"; // nobody writes there, not even root
    } else {
        REQUIRE(f.database->write([](WriteContext& w) {
            return w.connection().execute("UPDATE chunk SET payload = zeroblob(700) WHERE id = 2");
        }));
    }
    const auto failed = Upkeep::dailyBackup(*f.database, kProgram, place, 14);
    QVERIFY(!failed);
    const BackupStanding after = standingOf(f);
    QCOMPARE(after.problem, failed.error().message);
    QVERIFY(!after.triedUtc.empty() && after.goodUtc == before.goodUtc &&
            after.goodFolder == before.goodFolder);
    QCOMPARE(foldersIn(f.path("place")).size(), 1);
}

void TestDailyBackup::aFullDiskLeavesNothing() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    for (int i = 0; i < 3; ++i)
        REQUIRE(storeSession(*f.database, *ada, 60, 20'000));
    REQUIRE(f.reopen()); // its log is empty: the failure can be noted
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &old), 0);
    rlimit small = old;
    small.rlim_cur = 1'000'000; // less than the copy needs
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto failed = Upkeep::dailyBackup(*f.database, kProgram, f.path("place"), 14);
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &old), 0);
    QVERIFY(!failed && failed.error().code == core::ErrorCode::storage);
    QVERIFY(foldersIn(f.path("place")).isEmpty());
    QCOMPARE(standingOf(f).problem, failed.error().message);
    REQUIRE(Upkeep::dailyBackup(*f.database, kProgram, f.path("place"), 14)); // room again
    QVERIFY(standingOf(f).problem.empty());
}

void TestDailyBackup::tooLittleRoomIsToldBeforehand() {
    QTemporaryDir tiny;
    const QByteArray path = tiny.path().toLocal8Bit();
    if (mount("tmpfs", path.constData(), "tmpfs", 0, "size=2m") != 0)
        QSKIP("mounting is not permitted here");
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto failed = Upkeep::dailyBackup(*f.database, kProgram, path.toStdString(), 14);
    QCOMPARE(umount2(path.constData(), MNT_DETACH), 0);
    QVERIFY(!failed && failed.error().code == core::ErrorCode::storage);
    QVERIFY2(failed.error().message.find("too little room, 17 MB needed") != std::string::npos,
             failed.error().message.c_str()); // 16 MB to spare, and the file itself
}

void TestDailyBackup::whatIsStoppedIsNoFailure() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const std::atomic<bool> stop = true;
    const auto stopped = Upkeep::dailyBackup(*f.database, kProgram, f.path("place"), 14, &stop);
    QCOMPARE(stopped.error().code, core::ErrorCode::cancelled);
    QVERIFY(foldersIn(f.path("place")).isEmpty());
    QVERIFY(standingOf(f).triedUtc.empty());
}

void TestDailyBackup::aRestoreTakesOne() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(storeSession(*f.database, *ada));
    const auto done = Upkeep::dailyBackup(*f.database, kProgram, f.path("place"), 14);
    REQUIRE(done);
    REQUIRE(storeSession(*f.database, *ada));
    f.database.reset();
    REQUIRE(Upkeep::restore(requestFor(f, done->made.folder), f.options));
    REQUIRE(f.reopen());
    auto reader = f.database->openReader();
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM session")->value_or(0), std::int64_t{1});
    const auto next = Upkeep::dailyBackup(*f.database, kProgram, f.path("place"),
                                          1); // the numbers go on where the folder is
    REQUIRE(next);
    QCOMPARE(next->removed, 1);
    QVERIFY(QFile::exists(QString::fromStdString(next->made.folder)));
}

QTEST_GUILESS_MAIN(TestDailyBackup)
#include "test_daily_backup.moc"
