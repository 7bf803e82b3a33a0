// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/early_marks.h"

#include <QtTest>

using namespace chiron;
using core::TrialPhase;
using desktop::EarlyMarks;

namespace {
constexpr std::int64_t kWait_ms = EarlyMarks::kWait_ms;

haptics::DisplayState stateOf(TrialPhase phase, int trial, double x_m = 0.0) {
    haptics::DisplayState state;
    state.phase = phase;
    state.trial = static_cast<std::uint16_t>(trial);
    state.tools = 1;
    state.tool[0].p_WT_m = {x_m, 0.0, 0.03};
    return state;
}
} // namespace

class TestEarlyMarks : public QObject {
    Q_OBJECT
private slots:
    void nothingIsEarlyBeforeAnybodyWentOn();
    void aSecondPressIsEarly();
    void everyTrialHasItsOwnWait();
    void whoHasMovedMarksAtOnce();
};

void TestEarlyMarks::nothingIsEarlyBeforeAnybodyWentOn() {
    const EarlyMarks marks;
    QVERIFY(!marks.areEarly(0));
}

void TestEarlyMarks::aSecondPressIsEarly() {
    EarlyMarks marks;
    marks.wentOn(1000);
    QVERIFY(marks.areEarly(1000) && marks.areEarly(999 + kWait_ms) && !marks.areEarly(1000 + kWait_ms));
    marks.look(stateOf(TrialPhase::idle, 0), 1010);
    QVERIFY(marks.areEarly(1010));
    marks.look(stateOf(TrialPhase::running, 0), 1200); // the trial begins only now
    QVERIFY(marks.areEarly(1199 + kWait_ms) && !marks.areEarly(1200 + kWait_ms));
    marks.look(stateOf(TrialPhase::running, 0), 1300); // and begins once
    QVERIFY(!marks.areEarly(1200 + kWait_ms));
    marks.look(stateOf(TrialPhase::running, 0), 1200 + kWait_ms);
    QVERIFY(!marks.areEarly(1200 + kWait_ms));
    marks.wentOn(5000); // after a pause
    QVERIFY(marks.areEarly(5100) && !marks.areEarly(5000 + kWait_ms));
}

void TestEarlyMarks::everyTrialHasItsOwnWait() {
    EarlyMarks marks;
    marks.look(stateOf(TrialPhase::running, 0), 0);
    marks.look(stateOf(TrialPhase::between, 0), 2000);
    QVERIFY(!marks.areEarly(2000));
    marks.look(stateOf(TrialPhase::running, 1), 3000);
    QVERIFY(marks.areEarly(3000) && !marks.areEarly(3000 + kWait_ms));
    marks.look(stateOf(TrialPhase::running, 1), 3000 + kWait_ms);
    marks.look(stateOf(TrialPhase::running, 2), 9000); // no frame showed the time between the two
    QVERIFY(marks.areEarly(9000));
}

void TestEarlyMarks::whoHasMovedMarksAtOnce() {
    EarlyMarks marks;
    marks.wentOn(0);
    marks.look(stateOf(TrialPhase::running, 0, 0.010), 16);
    marks.look(stateOf(TrialPhase::running, 0, 0.012), 32); // a hand that presses twice
    QVERIFY(marks.areEarly(32));
    marks.look(stateOf(TrialPhase::running, 0, 0.014), 48);
    QVERIFY(!marks.areEarly(48));
}

QTEST_APPLESS_MAIN(TestEarlyMarks)
#include "test_early_marks.moc"
