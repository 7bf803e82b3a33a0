// SPDX-License-Identifier: GPL-3.0-or-later
#include "hands.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"

#include "desktop/accounts/notice_area.h"
#include "desktop/lock/lock_controller.h"

#include <QDialog>
#include <QLabel>

using namespace chiron;
using namespace chiron::tests;

/// The lock: when idle, never while a trial runs, and what it keeps from those who are not meant.
class TestLock : public QObject {
    Q_OBJECT
private slots:
    void idleLocksAndThePasswordUnlocks();
    void activityKeepsItOpen();
    void neverWhileATrialRuns();
    void nobodyLoggedInNothingToLock();
    void lockedWindowCannotBeReached();
    void anotherWindowIsHidden();
    void wrongPasswordsWait();
    void switchUserAsksNobody();
    void fitsAtEveryScale();

private:
    static desktop::LockController& lockOf(DesktopFixture& desktop) {
        return *desktop.window->findChild<desktop::LockController*>();
    }
    static void unlock(DesktopFixture& desktop) {
        desktop.find<QLineEdit>(QStringLiteral("lock.password"))->setText(QLatin1String(kTestPassword));
        desktop.find<QPushButton>(QStringLiteral("lock.unlock"))->click();
    }
};

void TestLock::idleLocksAndThePasswordUnlocks() {
    DesktopFixture desktop;
    desktop.logIn("tina");
    desktop.go(QStringLiteral("settings"));
    settle();
    auto& lock = lockOf(desktop);
    QVERIFY(!lock.isLocked());
    QCOMPARE(desktop::IdleLock::kIdle_ms, 600'000); // ten minutes, as the documents say
    lock.idleLock().setIdle(200);
    QTRY_VERIFY_WITH_TIMEOUT(lock.isLocked(), kPatience_ms);
    QVERIFY(!desktop.window->centralWidget()->isVisible());
    QVERIFY(!desktop.window->windowTitle().contains(QStringLiteral("Settings")));
    picture(desktop.window.get(), QStringLiteral("lock"));
    lock.idleLock().setIdle(desktop::IdleLock::kIdle_ms);
    type(QLatin1String(kTestPassword)); // the field has the focus
    press(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(!lock.isLocked(), kPatience_ms);
    QVERIFY(desktop.window->centralWidget()->isVisible());
    QVERIFY(desktop.window->windowTitle().contains(QStringLiteral("Settings")));
    QCOMPARE(desktop.context.navigator().current().screen, QStringLiteral("settings")); // where it was
}

void TestLock::activityKeepsItOpen() {
    DesktopFixture desktop;
    desktop.logIn("tina");
    settle();
    auto& lock = lockOf(desktop);
    lock.idleLock().setIdle(2000);
    for (int i = 0; i < 60; ++i) { // three seconds, longer than it would take
        QTest::qWait(50);
        if (i % 3 == 0)
            desktop.context.touch(); // a device
        else if (i % 3 == 1)
            QTest::keyClick(desktop.window.get(), Qt::Key_Shift);
        else
            QTest::mouseMove(desktop.window.get(), QPoint(50 + i, 50));
    }
    QVERIFY(!lock.isLocked());
    QTRY_VERIFY_WITH_TIMEOUT(lock.isLocked(), kPatience_ms);
}

void TestLock::neverWhileATrialRuns() {
    DesktopFixture desktop;
    desktop.logIn("tina");
    settle();
    auto& lock = lockOf(desktop);
    QSignalSpy idle(&lock.idleLock(), &desktop::IdleLock::idle);
    desktop.context.setTrialRuns(true);
    lock.idleLock().setIdle(50);
    emit desktop.context.lockAsked();
    QTest::qWait(500);
    QVERIFY(!lock.isLocked() && idle.isEmpty()); // not even noticed
    desktop.context.setTrialRuns(false);
    QTRY_VERIFY_WITH_TIMEOUT(lock.isLocked(), kPatience_ms);
}

void TestLock::nobodyLoggedInNothingToLock() {
    DesktopFixture desktop;
    auto& lock = lockOf(desktop);
    lock.idleLock().setIdle(50);
    emit desktop.context.lockAsked();
    QTest::qWait(300);
    QVERIFY(!lock.isLocked());
}

void TestLock::lockedWindowCannotBeReached() {
    DesktopFixture desktop;
    desktop.logIn("tina");
    desktop.go(QStringLiteral("settings"));
    settle();
    auto& lock = lockOf(desktop);
    press(Qt::Key_L, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(lock.isLocked(), kPatience_ms);
    const auto windows = [] {
        int count = 0;
        for (const QWidget* top : QApplication::topLevelWidgets())
            count += top->isVisible() ? 1 : 0;
        return count;
    };
    QCOMPARE(windows(), 1);
    struct Keys {
        Qt::Key key;
        Qt::KeyboardModifiers modifiers;
    };
    for (const auto& [key, modifier] :
         {Keys{Qt::Key_K, Qt::ControlModifier}, Keys{Qt::Key_F1, {}}, Keys{Qt::Key_1, Qt::ControlModifier},
          Keys{Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier}}) {
        press(key, modifier);
        QTest::keyClick(desktop.window.get(), key, modifier);
        QTest::qWait(20);
    }
    QCOMPARE(windows(), 1); // no palette, no help
    QVERIFY(lock.isLocked() && desktop.context.loggedIn());
    QCOMPARE(desktop.context.navigator().current().screen, QStringLiteral("settings"));
    // Tab goes round on the cover.
    for (int i = 0; i < 8; ++i) {
        press(Qt::Key_Tab);
        QVERIFY(focusName().startsWith(QLatin1String("lock.")));
    }
    unlock(desktop);
    QTRY_VERIFY_WITH_TIMEOUT(!lock.isLocked(), kPatience_ms);
    press(Qt::Key_K, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(windows(), 2, kPatience_ms); // they work again
    QApplication::activeModalWidget()->close();
}

void TestLock::anotherWindowIsHidden() {
    DesktopFixture desktop;
    desktop.logIn("ada");
    settle();
    QDialog dialog(desktop.window.get());
    dialog.open();
    auto& lock = lockOf(desktop);
    lock.lock();
    QVERIFY(lock.isLocked() && !dialog.isVisible());
    desktop.window->hide(); // minimised, and back
    desktop.window->show();
    settle();
    QVERIFY(lock.isLocked() && desktop.window->isVisible() &&
            desktop.find<QWidget>(QStringLiteral("lock.cover"))->isVisible());
    QDialog late(desktop.window.get()); // something that was under way brings it up
    late.open();
    QTRY_VERIFY_WITH_TIMEOUT(!late.isVisible(), kPatience_ms);
    unlock(desktop);
    QTRY_VERIFY_WITH_TIMEOUT(!lock.isLocked(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(dialog.isVisible() && late.isVisible(),
                             kPatience_ms); // what somebody was doing is there again
    QTRY_VERIFY_WITH_TIMEOUT(!desktop.find<QWidget>(QStringLiteral("lock.cover")),
                             kPatience_ms); // nothing is left over it
}

void TestLock::wrongPasswordsWait() {
    DesktopFixture desktop;
    desktop.logIn("tina");
    settle();
    auto& lock = lockOf(desktop);
    lock.lock();
    QStringList words;
    for (const QLabel* label : desktop.find<QWidget>(QStringLiteral("lock.cover"))->findChildren<QLabel*>())
        words << label->text();
    QVERIFY2(words.join(QLatin1Char('|')).contains(QStringLiteral("Tina Trainee is logged in.")) &&
                 words.contains(QStringLiteral("Password of Tina Trainee")),
             qPrintable(words.join(QLatin1Char('|'))));
    auto* password = desktop.find<QLineEdit>(QStringLiteral("lock.password"));
    for (int attempt = 1; attempt <= 3; ++attempt) {
        password->setText(QStringLiteral("wrong word %1").arg(attempt));
        desktop.find<QPushButton>(QStringLiteral("lock.unlock"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(password->text().isEmpty(), kPatience_ms);
    }
    QVERIFY(lock.isLocked() && !password->isEnabled());
    QVERIFY(!desktop.find<desktop::NoticeArea>(QStringLiteral("lock.notice"))->text().isEmpty());
    picture(desktop.window.get(), QStringLiteral("lock_wait"));
    QTRY_VERIFY_WITH_TIMEOUT(password->isEnabled(), kPatience_ms);
    unlock(desktop);
    QTRY_VERIFY_WITH_TIMEOUT(!lock.isLocked(), kPatience_ms);
}

void TestLock::switchUserAsksNobody() {
    DesktopFixture desktop;
    desktop.logIn("tina");
    desktop.go(QStringLiteral("settings"));
    settle();
    auto& lock = lockOf(desktop);
    QPointer<QDialog> dialog = new QDialog(desktop.window.get());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
    lock.lock();
    desktop.find<QPushButton>(QStringLiteral("lock.switch"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(!lock.isLocked(), kPatience_ms);
    QVERIFY(!desktop.context.loggedIn());
    QCOMPARE(desktop.context.navigator().current().screen, QStringLiteral("login"));
    QTRY_VERIFY_WITH_TIMEOUT(!dialog || !dialog->isVisible(), kPatience_ms); // not for the next person
    desktop.logIn("theo");
    settle();
    QCOMPARE(desktop.context.actor().name(), std::string("theo"));
    QVERIFY(!desktop.context.navigator().canGoBack());
}

void TestLock::fitsAtEveryScale() {
    DesktopFixture desktop;
    desktop.settings.setScale(2.0);
    desktop.settings.setTheme(desktop::ThemeName::dark);
    desktop.context.applyAppearance();
    desktop.logIn("tina");
    settle();
    lockOf(desktop).lock();
    QTest::qWait(50);
    VERIFY_READABLE(desktop.find<QWidget>(QStringLiteral("lock.cover")));
    picture(desktop.window.get(), QStringLiteral("lock_2"));
}

QTEST_MAIN(TestLock)
#include "test_lock.moc"
