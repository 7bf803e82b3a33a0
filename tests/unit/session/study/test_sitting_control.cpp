// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/sitting_control.h"

#include <QtTest>

using namespace chiron;

// What a sitting's window asks of the loop about pause and force, and what it takes from it.
class TestSittingControl : public QObject {
    Q_OBJECT
private slots:
    void aFrozenWindowArmsAgain();
    void everyLatchStopsOnce();
    void goingOnWhileStoppedTakesArming();
};

namespace {

haptics::DisplayState stateOf(core::ForceState force) {
    haptics::DisplayState state;
    state.force = force;
    return state;
}

} // namespace

/// The supervisor takes the force away while the window hangs. Who arms again goes on, although the newest
/// state that the window has still shows the latch, and another freeze stops again.
void TestSittingControl::aFrozenWindowArmsAgain() {
    for (const core::ForceState latch : {core::ForceState::stopped, core::ForceState::fault}) {
        session::SittingControl control;
        control.look(stateOf(core::ForceState::on));
        QVERIFY(!control.stopped() && !control.held());
        control.look(stateOf(latch));
        QVERIFY(control.stopped() && control.paused() && control.held());
        control.rearm();
        QVERIFY(!control.stopped() && !control.paused());
        control.look(stateOf(latch)); // not heard yet
        QVERIFY(!control.stopped() && !control.paused());
        control.look(stateOf(core::ForceState::on));
        QVERIFY(!control.stopped());
        control.look(stateOf(latch)); // it hangs again
        QVERIFY(control.stopped() && control.paused());
    }
}

void TestSittingControl::everyLatchStopsOnce() {
    session::SittingControl control;
    control.stopForce();
    control.look(stateOf(core::ForceState::stopped)); // what was asked for
    control.rearm();
    control.look(stateOf(core::ForceState::stopped));
    QVERIFY(!control.stopped());
    control.rearm(); // nothing is stopped: nothing happens
    QVERIFY(!control.stopped() && !control.paused());
}

void TestSittingControl::goingOnWhileStoppedTakesArming() {
    session::SittingControl control;
    control.look(stateOf(core::ForceState::fault));
    control.wantPause(false);
    QVERIFY(control.paused());
    control.rearm();
    QVERIFY(!control.paused());
    control.wantPause(true);
    QVERIFY(control.paused() && !control.stopped());
    control.wantPause(false);
    QVERIFY(!control.paused());
}

QTEST_APPLESS_MAIN(TestSittingControl)
#include "test_sitting_control.moc"
