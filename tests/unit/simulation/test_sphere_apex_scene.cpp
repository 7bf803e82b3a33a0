// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/random.h"
#include "simulation/exercises/sphere_apex/sphere_apex_scene.h"

#include <QtTest>
#include <bit>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using core::TrialPhase;
using core::Vec3;
namespace bits = core::event_bits;

namespace {

SphereApexParameters shortTrials(int trials = 3) {
    SphereApexParameters p;
    p.trials = trials;
    p.trialLimit_s = 0.050;
    p.betweenTrials_s = 0.020;
    p.cues = {"object", "tool"};
    return p;
}

/// Steps a scene as the loop does, with one tool that hovers unless told otherwise.
struct Driver {
    explicit Driver(const SphereApexParameters& parameters, std::uint64_t seed = 42)
        : scene(parameters, seed) {
        in.tools.count = 1;
        hover();
    }

    const SceneOutput& tick() {
        scene.respond(source.next(0), in, out);
        in.mark = false;
        return out;
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i)
            tick();
    }
    /// Into the first running tick of the first trial.
    void startRunning() {
        in.started = true;
        in.forceReady = true;
        ticks(2);
    }
    void hover() { in.tools.tools[0].p_WT = Vec3(0, 0, 0.05); }
    void pressApex(double depth_m) {
        const auto& c = scene.trials()[out.trial].centre_m;
        in.tools.tools[0].p_WT = Vec3(c.x(), c.y(), 0.020 - depth_m);
    }
    void button(bool down) { in.tools.tools[0].buttons = down ? core::kButtonMark : 0; }

    realtime::TickSource source;
    SphereApexScene scene;
    SceneInput in;
    SceneOutput out;
};

} // namespace

class TestSphereApexScene : public QObject {
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
    void objectIsGoneBetweenTrials();
    void nextTrialHasItsOwnObject();
    void finishesAfterTheLastTrial();
    void forceAndStateAreReported();
    void everyToolTouches();
    void contactEventsComeOnce();
    void cuesFollowTheLevel();
    void notANumberTouchesNothing();
    void sameInputsSameBits();
};

void TestSphereApexScene::waitsForStart() {
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

void TestSphereApexScene::waitsForForce() {
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

void TestSphereApexScene::markByButtonEdge() {
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

void TestSphereApexScene::heldButtonIsNoMark() {
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

void TestSphereApexScene::edgeDuringPauseIsNoMark() {
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

void TestSphereApexScene::otherButtonsAndToolsDoNotMark() {
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

void TestSphereApexScene::markByCommand() {
    Driver d(shortTrials());
    d.startRunning();
    d.ticks(3);
    d.in.mark = true;
    QCOMPARE(d.tick().events, bits::kMarked);
}

void TestSphereApexScene::marksCountOnlyWhileRunning() {
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

void TestSphereApexScene::timesOutAtItsTick() {
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

void TestSphereApexScene::markAtTheLastTickWins() {
    Driver d(shortTrials());
    d.startRunning();
    d.ticks(48);
    d.in.mark = true;
    QCOMPARE(d.tick().events, bits::kMarked);
}

void TestSphereApexScene::pauseStopsEveryClock() {
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

void TestSphereApexScene::objectIsGoneBetweenTrials() {
    Driver d(shortTrials());
    d.startRunning();
    d.pressApex(0.004);
    d.tick();
    d.in.mark = true;
    d.tick();
    QVERIFY(d.out.tissue.tools[0].force.norm() > 1.0);
    QVERIFY(d.out.storedEnergy_J > 0.0);
    for (int n = 0; n < 20; ++n) {
        d.tick();
        QCOMPARE(d.out.phase, TrialPhase::between);
        QCOMPARE(d.out.tissue.tools[0].force.norm(), 0.0);
        QCOMPARE(d.out.storedEnergy_J, 0.0);
        QCOMPARE(d.out.contactStiffness_N_per_m, 0.0);
        QVERIFY(!d.out.cues.objectShown);
        QCOMPARE(d.out.p_WProxy[0], d.in.tools.tools[0].p_WT);
    }
    d.tick();
    QCOMPARE(d.out.events & bits::kSceneChanged, bits::kSceneChanged);
}

void TestSphereApexScene::nextTrialHasItsOwnObject() {
    Driver d(shortTrials());
    d.startRunning();
    const Vec3 first = d.out.cues.p_WObject;
    d.in.mark = true;
    d.tick();
    d.ticks(22);
    QCOMPARE(d.out.trial, std::uint16_t{1});
    QCOMPARE(d.out.phase, TrialPhase::running);
    QVERIFY((d.out.cues.p_WObject - first).norm() > 1e-6);
    d.pressApex(0.002);
    QVERIFY(std::abs(d.tick().tissue.tools[0].force.z() - 1.0) < 1e-9); // apex of trial 1, 500 N/m · 2 mm
}

void TestSphereApexScene::finishesAfterTheLastTrial() {
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

void TestSphereApexScene::forceAndStateAreReported() {
    Driver d(shortTrials());
    d.startRunning();
    d.pressApex(0.003);
    d.tick();
    QVERIFY(std::abs(d.out.tissue.tools[0].force.z() - 1.5) < 1e-9);
    QCOMPARE(d.out.tissue.tools[0].torque.norm(), 0.0);
    QVERIFY(std::abs(d.out.storedEnergy_J - 0.5 * 500.0 * 9e-6) < 1e-12);
    QCOMPARE(d.out.contactStiffness_N_per_m, 500.0);
    QVERIFY(std::abs(d.out.p_WProxy[0].z() - 0.020) < 1e-12); // drawn at the apex, not 3 mm inside
    QCOMPARE(d.out.display[0].normalForce_N, 0.0);
}

void TestSphereApexScene::everyToolTouches() {
    SphereApexParameters parameters = shortTrials();
    parameters.frictionLow = parameters.frictionHigh = 0.3;
    Driver d(parameters);
    d.in.tools.count = 4;
    const auto& c = d.scene.trials()[0].centre_m;
    const double far = c.x() > 0.0 ? -0.05 : 0.05;
    d.in.tools.tools[0].p_WT = Vec3(c.x(), c.y(), 0.018);
    d.in.tools.tools[1].p_WT = Vec3(far, c.y(), -0.001);
    d.in.tools.tools[2].p_WT = Vec3(0, 0, 0.05);
    d.in.tools.tools[3].p_WT = Vec3(far, c.y(), -0.003);
    d.startRunning();
    QCOMPARE(d.out.tissue.count, 4);
    QVERIFY(std::abs(d.out.tissue.tools[0].force.z() - 1.0) < 1e-9);
    QVERIFY(std::abs(d.out.tissue.tools[1].force.z() - 0.5) < 1e-9);
    QCOMPARE(d.out.tissue.tools[2].force.norm(), 0.0);
    QVERIFY(std::abs(d.out.tissue.tools[3].force.z() - 1.5) < 1e-9);
    QVERIFY(std::abs(d.out.storedEnergy_J - 250.0 * (4e-6 + 1e-6 + 9e-6)) < 1e-12);
    d.in.tools.tools[1].p_WT.x() += 1e-4; // only its own bristle bends: 1000 N/m · 0.1 mm
    d.tick();
    QVERIFY(std::abs(d.out.tissue.tools[1].force.x() + 0.1) < 1e-9);
    QCOMPARE(d.out.tissue.tools[3].force.x(), 0.0);
}

void TestSphereApexScene::contactEventsComeOnce() {
    Driver d(shortTrials());
    d.startRunning();
    d.pressApex(0.001);
    QCOMPARE(d.tick().events, bits::kContactBegan);
    QCOMPARE(d.tick().events, 0u);
    d.hover();
    QCOMPARE(d.tick().events, bits::kContactEnded);
    QCOMPARE(d.tick().events, 0u);
}

void TestSphereApexScene::cuesFollowTheLevel() {
    Driver shown(shortTrials());
    shown.in.force = core::ForceState::on;
    QVERIFY(!shown.tick().cues.objectShown);
    shown.startRunning();
    QVERIFY(shown.out.cues.objectShown);
    QCOMPARE(shown.out.cues.objectRadius_m, 0.020);
    const auto& centre = shown.scene.trials()[0].centre_m;
    QCOMPARE(shown.out.cues.p_WObject, Vec3(centre.x(), centre.y(), 0.0));
    QCOMPARE(shown.out.cues.force, core::ForceState::on);
    QCOMPARE(shown.out.cues.phase, TrialPhase::running);

    SphereApexParameters hapticsAlone = shortTrials();
    hapticsAlone.cues = {"tool", "arrow", "bars", "objects"}; // a longer word is another word
    Driver hidden(hapticsAlone);
    hidden.in.started = true;
    hidden.in.forceReady = true;
    for (int n = 0; n < 400; ++n) {
        hidden.tick();
        QVERIFY(!hidden.out.cues.objectShown);
        QCOMPARE(hidden.out.cues.p_WObject.norm(), 0.0);
        QCOMPARE(hidden.out.cues.objectRadius_m, 0.0);
    }
    QCOMPARE(hidden.out.phase, TrialPhase::finished);
}

void TestSphereApexScene::notANumberTouchesNothing() {
    Driver d(shortTrials());
    d.startRunning();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf})
        for (int axis = 0; axis < 3; ++axis) {
            d.pressApex(0.001);
            d.in.tools.tools[0].p_WT[axis] = bad;
            QCOMPARE(d.tick().tissue.tools[0].force.norm(), 0.0);
            d.pressApex(0.001);
            d.in.tools.tools[0].v_WT[axis] = bad;
            QCOMPARE(d.tick().tissue.tools[0].force.norm(), 0.0);
            d.in.tools.tools[0].v_WT.setZero();
        }
    d.tick();
    QVERIFY(std::abs(d.out.tissue.tools[0].force.z() - 0.5) < 1e-9); // and nothing of it stays
    d.in.tools.count = 99;
    QCOMPARE(d.tick().tissue.count, core::kMaxTools);
}

void TestSphereApexScene::sameInputsSameBits() {
    const auto run = [](std::uint64_t seed) {
        SphereApexParameters parameters = shortTrials(5);
        parameters.trialLimit_s = 1.0;
        parameters.stiffnessVariation = 0.4;
        parameters.frictionHigh = 0.5;
        parameters.dimpleDepth_m = 0.001;
        Driver d(parameters, seed);
        d.in.started = true;
        core::Random random(7);
        std::uint64_t digest = 0;
        for (int n = 0; n < 6000; ++n) {
            d.in.forceReady = random.below(3) != 0;
            d.in.paused = n > 500 && n < 700;
            d.in.mark = random.below(900) == 0;
            d.in.tools.tools[0].p_WT +=
                Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) * 5e-4;
            d.in.tools.tools[0].p_WT.z() = std::min(0.021, d.in.tools.tools[0].p_WT.z());
            d.in.tools.tools[0].v_WT =
                Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) * 0.2;
            d.tick();
            for (const double x : {d.out.tissue.tools[0].force.x(), d.out.tissue.tools[0].force.y(),
                                   d.out.tissue.tools[0].force.z(), d.out.storedEnergy_J})
                digest = std::rotl(digest, 9) ^ std::bit_cast<std::uint64_t>(x);
            digest = std::rotl(digest, 3) ^ d.out.events ^ (static_cast<std::uint64_t>(d.out.phase) << 32);
        }
        return digest;
    };
    QCOMPARE(run(1), run(1));
    QVERIFY(run(1) != run(2));
}

QTEST_APPLESS_MAIN(TestSphereApexScene)
#include "test_sphere_apex_scene.moc"
