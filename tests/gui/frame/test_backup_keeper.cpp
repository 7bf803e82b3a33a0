// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/upkeep/upkeep.h"
#include "desktop/backups/backup_keeper.h"
#include "desktop/backups/exit_backup.h"
#include "desktop/screen_catalogue.h"
#include "session/backup_list.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QThread>
#include <QTimer>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;
using namespace std::chrono_literals;

namespace {

using tests::DesktopFixture;

/// A program that nobody touches.
struct Quiet {
    explicit Quiet(bool demonstration = false)
        : desktop(demonstration), keeper(*desktop.window->findChild<BackupKeeper*>()) {
        keeper.setQuiet(0);
    }

    std::vector<session::BackupEntry> backups() {
        return session::listBackups(session::defaultBackupFolder(desktop.file().toStdString()));
    }
    /// Looks, and waits for what comes of it.
    bool look() {
        keeper.look();
        return QTest::qWaitFor([this] { return !keeper.isRunning(); }, kPatience_ms);
    }
    void setPlan(const database::BackupPlan& plan) {
        const auto set =
            desktop.database().write([&, ada = desktop.actor("ada")](database::WriteContext& writing) {
                return database::Upkeep::setBackupPlan(writing.connection(), ada, plan);
            });
        QVERIFY(set);
    }
    /// Every worker is taken, until the semaphore is released: what is begun meanwhile waits.
    std::shared_ptr<QSemaphore> hold() {
        const auto gate = std::make_shared<QSemaphore>();
        for (int i = 0; i < QThread::idealThreadCount(); ++i)
            desktop.context.background().run(
                &desktop.context, [gate](WorkToken&) { return gate->tryAcquire(1, 60'000); }, [](bool) {});
        return gate;
    }
    static void release(const std::shared_ptr<QSemaphore>& gate) {
        gate->release(QThread::idealThreadCount());
    }

    DesktopFixture desktop;
    BackupKeeper& keeper;
};

/// What the program said.
struct Told {
    explicit Told(Quiet& quiet) {
        QObject::connect(&quiet.desktop.context.messages(), &Messages::told, &quiet.keeper,
                         [this](const Message& message) { said.push_back(message); });
    }
    std::vector<Message> said;
};

} // namespace

/// The day's backup by itself: when it is made, and when it is not.
class TestBackupKeeper : public QObject {
    Q_OBJECT
private slots:
    void isMadeOnceADayWhereNobodyWorks();
    void isNotMadeWhereItIsOff();
    void waitsForQuiet();
    void leavesASittingAlone();
    void stopsForASitting();
    void aFailureIsToldAndTriedAgain();
    void atTheEndWhatIsDueIsMade();
    void atTheEndItMayBeLeftOut();
};

void TestBackupKeeper::isMadeOnceADayWhereNobodyWorks() {
    Quiet quiet;
    QSignalSpy ended(&quiet.desktop.context, &AppContext::backupEnded);
    QVERIFY(quiet.look());
    QCOMPARE(ended.count(), 1);
    QCOMPARE(quiet.backups().size(), std::size_t{1});
    QVERIFY(quiet.backups().front().automatic);
    QVERIFY(session::looksWhole(quiet.backups().front().folder, quiet.desktop.file().toStdString(),
                                DesktopFixture::options()));
    QVERIFY(quiet.look());
    QCOMPARE(ended.count(), 1);
    QCOMPARE(quiet.backups().size(), std::size_t{1});
}

void TestBackupKeeper::isNotMadeWhereItIsOff() {
    Quiet quiet;
    quiet.setPlan({false, "", 14});
    QVERIFY(quiet.look());
    QVERIFY(quiet.backups().empty());
    Quiet shown(true); // a demonstration holds nobody's work
    QVERIFY(shown.look());
    QVERIFY(shown.backups().empty());
}

void TestBackupKeeper::waitsForQuiet() {
    Quiet quiet;
    quiet.keeper.setQuiet(BackupKeeper::kQuiet_ms);
    QTest::keyClick(quiet.desktop.window.get(), Qt::Key_Shift);
    quiet.keeper.look();
    QVERIFY(!quiet.keeper.isRunning());
}

void TestBackupKeeper::leavesASittingAlone() {
    for (const char* screen : {"training", "study_trials"})
        QVERIFY(findScreen(QLatin1String(screen))->sitting);
    QVERIFY(!findScreen(QStringLiteral("login"))->sitting);
    Quiet quiet;
    quiet.desktop.logIn("tina");
    quiet.desktop.context.setTrialRuns(true);
    quiet.keeper.look();
    QVERIFY(!quiet.keeper.isRunning());
    quiet.desktop.context.setTrialRuns(false);
    quiet.keeper.look();
    QVERIFY(quiet.keeper.isRunning());
}

void TestBackupKeeper::stopsForASitting() {
    Quiet quiet;
    Told told(quiet);
    quiet.desktop.logIn("ada");
    const auto gate = quiet.hold();
    quiet.keeper.look();
    QVERIFY(quiet.keeper.isRunning());
    quiet.desktop.context.setTrialRuns(true);
    Quiet::release(gate);
    QTRY_VERIFY_WITH_TIMEOUT(!quiet.keeper.isRunning(), kPatience_ms);
    QVERIFY(quiet.backups().empty() && told.said.empty());
    quiet.desktop.context.setTrialRuns(false);
    QVERIFY(quiet.look()); // afterwards, without waiting as after a failure
    QCOMPARE(quiet.backups().size(), std::size_t{1});
}

void TestBackupKeeper::aFailureIsToldAndTriedAgain() {
    Quiet quiet;
    Told told(quiet);
    std::vector<int> asked;
    auto wait = std::chrono::milliseconds(1h);
    quiet.keeper.setWaits([&](int failures) {
        asked.push_back(failures);
        return wait;
    });
    quiet.setPlan({true, "/proc/chiron/backups", 14});
    quiet.desktop.logIn("tina");
    QVERIFY(quiet.look());
    QVERIFY(told.said.empty()); // not her business
    quiet.desktop.logIn("ada");
    quiet.keeper.look();
    QVERIFY(!quiet.keeper.isRunning()); // not yet
    wait = 0ms;
    QVERIFY(quiet.look());
    QCOMPARE(told.said.size(), std::size_t{1});
    QCOMPARE(told.said.front().kind, MessageKind::warning);
    QVERIFY(told.said.front().text.contains(QStringLiteral("/proc/chiron")));
    QCOMPARE(asked.back(), 1);
    quiet.setPlan({true, "", 14});
    QVERIFY(quiet.look());
    QCOMPARE(asked.back(), 2);
    QCOMPARE(quiet.backups().size(), std::size_t{1});
}

void TestBackupKeeper::atTheEndWhatIsDueIsMade() {
    Quiet quiet;
    backUpAtExit(quiet.desktop.context);
    QCOMPARE(quiet.backups().size(), std::size_t{1});
    backUpAtExit(quiet.desktop.context);
    QCOMPARE(quiet.backups().size(), std::size_t{1});
    quiet.desktop.context.background().cancelAndWait();
    quiet.desktop.site.close();
    backUpAtExit(quiet.desktop.context); // nothing is open: nothing to do
}

void TestBackupKeeper::atTheEndItMayBeLeftOut() {
    Quiet quiet;
    const auto gate = quiet.hold();
    QTimer look;
    bool seen = false;
    connect(&look, &QTimer::timeout, this, [&] {
        if (auto* button = quiet.desktop.find<QPushButton>(QStringLiteral("exit_backup.leave_out"));
            button && button->isVisible() && !seen) {
            seen = true;
            button->click();
            Quiet::release(gate);
        }
    });
    look.start(20);
    backUpAtExit(quiet.desktop.context);
    QVERIFY(seen && quiet.backups().empty());
    QVERIFY(!quiet.desktop.find<QPushButton>(QStringLiteral("exit_backup.leave_out")));
}

QTEST_MAIN(TestBackupKeeper)
#include "test_backup_keeper.moc"
