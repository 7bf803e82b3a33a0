// SPDX-License-Identifier: GPL-3.0-or-later
// One mouse and one keyboard for the fingers of two hands.
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "core/tool_state.h"
#include "desktop/training/finger_control.h"
#include "desktop/training/scene_pointer.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>
#include <QtTest>

using namespace chiron;
using namespace chiron::desktop;
using devices::PointerMailbox;

namespace {

struct Fingers {
    explicit Fingers(int count, int ofAHand, bool jaw = false) : mailbox(static_cast<std::size_t>(count)) {
        std::vector<PointerMailbox*> all;
        for (PointerMailbox& one : mailbox)
            all.push_back(&one);
        control.emplace(all, ofAHand, 1.0, false, jaw);
    }
    std::array<double, 4> moved(std::size_t tool) { return mailbox[tool].read().moved; }
    /// As the screen does each frame: which tools press, N.
    void feel(std::initializer_list<double> force_N) {
        haptics::DisplayState state;
        for (const double each : force_N)
            state.tool[static_cast<std::size_t>(state.tools++)].tissue[2] = each;
        control->feel(state);
    }
    bool marked(std::size_t tool) { return mailbox[tool].read().markPresses > 0; }
    std::deque<PointerMailbox> mailbox;
    std::optional<FingerControl> control;
};

constexpr std::array<double, 4> kStill{};

} // namespace

class TestFingerControl : public QObject {
    Q_OBJECT
private slots:
    void theFingersOfAHandMoveTogether() {
        Fingers fingers(4, 2);
        QCOMPARE(fingers.control->hands(), 2);
        fingers.control->drag({100.0, 0.0}, false);
        QCOMPARE(fingers.moved(0)[0], 100.0 * PointerControl::kMetresPerPixel);
        QCOMPARE(fingers.moved(1), fingers.moved(0));
        QCOMPARE(fingers.moved(2), kStill);
        QCOMPARE(fingers.moved(3), kStill);
    }

    void theOtherHandIsChosenAndTheFirstStaysPressed() {
        Fingers fingers(2, 1);
        int told = -1;
        fingers.control->onChosen([&told](int tool) { told = tool; });
        fingers.feel({0.5, 0.0});
        fingers.control->wheel(-240);
        QVERIFY(fingers.control->keyDown(Qt::Key_H));
        QCOMPARE(told, 1);
        QCOMPARE(fingers.control->activeTool(), 1);
        const auto before = fingers.moved(0);
        QCOMPARE(before[2], -2.0 * FingerControl::kMetresPerNotch);
        fingers.control->wheel(-120);
        fingers.control->drag({10.0, 0.0}, true);
        QCOMPARE(fingers.moved(0), before);
        QVERIFY(fingers.moved(1)[2] < 0.0);
        fingers.control->click();
        QVERIFY(!fingers.marked(0));
        QVERIFY(fingers.marked(1));
        fingers.control->keyDown(Qt::Key_H);
        QCOMPARE(told, 0);
    }

    /// In the air a hand comes down in a few notches; where one of its fingers touches, all of them press
    /// finely.
    void quicklyThroughTheAirFinelyInContact() {
        Fingers fingers(4, 2);
        fingers.feel({0.0, 0.0, 0.0, 0.0});
        fingers.control->wheel(-120);
        QCOMPARE(fingers.moved(0)[2], -PointerControl::kMetresPerWheelStep);
        QVERIFY(PointerControl::kMetresPerWheelStep >= 4.0 * FingerControl::kMetresPerNotch);
        QVERIFY(fingers.control->keyDown(Qt::Key_PageDown));
        QCOMPARE(fingers.mailbox[0].read().rate_per_s[2], -PointerControl::kKeySpeed_m_per_s);
        fingers.feel({0.0, 2.0 * FingerControl::kTouch_N, 0.0, 0.0}); // the key is still down
        QCOMPARE(fingers.mailbox[0].read().rate_per_s[2], -FingerControl::kKeyPress_m_per_s);
        fingers.control->wheel(-120);
        QCOMPARE(fingers.moved(1)[2], -PointerControl::kMetresPerWheelStep - FingerControl::kMetresPerNotch);
        fingers.feel({0.0, 0.0, 1.0, 0.0}); // what the other hand touches is no business of this one
        QCOMPARE(fingers.mailbox[0].read().rate_per_s[2], -PointerControl::kKeySpeed_m_per_s);
        fingers.control->releaseKeys();
        fingers.feel({1.0, 0.0, 0.0, 0.0});
        QCOMPARE(fingers.mailbox[0].read().rate_per_s[2], 0.0); // contact alone moves nothing
    }

    void heldKeysLowerFinelyAndStopWhenLetGo() {
        Fingers fingers(2, 2);
        fingers.feel({0.5, 0.5});
        QVERIFY(fingers.control->keyDown(Qt::Key_PageDown));
        QCOMPARE(fingers.mailbox[1].read().rate_per_s[2], -FingerControl::kKeyPress_m_per_s);
        QVERIFY(fingers.control->keyUp(Qt::Key_PageDown));
        QCOMPARE(fingers.mailbox[1].read().rate_per_s[2], 0.0);
        QVERIFY(fingers.control->keyDown(Qt::Key_Right)); // across the field as any point
        QCOMPARE(fingers.mailbox[0].read().rate_per_s[0], PointerControl::kKeySpeed_m_per_s);
        fingers.control->releaseKeys();
        QCOMPARE(fingers.mailbox[0].read().rate_per_s[0], 0.0);
        QVERIFY(!fingers.control->keyDown(Qt::Key_H)); // there is one hand
        QVERIFY(!fingers.control->keyDown(Qt::Key_1));
    }

    /// The hand of a person shakes while a button goes down and up: the finger must not.
    void theClickThatMarksDoesNotMoveTheFinger() {
        Fingers fingers(1, 1);
        QWidget scene;
        scene.resize(600, 400);
        scene.show();
        ScenePointer pointer(*fingers.control, scene, scene);
        connect(&pointer, &ScenePointer::marked, &scene, [&] { fingers.control->click(); });
        pointer.capture();
        const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held) {
            QMouseEvent event(type, at, scene.mapToGlobal(at), button, held, Qt::NoModifier);
            QApplication::sendEvent(&scene, &event);
        };
        send(QEvent::MouseMove, {300, 200}, Qt::NoButton, Qt::NoButton);
        send(QEvent::MouseMove, {310, 200}, Qt::NoButton, Qt::NoButton);
        const auto before = fingers.moved(0);
        send(QEvent::MouseButtonPress, {310, 200}, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseMove, {316, 209}, Qt::NoButton, Qt::LeftButton);
        QVERIFY(fingers.marked(0));
        send(QEvent::MouseButtonRelease, {318, 205}, Qt::LeftButton, Qt::NoButton);
        QCOMPARE(fingers.moved(0), before);
        send(QEvent::MouseMove, {320, 205}, Qt::NoButton, Qt::NoButton);
        QVERIFY(fingers.moved(0) != before);
    }

    /// Where a level has a pinch; both fingers of a hand tell of its one lever.
    void theJawOfTheHandIsClosedAndOpened() {
        Fingers fingers(4, 2, true);
        const auto rate = [&](std::size_t tool) { return fingers.mailbox[tool].read().rate_per_s[3]; };
        QVERIFY(fingers.control->keyDown(Qt::Key_O));
        QCOMPARE(rate(0), FingerControl::kJawSpeed_rad_per_s);
        QCOMPARE(rate(1), rate(0));
        QCOMPARE(rate(2), 0.0);
        QVERIFY(fingers.control->keyUp(Qt::Key_O));
        QCOMPARE(rate(0), 0.0);
        QVERIFY(fingers.control->keyDown(Qt::Key_G));
        QCOMPARE(rate(0), -FingerControl::kJawSpeed_rad_per_s);
        fingers.control->choose(1); // the hand that is left keeps its jaw as it is
        QCOMPARE(rate(0), 0.0);
        QVERIFY(fingers.control->keyDown(Qt::Key_G));
        QCOMPARE(rate(2), -FingerControl::kJawSpeed_rad_per_s);
        fingers.control->releaseKeys();
        QCOMPARE(rate(2), 0.0);
        Fingers without(1, 1);
        QVERIFY(!without.control->keyDown(Qt::Key_G) && !without.control->keyDown(Qt::Key_O));
    }

    void everyKeyIsDocumented() {
        const QString words = palpationKeysInWords(true, 2, true);
        for (const char* key :
             {"Page Down", "1 to 5", "V for", "+ and −", "N.", "Delete", "D.", "H.", "Enter", "wheel"})
            QVERIFY2(words.contains(QString::fromUtf8(key)), key);
        QVERIFY(!palpationKeysInWords(true, 1, true).contains(QStringLiteral("Other hand")));
        QVERIFY(!palpationKeysInWords(true, 1, false).contains(QStringLiteral("1 to 5")));
        QVERIFY(!words.contains(QStringLiteral("jaws")));
        QVERIFY(palpationKeysInWords(true, 1, false, true).contains(QStringLiteral("close them with G")));
        QVERIFY(activeHandInWords(0) != activeHandInWords(1));
    }
};

QTEST_MAIN(TestFingerControl)
#include "test_finger_control.moc"
