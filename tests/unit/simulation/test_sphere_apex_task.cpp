// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "scene_driver.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::TrialPhase;
using core::Vec3;
namespace bits = core::event_bits;

class TestSphereApexTask : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void waitsForStart();
    void waitsForForce();
    void markByButtonEdge();
    void heldButtonIsNoMark();
    void edgeDuringPauseIsNoMark();
    void otherButtonsAndToolsDoNotMark();
    void markByCommand();
    void marksCountOnlyWhileRunning();
    void timesOutAtItsTick();
    void markAtTheLastTickWins();
    void pauseStopsEveryClock();
    void finishesAfterTheLastTrial();
};

void TestSphereApexTask::waitsForStart() {
    Driver d(shortTrials());
    d.in.forceReady = true;
    d.in.mark = true;
    d.pressApex(0.005);
    for (int n = 0; n < 200; ++n) {
        d.tick();
        QCOMPARE(d.out.phase, TrialPhase::idle);
        QCOMPARE(d.out.events, 0u);
        QCOMPARE(d.out.tissue.tools[0].force.norm(), 0.0); // no object before the start
    }
    d.in.started = true;
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QCOMPARE(d.out.events & bits::kSceneChanged, bits::kSceneChanged);
}

void TestSphereApexTask::waitsForForce() {
    Driver d(shortTrials());
    d.in.started = true;
    d.ticks(5000); // longer than any limit: waiting costs nothing
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QVERIFY(std::abs(d.out.cues.timeLeft_s - 0.050) < 1e-12);
    d.pressApex(0.002);
    d.tick();
    QVERIFY(d.out.tissue.tools[0].force.z() > 0.9); // the object answers, so that the supervisor can see it
    d.in.forceReady = true;
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::running);
    QCOMPARE(d.out.events, bits::kTrialStarted);
    d.in.forceReady = false; // force lost in mid-trial does not undo the trial
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::running);
    QCOMPARE(d.out.events, 0u);
    // a stale forceReady in the tick of the start does not skip `ready`
    Driver stale(shortTrials());
    stale.in.started = true;
    stale.in.forceReady = true;
    QCOMPARE(stale.tick().phase, TrialPhase::ready);
}

void TestSphereApexTask::markByButtonEdge() {
    Driver d(shortTrials());
    d.startRunning();
    d.pressApex(0.002);
    d.ticks(10);
    d.button(true);
    d.tick();
    QCOMPARE(d.out.events, bits::kMarked);
    QCOMPARE(d.out.phase, TrialPhase::running); // the marked tick belongs to the trial ...
    QVERIFY(d.out.tissue.tools[0].force.z() > 0.9);
    QCOMPARE(d.out.trial, std::uint16_t{0});
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::between); // ... and the next one does not
    QCOMPARE(d.out.events, bits::kContactEnded);
    QCOMPARE(d.out.trial, std::uint16_t{0});
}

void TestSphereApexTask::heldButtonIsNoMark() {
    Driver d(shortTrials());
    d.button(true); // held since before the session
    d.startRunning();
    for (int n = 0; n < 20; ++n)
        QCOMPARE(d.tick().events, 0u);
    d.button(false);
    d.tick();
    d.button(true);
    QCOMPARE(d.tick().events, bits::kMarked);
    // still held into the next trial: no mark there
    while (d.tick().phase != TrialPhase::running || d.out.trial == 0)
        QVERIFY(d.source.executed() < 1000);
    for (int n = 0; n < 20; ++n)
        QCOMPARE(d.tick().events, 0u);
}

void TestSphereApexTask::edgeDuringPauseIsNoMark() {
    Driver d(shortTrials());
    d.startRunning();
    d.in.paused = true;
    d.tick();
    d.button(true);
    d.in.mark = true;
    d.ticks(5);
    d.in.paused = false;
    for (int n = 0; n < 10; ++n)
        QCOMPARE(d.tick().events, 0u);
    d.button(false);
    d.tick();
    d.button(true);
    QCOMPARE(d.tick().events, bits::kMarked);
}

void TestSphereApexTask::otherButtonsAndToolsDoNotMark() {
    Driver d(shortTrials());
    d.in.tools.count = 2;
    d.in.tools.tools[1].p_WT = Vec3(0, 0, 0.05);
    d.startRunning();
    d.tick();
    d.in.tools.tools[0].buttons = core::kButtonStop | core::kButtonDeadMan;
    d.in.tools.tools[1].buttons = core::kButtonMark;
    for (int n = 0; n < 10; ++n)
        QCOMPARE(d.tick().events, 0u);
}

void TestSphereApexTask::markByCommand() {
    Driver d(shortTrials());
    d.startRunning();
    d.ticks(3);
    d.in.mark = true;
    QCOMPARE(d.tick().events, bits::kMarked);
}

void TestSphereApexTask::marksCountOnlyWhileRunning() {
    Driver d(shortTrials());
    d.in.started = true;
    d.ticks(3);
    d.in.mark = true; // ready
    QCOMPARE(d.tick().events, 0u);
    d.in.forceReady = true;
    d.tick();
    d.in.mark = true;
    QCOMPARE(d.tick().events, bits::kMarked);
    d.in.mark = true; // the tick after: the trial is over
    QCOMPARE(d.tick().events, 0u);
    d.in.mark = true; // between
    QCOMPARE(d.tick().events, 0u);
    QCOMPARE(d.out.phase, TrialPhase::between);
}

void TestSphereApexTask::timesOutAtItsTick() {
    Driver d(shortTrials());
    d.startRunning(); // first running tick done
    for (int n = 2; n < 50; ++n) {
        d.tick();
        QCOMPARE(d.out.events, 0u);
        QVERIFY(std::abs(d.out.cues.timeLeft_s - (50 - n) * 0.001) < 1e-12);
    }
    d.tick(); // the 50th
    QCOMPARE(d.out.events, bits::kTimedOut);
    QCOMPARE(d.out.phase, TrialPhase::running);
    QCOMPARE(d.out.cues.timeLeft_s, 0.0);
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::between);
}

void TestSphereApexTask::markAtTheLastTickWins() {
    Driver d(shortTrials());
    d.startRunning();
    d.ticks(48);
    d.in.mark = true;
    QCOMPARE(d.tick().events, bits::kMarked);
}

void TestSphereApexTask::pauseStopsEveryClock() {
    Driver d(shortTrials());
    d.startRunning();
    d.ticks(9);
    d.pressApex(0.002);
    d.tick();
    d.in.paused = true;
    for (int n = 0; n < 500; ++n) {
        d.tick();
        QCOMPARE(d.out.events, 0u);
        QCOMPARE(d.out.phase, TrialPhase::running);
        QVERIFY(d.out.tissue.tools[0].force.z() > 0.9); // contact answers; the supervisor ramps
        QVERIFY(std::abs(d.out.cues.timeLeft_s - 0.039) < 1e-12);
    }
    d.in.paused = false;
    d.ticks(38);
    QCOMPARE(d.out.events, 0u);
    QCOMPARE(d.tick().events, bits::kTimedOut); // 11 + 39 ticks
    d.ticks(5);                                 // into `between`
    d.in.paused = true;
    d.ticks(500);
    QCOMPARE(d.out.phase, TrialPhase::between);
    d.in.paused = false;
    d.ticks(15);
    QCOMPARE(d.out.phase, TrialPhase::between); // 20 in all
    d.tick();
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QCOMPARE(d.out.trial, std::uint16_t{1});
}

void TestSphereApexTask::finishesAfterTheLastTrial() {
    Driver d(shortTrials(3));
    d.startRunning();
    int marks = 0;
    int starts = 1;
    int changes = 1;
    int finished = 0;
    for (int n = 0; n < 1000; ++n) {
        d.in.mark = d.out.phase == TrialPhase::running && d.out.events == 0;
        d.tick();
        marks += (d.out.events & bits::kMarked) != 0;
        starts += (d.out.events & bits::kTrialStarted) != 0;
        changes += (d.out.events & bits::kSceneChanged) != 0;
        if ((d.out.events & bits::kFinished) != 0) {
            ++finished;
            QCOMPARE(d.out.phase, TrialPhase::finished);
            QCOMPARE(d.out.trial, std::uint16_t{2});
        }
    }
    QCOMPARE(marks, 3);
    QCOMPARE(starts, 3);
    QCOMPARE(changes, 3);
    QCOMPARE(finished, 1);
    QCOMPARE(d.out.phase, TrialPhase::finished);
    d.pressApex(0.004);
    QCOMPARE(d.tick().tissue.tools[0].force.norm(), 0.0);
}

QTEST_APPLESS_MAIN(TestSphereApexTask)
#include "test_sphere_apex_task.moc"
