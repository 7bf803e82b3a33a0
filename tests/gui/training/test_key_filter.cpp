// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/key_filter.h"
#include "support/patience.h"

#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QWindow>
#include <QtTest>
#include <array>

using chiron::tests::kPatience_ms;

using namespace chiron::desktop;

namespace {
/// A screen with a button, and the scene's native window beside it.
struct Keys {
    Keys() {
        screen.setFocusPolicy(Qt::StrongFocus);
        screen.show();
        scene.show();
        filter.setScene(&scene);
        filter.setToolKeys(std::array<int, 2>{Qt::Key_PageDown, Qt::Key_W});
        filter.setActive(true);
    }
    QWidget screen;
    QPushButton button{QStringLiteral("Pause"), &screen};
    QLineEdit field{&screen};
    QWindow scene;
    KeyFilter filter{screen};
};
} // namespace

class TestKeyFilter : public QObject {
    Q_OBJECT
private slots:
    void keysInTheNativeScene();
    void tabLeavesTheScene();
    void enterPressesTheFocusedButton();
    void escStopsInsteadOfClosing();
    void typingIsLeftAlone();
    void keysRestAfterTheSession();
    void keysOfTheToolAndOfTheExerciseAlone();
    void theKeysOfThePanelMoveNothing();
    void aToolKeyIsLetGoWithCtrlToo();
};

void TestKeyFilter::keysInTheNativeScene() {
    Keys keys;
    QSignalSpy stop(&keys.filter, &KeyFilter::stopAsked);
    QSignalSpy pause(&keys.filter, &KeyFilter::pauseAsked);
    QSignalSpy mark(&keys.filter, &KeyFilter::markAsked);
    QSignalSpy rearm(&keys.filter, &KeyFilter::rearmAsked);
    QSignalSpy tool(&keys.filter, &KeyFilter::toolKey);
    keys.scene.requestActivate();
    QVERIFY(QTest::qWaitForWindowActive(&keys.scene));
    QTest::keyClick(&keys.scene, Qt::Key_Escape);
    QTest::keyClick(&keys.scene, Qt::Key_Space);
    QTest::keyClick(&keys.scene, Qt::Key_Return);
    QTest::keyClick(&keys.scene, Qt::Key_R);
    QTest::keyClick(&keys.scene, Qt::Key_PageDown);
    QCOMPARE(stop.count(), 1);
    QCOMPARE(pause.count(), 1);
    QCOMPARE(mark.count(), 1);
    QCOMPARE(rearm.count(), 1);
    QCOMPARE(tool.count(), 2);
    QCOMPARE(tool.at(0).at(1).toBool(), true);
    QCOMPARE(tool.at(1).at(1).toBool(), false);
}

void TestKeyFilter::tabLeavesTheScene() {
    Keys keys;
    QSignalSpy leave(&keys.filter, &KeyFilter::leaveSceneAsked);
    QTest::keyClick(&keys.scene, Qt::Key_Tab);
    QCOMPARE(leave.count(), 1);
    QTest::keyClick(&keys.screen, Qt::Key_Tab); // among widgets it is as ever
    QCOMPARE(leave.count(), 1);
}

void TestKeyFilter::enterPressesTheFocusedButton() {
    Keys keys;
    QSignalSpy mark(&keys.filter, &KeyFilter::markAsked);
    QSignalSpy pressed(&keys.button, &QPushButton::clicked);
    keys.screen.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&keys.screen));
    keys.button.setFocus();
    QTRY_VERIFY_WITH_TIMEOUT(keys.button.hasFocus(), kPatience_ms);
    QTest::keyClick(&keys.button, Qt::Key_Return);
    QCOMPARE(pressed.count(), 1);
    QCOMPARE(mark.count(), 0);
    keys.screen.setFocus();
    QTest::keyClick(&keys.screen, Qt::Key_Return);
    QCOMPARE(mark.count(), 1);
}

void TestKeyFilter::escStopsInsteadOfClosing() {
    Keys keys;
    QSignalSpy stop(&keys.filter, &KeyFilter::stopAsked);
    QSignalSpy pause(&keys.filter, &KeyFilter::pauseAsked);
    QDialog dialog(&keys.screen);
    dialog.setModal(true);
    dialog.show();
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QCOMPARE(stop.count(), 1);
    QVERIFY(dialog.isVisible());
    QTest::keyClick(&dialog, Qt::Key_Space); // everything else is the dialog's
    QCOMPARE(pause.count(), 0);
    keys.filter.setHeld(true);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isVisible());
    QCOMPARE(stop.count(), 1);
}

void TestKeyFilter::typingIsLeftAlone() {
    Keys keys;
    QSignalSpy pause(&keys.filter, &KeyFilter::pauseAsked);
    keys.screen.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&keys.screen));
    keys.field.setFocus();
    QTRY_VERIFY_WITH_TIMEOUT(keys.field.hasFocus(), kPatience_ms);
    QTest::keyClicks(&keys.field, QStringLiteral("r r"));
    QCOMPARE(keys.field.text(), QStringLiteral("r r"));
    QCOMPARE(pause.count(), 0);
}

void TestKeyFilter::keysRestAfterTheSession() {
    Keys keys;
    QSignalSpy stop(&keys.filter, &KeyFilter::stopAsked);
    keys.filter.setActive(false);
    QTest::keyClick(&keys.screen, Qt::Key_Escape);
    QCOMPARE(stop.count(), 0);
}

void TestKeyFilter::keysOfTheToolAndOfTheExerciseAlone() {
    Keys keys;
    QSignalSpy tool(&keys.filter, &KeyFilter::toolKey);
    QSignalSpy again(&keys.filter, &KeyFilter::startAgainAsked);
    QSignalSpy depth(&keys.filter, &KeyFilter::depthOfFieldAsked);
    QTest::keyClick(&keys.screen, Qt::Key_W);
    QTest::keyClick(&keys.screen, Qt::Key_Q); // not one of this tool's
    QTest::keyClick(&keys.screen, Qt::Key_F); // the exercise has no such switch
    QTest::keyClick(&keys.screen, Qt::Key_F5);
    QCOMPARE(tool.count(), 2);
    QCOMPARE(again.count(), 1);
    QCOMPARE(depth.count(), 0);
    keys.filter.setDepthOfFieldKey(true);
    QTest::keyClick(&keys.screen, Qt::Key_F);
    QCOMPARE(depth.count(), 1);
    keys.screen.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&keys.screen));
    keys.field.setFocus();
    QTRY_VERIFY_WITH_TIMEOUT(keys.field.hasFocus(), kPatience_ms);
    QTest::keyClicks(&keys.field, QStringLiteral("fw"));
    QCOMPARE(keys.field.text(), QStringLiteral("fw")); // typing is left alone
    QCOMPARE(depth.count(), 1);
}

/// Page Down lowers the tool; with Ctrl it reads on in the panel, wherever the focus is. Where the screen has
/// no panel, the keys with Ctrl are left to whoever has the focus.
void TestKeyFilter::theKeysOfThePanelMoveNothing() {
    Keys keys;
    QSignalSpy tool(&keys.filter, &KeyFilter::toolKey);
    QSignalSpy panel(&keys.filter, &KeyFilter::panelAsked);
    QKeyEvent unused(QEvent::KeyPress, Qt::Key_PageDown, Qt::ControlModifier);
    QCoreApplication::sendEvent(&keys.screen, &unused);
    QVERIFY(!unused.isAccepted()); // a plain widget has no use for it
    QCOMPARE(panel.count(), 0);
    keys.filter.setPanelKeys(true);
    QTest::keyPress(&keys.scene, Qt::Key_PageDown, Qt::ControlModifier);
    QTest::keyPress(&keys.screen, Qt::Key_PageUp, Qt::ControlModifier);
    QCOMPARE(panel.count(), 2);
    QCOMPARE(panel.at(0).at(0).toBool(), true);
    QCOMPARE(panel.at(1).at(0).toBool(), false);
    QCOMPARE(tool.count(), 0);
    QTest::keyPress(&keys.scene, Qt::Key_PageDown);
    QCOMPARE(tool.count(), 1);
    QCOMPARE(panel.count(), 2);
}

/// Whoever holds a key of the tool down, presses Ctrl and lets the key go does not leave the tool moving.
void TestKeyFilter::aToolKeyIsLetGoWithCtrlToo() {
    Keys keys;
    QSignalSpy tool(&keys.filter, &KeyFilter::toolKey);
    QTest::keyPress(&keys.scene, Qt::Key_W);
    QTest::keyRelease(&keys.scene, Qt::Key_W, Qt::ControlModifier);
    QCOMPARE(tool.count(), 2);
    QCOMPARE(tool.at(1).at(1).toBool(), false);
    QTest::keyPress(&keys.scene, Qt::Key_W, Qt::ControlModifier); // a shortcut of somebody else
    QCOMPARE(tool.count(), 2);
}

QTEST_MAIN(TestKeyFilter)
#include "test_key_filter.moc"
