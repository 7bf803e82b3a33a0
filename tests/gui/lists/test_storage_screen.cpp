// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_reader.h"
#include "desktop/storage/storage_screen.h"
#include "desktop/widgets/state_panel.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QThread>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;

namespace {

using tests::DesktopFixture;

StorageScreen* openStorage(DesktopFixture& desktop) {
    desktop.logIn("ada");
    desktop.go(QStringLiteral("storage"));
    auto* screen = desktop.screen<StorageScreen>();
    auto* panel = screen->findChild<StatePanel*>();
    return QTest::qWaitFor([panel] { return panel->state() == StatePanel::State::content; }, kPatience_ms)
               ? screen
               : nullptr;
}

/// Presses a button that begins a task, and waits for the task's end.
bool runTask(StorageScreen* screen, const char* button) {
    QSignalSpy ended(screen, &StorageScreen::taskEnded);
    auto* found = screen->findChild<QPushButton*>(QLatin1String(button));
    if (!found || !found->isEnabled())
        return false;
    found->click();
    return QTest::qWaitFor([&ended] { return ended.count() == 1; }, kPatience_ms);
}

int sessionsOf(DesktopFixture& desktop) {
    auto reader = desktop.database().openReader();
    const auto list = database::SessionReader(**reader, desktop.actor("ada")).listSessions();
    return list ? static_cast<int>(list->size()) : -1;
}

QString noticeOf(QWidget* parent, const char* name) {
    auto* frame = parent->findChild<QFrame*>(QLatin1String(name));
    auto* words = frame ? frame->findChild<QLabel*>(QStringLiteral("notice.text")) : nullptr;
    return words ? words->text() : QString();
}

} // namespace

namespace {

database::BackupPlan planOf(DesktopFixture& desktop) {
    auto reader = desktop.database().openReader();
    return database::Upkeep::backupStanding(**reader, database::Actor::maintenance()).value().plan;
}

} // namespace

/// Backup, check, damage, restore: through the screen.
class TestStorageScreen : public QObject {
    Q_OBJECT
private slots:
    void backsUpAndChecks() {
        DesktopFixture desktop;
        desktop.addSession("tina", 1, "expert", 1, 1, 5.0);
        auto* screen = openStorage(desktop);
        QVERIFY(screen);
        QVERIFY(noticeOf(screen, "storage.backup_notice").contains(QStringLiteral("no backup")));
        QVERIFY(!screen->findChild<QPushButton*>(QStringLiteral("storage.restore"))->isEnabled());
        QVERIFY(runTask(screen, "storage.back_up"));
        auto* table = screen->findChild<QTableWidget*>(QStringLiteral("storage.backups"));
        QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(
            noticeOf(screen, "storage.backup_notice").contains(QStringLiteral("just now")), kPatience_ms);
        QVERIFY(runTask(screen, "storage.verify_backup"));
        QVERIFY(table->item(0, 3)->text().contains(QStringLiteral("intact")));
        QVERIFY(runTask(screen, "storage.verify"));
        QVERIFY(noticeOf(screen, "storage.report").startsWith(QStringLiteral("No errors were found")));
    }

    void damageIsFoundAndNamed() {
        DesktopFixture desktop;
        const auto id = desktop.addSession("tina", 1, "expert", 1, 1, 5.0);
        QVERIFY(desktop.database().write([id](database::WriteContext& writing) {
            return writing.connection().execute("UPDATE session SET level = 3 WHERE id = " +
                                                std::to_string(id));
        }));
        auto* screen = openStorage(desktop);
        QVERIFY(screen);
        QVERIFY(runTask(screen, "storage.verify"));
        auto* findings = screen->findChild<QTableWidget*>(QStringLiteral("storage.findings"));
        QVERIFY(findings->isVisibleTo(screen) && findings->rowCount() >= 1);
        QCOMPARE(findings->item(0, 0)->text(), QStringLiteral("A record was changed"));
        QVERIFY(findings->item(0, 1)->text().contains(QStringLiteral("session")));
    }

    void verifyingIsStopped() {
        DesktopFixture desktop;
        for (unsigned i = 1; i <= 4; ++i)
            desktop.addSession("tina", 1, "expert", i, 2, 20.0);
        auto* screen = openStorage(desktop);
        QVERIFY(screen);
        QSignalSpy ended(screen, &StorageScreen::taskEnded);
        const auto later = std::make_shared<QSemaphore>(); // it must not be done before it is stopped
        const int workers = QThread::idealThreadCount();
        for (int i = 0; i < workers; ++i)
            desktop.context.background().run(
                &desktop.context, [later](WorkToken&) { return later->tryAcquire(1, 60'000); }, [](bool) {});
        screen->findChild<QPushButton*>(QStringLiteral("storage.verify"))->click();
        QVERIFY(!screen->findChild<QPushButton*>(QStringLiteral("storage.back_up"))
                     ->isEnabled()); // one task at a time
        screen->findChild<QPushButton*>(QStringLiteral("task.cancel"))->click();
        later->release(workers);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience_ms);
        QVERIFY(noticeOf(screen, "storage.report").contains(QStringLiteral("stopped")));
    }

    void automaticBackupsAreSetHere() {
        DesktopFixture desktop;
        auto* screen = openStorage(desktop);
        QVERIFY(screen);
        QVERIFY(noticeOf(screen, "storage.automatic_notice")
                    .startsWith(QStringLiteral("The first automatic backup")));
        QVERIFY(noticeOf(screen, "storage.same_disk")
                    .contains(QStringLiteral("same disk"))); // beside the site, as long as nobody chose
        auto* on = screen->findChild<QCheckBox*>(QStringLiteral("storage.automatic"));
        auto* keep = screen->findChild<QSpinBox*>(QStringLiteral("storage.keep"));
        QVERIFY(on->isChecked() && keep->value() == 14);
        keep->setValue(3);
        QTRY_COMPARE_WITH_TIMEOUT(planOf(desktop).keep, 3, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.context.background().idle(), kPatience_ms);
        screen->findChild<QPushButton*>(QStringLiteral("storage.choose"))->click();
        auto* dialog = screen->findChild<QFileDialog*>();
        const QString elsewhere = desktop.folder() + QStringLiteral("/elsewhere");
        emit dialog->fileSelected(elsewhere);
        dialog->close();
        QTRY_COMPARE_WITH_TIMEOUT(planOf(desktop).folder, elsewhere.toStdString(), kPatience_ms);
        QCOMPARE(desktop.settings.backupFolder(),
                 elsewhere); // where the site cannot be opened, the station knows it
        QTRY_VERIFY_WITH_TIMEOUT(desktop.context.background().idle(), kPatience_ms);
        on->click();
        QTRY_VERIFY_WITH_TIMEOUT(!planOf(desktop).on, kPatience_ms);
        QVERIFY(planOf(desktop) == (database::BackupPlan{false, elsewhere.toStdString(), 3}));
        QTRY_VERIFY_WITH_TIMEOUT(noticeOf(screen, "storage.automatic_notice")
                                     .startsWith(QStringLiteral("Automatic backups are off")),
                                 kPatience_ms);
        QVERIFY(!keep->isEnabled());
    }

    void howTheScheduleGoesIsTold() {
        DesktopFixture desktop;
        auto* screen = openStorage(desktop);
        QVERIFY(screen);
        const database::Actor program = database::Actor::maintenance();
        const auto make = [&](const QString& place) {
            const auto done =
                database::Upkeep::dailyBackup(desktop.database(), program, place.toStdString(), 14);
            emit desktop.context.backupEnded();
            return done.has_value();
        };
        QVERIFY(make(desktop.folder() + QStringLiteral("/backups")));
        auto* table = screen->findChild<QTableWidget*>(QStringLiteral("storage.backups"));
        QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, kPatience_ms);
        QCOMPARE(table->item(0, 4)->text(), QStringLiteral("Automatic"));
        const QString told = noticeOf(screen, "storage.automatic_notice");
        QVERIFY2(
            told.contains(QStringLiteral("made and checked")) &&
                told.contains(desktop.context.locale().toString(QDate::currentDate(), QLocale::ShortFormat)),
            qPrintable(told));
        QVERIFY(!make(QStringLiteral("/proc/chiron/backups")));
        QTRY_VERIFY_WITH_TIMEOUT(
            noticeOf(screen, "storage.automatic_notice").contains(QStringLiteral("/proc/chiron")),
            kPatience_ms);
        desktop.go(QStringLiteral("home")); // and where the administrator begins
        const auto saysSo = [&desktop] {
            for (const QLabel* label :
                 desktop.window->screen()->findChildren<QLabel*>(QStringLiteral("notice.text")))
                if (label->text().contains(QStringLiteral("An automatic backup failed")))
                    return true;
            return false;
        };
        QTRY_VERIFY_WITH_TIMEOUT(saysSo(), kPatience_ms);
        QVERIFY(make(desktop.folder() + QStringLiteral("/backups")));
        desktop.go(QStringLiteral("storage"));
        desktop.go(QStringLiteral("home"));
        QTRY_VERIFY_WITH_TIMEOUT(desktop.context.background().idle(), kPatience_ms);
        QVERIFY(!saysSo());
    }

    /// A backup from before the password was changed: it is said which one is missing, and what was typed
    /// stays.
    void aBackupUnderAnotherPasswordAsksForIt() {
        DesktopFixture desktop;
        auto* screen = openStorage(desktop);
        QVERIFY(screen && runTask(screen, "storage.back_up"));
        QVERIFY(database::AccountService(desktop.database())
                    .changePassword(desktop.actor("ada"), tests::kTestPassword, "quite another word"));
        QTRY_VERIFY_WITH_TIMEOUT(
            screen->findChild<QPushButton*>(QStringLiteral("storage.restore"))->isEnabled(), kPatience_ms);
        screen->findChild<QPushButton*>(QStringLiteral("storage.restore"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLineEdit>(QStringLiteral("restore.password")), kPatience_ms);
        desktop.find<QLineEdit>(QStringLiteral("restore.password"))
            ->setText(QStringLiteral("quite another word"));
        desktop.find<QPushButton>(QStringLiteral("restore.accept"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QCheckBox>(QStringLiteral("restore.other"))->isChecked(),
                                 kPatience_ms);
        QCOMPARE(desktop.find<QLineEdit>(QStringLiteral("restore.password"))->text(),
                 QStringLiteral("quite another word"));
        QVERIFY(desktop.find<QLabel>(QStringLiteral("restore.other_explanation"))->isVisible() &&
                desktop.find<QLabel>(QStringLiteral("restore.other_explanation"))
                    ->text()
                    .contains(QStringLiteral("the day it was made")));
        QVERIFY(desktop.find<QLineEdit>(QStringLiteral("restore.other_password"))->isVisible() &&
                !desktop.find<QPushButton>(QStringLiteral("restore.accept"))->isEnabled());
        desktop.find<QLineEdit>(QStringLiteral("restore.other_name"))->setText(QStringLiteral("ada"));
        desktop.find<QLineEdit>(QStringLiteral("restore.other_password"))
            ->setText(QStringLiteral("not this word"));
        desktop.find<QPushButton>(QStringLiteral("restore.accept"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(
            desktop.find<QLabel>(QStringLiteral("restore.other_password.note"))->isVisible(), kPatience_ms);
        QVERIFY(!desktop.find<QLabel>(QStringLiteral("restore.password.note"))->isVisible());
        QSignalSpy opened(&desktop.context, &AppContext::siteOpened);
        desktop.find<QLineEdit>(QStringLiteral("restore.other_password"))
            ->setText(QString::fromLatin1(tests::kTestPassword));
        desktop.find<QPushButton>(QStringLiteral("restore.accept"))->click();
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatience_ms);
        QVERIFY(database::AccountService(desktop.database()).login("ada", tests::kTestPassword));
    }

    void goesBackToABackup() {
        DesktopFixture desktop;
        desktop.addSession("tina", 1, "expert", 1, 1, 5.0);
        auto* screen = openStorage(desktop);
        QVERIFY(screen && runTask(screen, "storage.back_up"));
        desktop.addSession("tina", 1, "expert", 2, 1, 5.0);
        QCOMPARE(sessionsOf(desktop), 2);
        QTRY_VERIFY_WITH_TIMEOUT(
            screen->findChild<QPushButton*>(QStringLiteral("storage.restore"))->isEnabled(), kPatience_ms);

        const auto answer = [&desktop, screen](const char* password) {
            screen->findChild<QPushButton*>(QStringLiteral("storage.restore"))->click();
            auto* field = desktop.find<QLineEdit>(QStringLiteral("restore.password"));
            auto* confirm = desktop.find<QPushButton>(QStringLiteral("restore.accept"));
            QVERIFY(field && confirm && !confirm->isEnabled());
            QTest::keyClicks(field, QLatin1String(password));
            QTest::mouseClick(confirm, Qt::LeftButton);
        };
        screen->findChild<QPushButton*>(QStringLiteral("storage.restore"))
            ->click(); // where two administrators are asked for, each field has its room
        auto* dialog = desktop.find<QDialog>(QStringLiteral("restore"));
        QVERIFY(dialog);
        for (const bool both : {true, false}) {
            desktop.find<QCheckBox>(QStringLiteral("restore.other"))->setChecked(both);
            QTest::qWait(50);
            int lowest = 0;
            for (const char* name :
                 {"restore.name", "restore.password", "restore.other_name", "restore.other_password"}) {
                const auto* part = dialog->findChild<QWidget*>(QLatin1String(name));
                if (!part->isVisible())
                    continue;
                QVERIFY2(part->mapTo(dialog, QPoint()).y() >= lowest &&
                             part->height() > part->fontMetrics().height() + 8,
                         qPrintable(QStringLiteral("%1: %2 px, of %3")
                                        .arg(QLatin1String(name))
                                        .arg(part->height())
                                        .arg(part->sizeHint().height())));
                lowest = part->mapTo(dialog, QPoint(0, part->height())).y();
            }
            const auto* confirm = dialog->findChild<QWidget*>(
                QStringLiteral("restore.accept")); // below the page, which scrolls
            QVERIFY(confirm->isVisible() &&
                    dialog->rect().contains(QRect(confirm->mapTo(dialog, QPoint()), confirm->size())));
        }
        dialog->reject();
        QTRY_VERIFY_WITH_TIMEOUT(!desktop.find<QDialog>(QStringLiteral("restore")), kPatience_ms);
        QSignalSpy ended(screen, &StorageScreen::taskEnded);
        const int chosen = screen->findChild<QTableWidget*>(QStringLiteral("storage.backups"))->currentRow();
        answer("wrong-password-here");
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLabel>(QStringLiteral("restore.password.note"))->isVisible(),
                                 kPatience_ms);
        QCOMPARE(desktop.find<QLabel>(QStringLiteral("restore.password.note"))->text(),
                 QStringLiteral("Wrong password. Passwords are case-sensitive."));
        QVERIFY(desktop.find<QDialog>(QStringLiteral("restore"))
                    ->isVisible()); // still open, and nothing was closed for it
        QVERIFY(desktop.site.isOpen() && screen->mayLeave());
        QCOMPARE(ended.count(), 0);
        QCOMPARE(screen->findChild<QTableWidget*>(QStringLiteral("storage.backups"))->currentRow(), chosen);
        QCOMPARE(sessionsOf(desktop), 2); // as it was
        desktop.find<QPushButton>(QStringLiteral("restore.cancel"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(!desktop.find<QDialog>(QStringLiteral("restore")), kPatience_ms);

        QSignalSpy opened(&desktop.context, &AppContext::siteOpened);
        answer(tests::kTestPassword);
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatience_ms);
        QCOMPARE(desktop.context.navigator().current().screen, QStringLiteral("login"));
        QVERIFY(!desktop.context.loggedIn());
        QCOMPARE(sessionsOf(desktop), 1);
        QCOMPARE(QDir(desktop.folder())
                     .entryList({QStringLiteral("test.db.before-restore*")}, QDir::Files)
                     .filter(QStringLiteral("restore"))
                     .isEmpty(),
                 false);
    }
};

QTEST_MAIN(TestStorageScreen)
#include "test_storage_screen.moc"
