// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/scene_parameters.h"
#include "simulation/trial_course.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using core::TrialPhase;
using Turn = TrialCourse::Turn;
namespace bits = core::event_bits;

namespace {

/// A course with its output of the present tick.
struct Run {
    TrialCourse course;
    SceneOutput out;
    SceneInput in;

    Turn tick() {
        out = SceneOutput{};
        const Turn turn = course.advance(in, out);
        course.write(in, out);
        return turn;
    }
    Turn tick(const TrialCourse::Signals& now) {
        out = SceneOutput{};
        return course.advance(now, out);
    }
    /// Starts the session and goes to the first running tick.
    void begin() {
        in.started = in.forceReady = true;
        (void)tick();
        QCOMPARE(tick(), Turn::runs);
    }
};

} // namespace

class TestTrialCourse : public QObject {
    Q_OBJECT
private slots:
    void plannedTrialsFollowOneAnother();
    void theClockOfATrialCountsItsFirstTick();
    void nothingMovesWhilePaused();
    void aTrialThatIsNotPlannedWaitsForItsWord();
    void stopLeavesATrialThatDidNotBegin();
    void durationsLastAtLeastOneTick();
};

void TestTrialCourse::plannedTrialsFollowOneAnother() {
    Run run{{2, TrialCourse::kNoLimit, 3}, {}, {}};
    run.in.forceReady = true;
    run.in.force = core::ForceState::on;
    QCOMPARE(run.tick(), Turn::waits); // not before the start command
    QVERIFY(run.out.phase == TrialPhase::idle && run.out.events == 0);
    run.in.started = true;
    QCOMPARE(run.tick(), Turn::prepares); // the force of the tick before is not that of these objects
    QVERIFY(run.out.phase == TrialPhase::ready && run.out.events == bits::kSceneChanged);
    run.in.forceReady = false;
    QCOMPARE(run.tick(), Turn::waits);
    run.in.forceReady = true;
    QCOMPARE(run.tick(), Turn::runs);
    QVERIFY(run.out.phase == TrialPhase::running && run.out.events == bits::kTrialStarted);
    QCOMPARE(run.tick(), Turn::runs);
    run.course.end(bits::kCompleted, run.out); // the tick that ends it still has the objects
    QVERIFY(run.course.present() && run.out.events == bits::kCompleted);
    QCOMPARE(run.tick(), Turn::leaves);
    QVERIFY(!run.course.present() && run.out.phase == TrialPhase::between && run.out.events == 0);
    for (int waited = 1; waited < 3; ++waited)
        QCOMPARE(run.tick(), Turn::waits);
    QCOMPARE(run.out.trial, std::uint16_t{0});
    QCOMPARE(run.tick(), Turn::prepares); // three ticks without objects
    QVERIFY(run.out.trial == 1 && run.out.cues.trial == 1 && run.out.cues.phase == TrialPhase::ready &&
            run.out.cues.force == core::ForceState::on);
    QCOMPARE(run.tick(), Turn::runs);
    run.course.end(bits::kTimedOut, run.out);
    QCOMPARE(run.tick(), Turn::leaves); // no interval after the last one
    QVERIFY(run.out.phase == TrialPhase::finished && run.out.events == bits::kFinished);
    QCOMPARE(run.tick(), Turn::waits);
    QVERIFY(run.out.phase == TrialPhase::finished && run.out.events == 0);
    QCOMPARE(run.course.clock(), std::uint64_t{2}); // since the trial
}

void TestTrialCourse::theClockOfATrialCountsItsFirstTick() {
    Run run{{1, 3, 1}, {}, {}};
    run.begin();
    QCOMPARE(run.course.clock(), std::uint64_t{1});
    QVERIFY(!run.course.timeIsUp());
    QCOMPARE(run.course.timeLeft_s(), 0.002);
    (void)run.tick();
    (void)run.tick();
    QVERIFY(run.course.timeIsUp());
    QCOMPARE(run.course.timeLeft_s(), 0.0);
    QCOMPARE(run.tick(), Turn::runs); // the scene decides whether this ends it
    QCOMPARE(run.course.timeLeft_s(), 0.0);
}

void TestTrialCourse::nothingMovesWhilePaused() {
    Run run{{2, 10, 5}, {}, {}};
    run.begin();
    run.course.end(bits::kMarked, run.out);
    run.in.paused = true;
    for (int n = 0; n < 20; ++n)
        QCOMPARE(run.tick(), Turn::waits);
    QVERIFY(run.course.phase() == TrialPhase::running && run.course.clock() == 1 && run.out.events == 0);
    run.in.paused = false;
    QCOMPARE(run.tick(), Turn::leaves);
}

void TestTrialCourse::aTrialThatIsNotPlannedWaitsForItsWord() {
    Run run{{TrialCourse::kUnplanned, TrialCourse::kNoLimit, 2}, {}, {}};
    QCOMPARE(run.tick({.forceReady = true}), Turn::waits);
    QCOMPARE(run.tick({.forceReady = true, .next = true}), Turn::prepares);
    QCOMPARE(run.tick({.forceReady = true}), Turn::runs);
    QVERIFY(!run.course.timeIsUp());
    run.course.end(bits::kCompleted, run.out);
    QCOMPARE(run.tick({.next = true}), Turn::leaves);
    QCOMPARE(run.tick({.next = true}), Turn::waits); // an early word waits for the interval
    QCOMPARE(run.tick({}), Turn::waits);             // and the interval for a word
    QCOMPARE(run.tick({.next = true}), Turn::prepares);
    QCOMPARE(run.course.trial(), std::size_t{1});
    QCOMPARE(run.tick({.forceReady = true}), Turn::runs);
    QCOMPARE(run.tick({.stop = true}), Turn::runs); // a running trial ends by its scene alone
    run.course.end(bits::kFailed, run.out);
    QCOMPARE(run.tick({.stop = true}), Turn::leaves);
    QVERIFY(run.course.phase() == TrialPhase::finished && run.out.events == bits::kFinished);
}

void TestTrialCourse::stopLeavesATrialThatDidNotBegin() {
    for (const bool prepared : {false, true}) {
        Run run{{TrialCourse::kUnplanned, TrialCourse::kNoLimit, 2}, {}, {}};
        if (prepared)
            QCOMPARE(run.tick({.next = true}), Turn::prepares);
        QCOMPARE(run.tick({.next = true, .stop = true}), prepared ? Turn::leaves : Turn::waits);
        QVERIFY(run.course.phase() == TrialPhase::finished && run.out.events == bits::kFinished);
    }
}

void TestTrialCourse::durationsLastAtLeastOneTick() {
    QCOMPARE(ticksOf(0.25), std::uint64_t{250});
    QCOMPARE(ticksOf(0.0), std::uint64_t{1});
    QCOMPARE(ticksOf(-3.0), std::uint64_t{1});
    QVERIFY(hasCue({"bars", "object"}, "object") && !hasCue({"bars"}, "object"));
}

QTEST_APPLESS_MAIN(TestTrialCourse)
#include "test_trial_course.moc"
