// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/endoscope_control.h"
#include "desktop/training/scene_pointer.h"

#include <QMouseEvent>
#include <QWidget>
#include <QtTest>

using namespace chiron;
using namespace chiron::desktop;
using devices::EndoscopeMailbox;

class TestEndoscopeControl : public QObject {
    Q_OBJECT
private slots:
    void pixelsTurnAndShift();
    void theWheelAdvances();
    void keysAreSpeeds();
    void shiftMakesArrowsMoveSideways();
    void letGoStops();
    void aMirroredWorkspaceKeepsRightRight();
    void shiftAndDragShift();
};

namespace {
devices::EndoscopeMovement moved(EndoscopeMailbox& mailbox) {
    return EndoscopeMailbox::toMovement(mailbox.read().moved);
}
devices::EndoscopeMovement rate(EndoscopeMailbox& mailbox) {
    return EndoscopeMailbox::toMovement(mailbox.read().rate_per_s);
}
} // namespace

void TestEndoscopeControl::pixelsTurnAndShift() {
    EndoscopeMailbox mailbox;
    EndoscopeControl hand(mailbox, 2.0);
    hand.drag({100.0, 40.0}, false); // to the right and down on the screen, at 200 %
    QCOMPARE(moved(mailbox).turnRight_rad, 50.0 * EndoscopeControl::kRadiansPerPixel);
    QCOMPARE(moved(mailbox).turnUp_rad, -20.0 * EndoscopeControl::kRadiansPerPixel);
    QCOMPARE(moved(mailbox).right_m, 0.0);
    hand.drag({100.0, 40.0}, true);
    QCOMPARE(moved(mailbox).right_m, 50.0 * EndoscopeControl::kMetresPerPixel);
    QCOMPARE(moved(mailbox).up_m, -20.0 * EndoscopeControl::kMetresPerPixel);
    QCOMPARE(moved(mailbox).turnRight_rad, 50.0 * EndoscopeControl::kRadiansPerPixel);
}

void TestEndoscopeControl::theWheelAdvances() {
    EndoscopeMailbox mailbox;
    EndoscopeControl hand(mailbox, 2.0);
    hand.wheel(240);
    QCOMPARE(moved(mailbox).advance_m, 0.004); // two notches, whatever the scale
    hand.wheel(-360);
    QCOMPARE(moved(mailbox).advance_m, -0.002);
    hand.click();
    QCOMPARE(mailbox.read().markPresses, 0u); // nothing is marked with an endoscope
}

void TestEndoscopeControl::keysAreSpeeds() {
    EndoscopeMailbox mailbox;
    EndoscopeControl hand(mailbox, 1.0);
    QVERIFY(!hand.keyDown(Qt::Key_A));
    QVERIFY(hand.keyDown(Qt::Key_W) && hand.keyDown(Qt::Key_PageUp)); // both are no faster than one
    QCOMPARE(rate(mailbox).advance_m, EndoscopeControl::kKeyAdvance_m_per_s);
    hand.keyDown(Qt::Key_Up);
    hand.keyDown(Qt::Key_Right);
    hand.keyDown(Qt::Key_E);
    QCOMPARE(rate(mailbox).turnUp_rad, EndoscopeControl::kKeyTurn_rad_per_s);
    QCOMPARE(rate(mailbox).turnRight_rad, EndoscopeControl::kKeyTurn_rad_per_s);
    QCOMPARE(rate(mailbox).spin_rad, EndoscopeControl::kKeySpin_rad_per_s);
    hand.keyDown(Qt::Key_Q);
    QCOMPARE(rate(mailbox).spin_rad, 0.0);
    hand.keyUp(Qt::Key_W);
    QCOMPARE(rate(mailbox).advance_m, EndoscopeControl::kKeyAdvance_m_per_s);
    hand.keyUp(Qt::Key_PageUp);
    QCOMPARE(rate(mailbox).advance_m, 0.0);
    for (const int key : hand.keys())
        QVERIFY(hand.keyDown(key));
}

void TestEndoscopeControl::shiftMakesArrowsMoveSideways() {
    EndoscopeMailbox mailbox;
    EndoscopeControl hand(mailbox, 1.0);
    hand.keyDown(Qt::Key_Left);
    hand.keyDown(Qt::Key_Shift);
    QCOMPARE(rate(mailbox).turnRight_rad, 0.0);
    QCOMPARE(rate(mailbox).right_m, -EndoscopeControl::kKeyShift_m_per_s);
    hand.keyUp(Qt::Key_Shift);
    QCOMPARE(rate(mailbox).right_m, 0.0);
    QCOMPARE(rate(mailbox).turnRight_rad, -EndoscopeControl::kKeyTurn_rad_per_s);
}

void TestEndoscopeControl::letGoStops() {
    EndoscopeMailbox mailbox;
    EndoscopeControl hand(mailbox, 1.0);
    for (const int key : {Qt::Key_W, Qt::Key_Up, Qt::Key_E, Qt::Key_Shift})
        hand.keyDown(key);
    hand.releaseKeys();
    for (const double value : mailbox.read().rate_per_s)
        QCOMPARE(value, 0.0);
}

void TestEndoscopeControl::aMirroredWorkspaceKeepsRightRight() {
    EndoscopeMailbox mailbox;
    EndoscopeControl hand(mailbox, 1.0, true);
    hand.drag({10.0, 10.0}, false);
    QCOMPARE(moved(mailbox).turnRight_rad,
             -10.0 * EndoscopeControl::kRadiansPerPixel); // D is mirrored, the picture is not
    QCOMPARE(moved(mailbox).turnUp_rad, -10.0 * EndoscopeControl::kRadiansPerPixel);
}

void TestEndoscopeControl::shiftAndDragShift() {
    EndoscopeMailbox mailbox;
    EndoscopeControl hand(mailbox, 1.0);
    QWidget area;
    area.resize(800, 600);
    ScenePointer pointer(hand, area, area);
    pointer.capture();
    const auto moveTo = [&](double x, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
        QMouseEvent event(QEvent::MouseMove, QPointF(x, 300.0), QPointF(x, 300.0), Qt::NoButton, buttons,
                          modifiers);
        QApplication::sendEvent(&area, &event);
    };
    moveTo(400.0, Qt::NoButton, Qt::NoModifier);
    moveTo(410.0, Qt::NoButton, Qt::NoModifier);
    QVERIFY(moved(mailbox).turnRight_rad > 0.0 && moved(mailbox).right_m == 0.0);
    const double turned = moved(mailbox).turnRight_rad;
    moveTo(420.0, Qt::RightButton, Qt::NoModifier);
    moveTo(430.0, Qt::NoButton, Qt::ShiftModifier);
    QVERIFY(qFuzzyCompare(moved(mailbox).right_m, 20.0 * EndoscopeControl::kMetresPerPixel));
    QCOMPARE(moved(mailbox).turnRight_rad, turned);
    moveTo(440.0, Qt::LeftButton, Qt::NoModifier); // a plain drag turns, as moving does
    QVERIFY(moved(mailbox).turnRight_rad > turned);
}

QTEST_MAIN(TestEndoscopeControl)
#include "test_endoscope_control.moc"
