// SPDX-License-Identifier: GPL-3.0-or-later
// One mouse and one keyboard for several graspers.
#include "desktop/training/grasper_control.h"
#include "desktop/training/scene_pointer.h"
#include "desktop/training/training_words.h"

#include <QMouseEvent>
#include <QWidget>
#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::desktop;
using devices::PointerMailbox;

namespace {
struct Hands {
    PointerMailbox right;
    PointerMailbox left;
    std::vector<PointerMailbox*> both{&right, &left};
    GrasperControl control{both, 1.0};
    double jawOf(PointerMailbox& mailbox) { return mailbox.read().rate_per_s[3]; }
};
} // namespace

class TestGrasperControl : public QObject {
    Q_OBJECT
private slots:
    /// The chosen one moves as a point does; the other one stays.
    void oneMovesAtATime() {
        Hands hands;
        hands.control.drag({100.0, 0.0}, false);
        hands.control.wheel(120);
        QCOMPARE(hands.right.read().moved[0], 100.0 * PointerControl::kMetresPerPixel);
        QCOMPARE(hands.right.read().moved[2], PointerControl::kMetresPerWheelStep);
        QCOMPARE(hands.left.read().moved, (std::array<double, 4>{}));
        int told = -1;
        hands.control.onChosen([&told](int tool) { told = tool; });
        QVERIFY(hands.control.keyDown(Qt::Key_2));
        QCOMPARE(told, 1);
        QCOMPARE(hands.control.activeTool(), 1);
        hands.control.drag({0.0, -50.0}, false);
        QCOMPARE(hands.left.read().moved[1], 50.0 * PointerControl::kMetresPerPixel);
        QCOMPARE(hands.right.read().moved[1], 0.0);
        QVERIFY(!hands.control.keyDown(Qt::Key_3)); // there is no third one
        QCOMPARE(hands.control.activeTool(), 1);
    }

    /// G and the left button close for as long as they are held, H and the button with Shift open.
    void theJawMovesWhileItIsHeld() {
        Hands hands;
        constexpr double kSpeed = GrasperControl::kJawSpeed_rad_per_s;
        QVERIFY(hands.control.keyDown(Qt::Key_G));
        QCOMPARE(hands.jawOf(hands.right), -kSpeed);
        QVERIFY(hands.control.keyUp(Qt::Key_G));
        QCOMPARE(hands.jawOf(hands.right), 0.0);
        hands.control.keyDown(Qt::Key_H);
        QCOMPARE(hands.jawOf(hands.right), kSpeed);
        hands.control.keyDown(Qt::Key_G); // both: it stays
        QCOMPARE(hands.jawOf(hands.right), 0.0);
        hands.control.keyUp(Qt::Key_H);
        hands.control.buttonDown(false); // key and button are no faster than one
        QCOMPARE(hands.jawOf(hands.right), -kSpeed);
        hands.control.keyUp(Qt::Key_G);
        QCOMPARE(hands.jawOf(hands.right), -kSpeed);
        hands.control.buttonUp();
        hands.control.buttonDown(true);
        QCOMPARE(hands.jawOf(hands.right), kSpeed);
        hands.control.buttonUp();
        QCOMPARE(hands.jawOf(hands.right), 0.0);
        hands.control.click();
        QCOMPARE(hands.right.read().markPresses, 0u); // nothing is marked with a grasper
    }

    /// Whatever the hand held it lets go of when it changes hands, pauses or loses the keyboard: nothing goes
    /// on by itself.
    void changingHandsStopsTheOther() {
        Hands hands;
        hands.control.keyDown(Qt::Key_Right);
        hands.control.keyDown(Qt::Key_G);
        QVERIFY(hands.right.read().rate_per_s[0] > 0.0);
        hands.control.choose(1);
        QCOMPARE(hands.right.read().rate_per_s, (std::array<double, 4>{}));
        QCOMPARE(hands.left.read().rate_per_s, (std::array<double, 4>{}));
        hands.control.keyDown(Qt::Key_Left);
        hands.control.buttonDown(false);
        hands.control.releaseKeys();
        QCOMPARE(hands.left.read().rate_per_s, (std::array<double, 4>{}));
    }

    void onlyOneInstrumentNeedsNoNumbers() {
        PointerMailbox mailbox;
        const std::vector<PointerMailbox*> one{&mailbox};
        GrasperControl control(one, 1.0);
        const auto keys = control.keys();
        QVERIFY(std::find(keys.begin(), keys.end(), Qt::Key_1) == keys.end());
        QVERIFY(std::find(keys.begin(), keys.end(), Qt::Key_G) != keys.end());
        QVERIFY(!control.keyDown(Qt::Key_1));
        Hands two;
        const auto more = two.control.keys();
        QVERIFY(std::find(more.begin(), more.end(), Qt::Key_2) != more.end());
        QVERIFY(std::find(more.begin(), more.end(), Qt::Key_Tab) == more.end()); // Tab leaves the scene
    }

    /// Over the scene: the first click takes the pointer and closes nothing; held, the button closes; let go,
    /// it stops.
    void theButtonOverTheSceneCloses() {
        Hands hands;
        QWidget scene;
        scene.resize(400, 300);
        ScenePointer pointer(hands.control, scene, scene);
        const auto send = [&scene](QEvent::Type type, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
            QMouseEvent event(type, QPointF(200, 150), QPointF(200, 150), Qt::LeftButton,
                              type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, modifiers);
            QCoreApplication::sendEvent(&scene, &event);
        };
        send(QEvent::MouseButtonPress);
        QCOMPARE(hands.jawOf(hands.right), 0.0);
        send(QEvent::MouseButtonRelease);
        pointer.capture();
        send(QEvent::MouseButtonPress);
        QVERIFY(hands.jawOf(hands.right) < 0.0);
        send(QEvent::MouseButtonRelease);
        QCOMPARE(hands.jawOf(hands.right), 0.0);
        send(QEvent::MouseButtonPress, Qt::ShiftModifier);
        QVERIFY(hands.jawOf(hands.right) > 0.0);
        send(QEvent::MouseButtonRelease);
        QCOMPARE(hands.jawOf(hands.right), 0.0);
    }

    void wordsSayHow() {
        for (const int tools : {1, 2, 4}) {
            const QString keys = keysInWords(true, session::PointerTool::grasper, tools);
            QVERIFY(keys.contains(QStringLiteral("G")) && keys.contains(QStringLiteral("H")));
            QCOMPARE(keys.contains(QStringLiteral("Instrument")), tools > 1);
            QVERIFY(!keys.contains(QStringLiteral("Mark")));
        }
        QVERIFY(activeToolInWords(0, 2) != activeToolInWords(1, 2));
        QVERIFY(activeToolInWords(2, 4).contains(QStringLiteral("3")));
    }
};

QTEST_MAIN(TestGrasperControl)
#include "test_grasper_control.moc"
