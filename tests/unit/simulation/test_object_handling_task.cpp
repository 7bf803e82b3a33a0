// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/units.h"
#include "handling_driver.h"

#include <QtTest>
#include <cstring>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::LaparoscopyStep;
using core::TrialPhase;
namespace bits = core::event_bits;
namespace q = handling_quantity;

namespace {

LaparoscopyStep stepOf(const HandlingDriver& d) {
    return d.out.cues.exercise.of<core::LaparoscopyCues>().step;
}

/// From grasped to let go in the target.
void carryToTarget(HandlingDriver& d, double height_m = 0.045) {
    const double grip = d.tool().p_WT.z();
    d.moveBy(Vec3(0.0, 0.0, height_m), 0.6);
    d.moveTo(d.overTarget(d.tool().p_WT.z()), 0.6);
    d.moveTo(d.overTarget(grip), 0.6);
    d.jawTo(2.0 * d.parameters.radius_m + 0.006, 0.3);
}

ObjectHandlingParameters threeToWeigh() {
    ObjectHandlingParameters p = oneOvary();
    p.task = HandlingTask::weigh;
    p.objects = 3;
    p.object.stiffness_N_per_m = 900.0;
    p.object.friction = 0.4;
    p.massLow_kg = 0.015;
    p.massHigh_kg = 0.045;
    p.placesRadius_m = 0.040;
    p.squeezeLimit_N = 3.0;
    p.liftHeight_m = 0.020;
    return p;
}

} // namespace

/// What object handling asks for, and what it says.
class TestObjectHandlingTask : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void trialsFollowOneAnother();
    void liftedCarriedPlacedAndDone();
    void pushedThereDoesNotCount();
    void timeEndsIt();
    void tooLooseSlips();
    void droppedFromTheAir();
    void aDropIsToldOnce();
    void overSqueezeIsToldOnceAndRearmed();
    void pauseKeepsTheGrip();
    void weighingBySeed();
    void anyObjectEndsAWeighing();
    void cuesFollowTheLevel();
    void notANumberTouchesNothing();
    void sameInputsSameBits();
};

void TestObjectHandlingTask::trialsFollowOneAnother() {
    HandlingDriver d(oneOvary());
    QCOMPARE(d.tick().phase, TrialPhase::idle);
    d.in.started = true;
    QCOMPARE(d.tick().phase, TrialPhase::ready);
    QCOMPARE(d.out.events & bits::kSceneChanged, bits::kSceneChanged);
    d.in.forceReady = true;
    QCOMPARE(d.tick().phase, TrialPhase::running);
    QCOMPARE(d.out.events & bits::kTrialStarted, bits::kTrialStarted);
    const Vec3 first = d.body().p_W;
    d.graspObject();
    carryToTarget(d);
    while ((d.out.events & bits::kCompleted) == 0)
        d.tick();
    QCOMPARE(d.out.phase, TrialPhase::running); // the last tick still has the object
    QCOMPARE(d.tick().phase, TrialPhase::between);
    QCOMPARE(d.force().norm(), 0.0);
    QVERIFY(!d.out.cues.exercise.of<core::LaparoscopyCues>().objectShown);
    d.ticks(20);
    QCOMPARE(d.out.phase, TrialPhase::ready);
    QCOMPARE(d.out.trial, std::uint16_t{1});
    QVERIFY((d.body().p_W - first).norm() > 1e-4);
    d.tick();
    d.graspObject();
    carryToTarget(d);
    d.ticks(600);
    QCOMPARE(d.out.phase, TrialPhase::finished);
    QCOMPARE(d.events & bits::kFinished, bits::kFinished);
}

void TestObjectHandlingTask::liftedCarriedPlacedAndDone() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    QCOMPARE(stepOf(d), LaparoscopyStep::grasp);
    d.graspObject();
    QCOMPARE(stepOf(d), LaparoscopyStep::lift);
    const double grip = d.tool().p_WT.z();
    d.moveBy(Vec3(0.0, 0.0, 0.029), 0.5);
    QCOMPARE(stepOf(d), LaparoscopyStep::lift);
    d.moveBy(Vec3(0.0, 0.0, 0.003), 0.2);
    QCOMPARE(stepOf(d), LaparoscopyStep::carry);
    d.moveTo(d.overTarget(d.tool().p_WT.z()), 0.6);
    QCOMPARE(stepOf(d), LaparoscopyStep::place);
    d.moveTo(d.overTarget(grip), 0.6);
    QCOMPARE(d.q(q::kDwell), 0.0); // still held
    d.jawTo(2.0 * d.parameters.radius_m + 0.006, 0.3);
    QCOMPARE(d.events & bits::kReleased, bits::kReleased);
    int ticks = 0;
    for (; (d.events & bits::kCompleted) == 0 && ticks < 1000; ++ticks)
        d.tick();
    QVERIFY(ticks > 50 && ticks < 400); // hold_s = 0.2 s once it lies still
    QCOMPARE(stepOf(d), LaparoscopyStep::done);
    QCOMPARE(d.q(q::kDwell), 1.0);
    QVERIFY((d.events & (bits::kSlipped | bits::kDamaged)) == 0);
}

void TestObjectHandlingTask::pushedThereDoesNotCount() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.graspObject();
    carryToTarget(d, 0.010); // too low
    d.ticks(1000);
    QVERIFY((d.events & bits::kCompleted) == 0);
    QCOMPARE(stepOf(d), LaparoscopyStep::grasp); // once more
}

void TestObjectHandlingTask::timeEndsIt() {
    ObjectHandlingParameters p = oneOvary();
    p.trialLimit_s = 0.050;
    HandlingDriver d(p);
    d.startRunning();
    d.ticks(48);
    QVERIFY((d.events & bits::kTimedOut) == 0);
    d.tick();
    QCOMPARE(d.out.events & bits::kTimedOut, bits::kTimedOut);
    QCOMPARE(d.tick().phase, TrialPhase::between);
}

void TestObjectHandlingTask::tooLooseSlips() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.graspObject(0, 0.0004); // N = 0.12 N carries 0.06 N of its 0.098 N
    d.largestStep_N = 0.0;
    d.moveBy(Vec3(0.0, 0.0, 0.040), 1.5);
    d.ticks(300);
    QCOMPARE(d.events & bits::kSlipped, bits::kSlipped);
    QVERIFY((d.events & bits::kReleased) == 0);
    QCOMPARE(d.q(q::kHeld), 0.0);
    QVERIFY2(d.largestStep_N < 0.005, qPrintable(QString::number(d.largestStep_N))); // sliding out is no jerk
    QVERIFY(std::abs(d.body().bedDepth_m() - d.body().restDepth_m()) < 1e-5);        // it lies again
    // A jaw that stays closed does not catch it again; an opened one does.
    QCOMPARE(stepOf(d), LaparoscopyStep::grasp);
    d.graspObject();
    QCOMPARE(d.q(q::kHeld), 1.0);
}

void TestObjectHandlingTask::droppedFromTheAir() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.graspObject();
    d.moveBy(Vec3(0.0, 0.0, 0.040), 0.6);
    d.jawTo(2.0 * d.parameters.radius_m + 0.006, 0.02);
    d.ticks(500);
    QCOMPARE(d.events & bits::kSlipped, bits::kSlipped);
    QVERIFY(d.body().v_W.norm() < 1e-3);
}

/// Set down and let go it is no drop, nor does that make the slip that comes after it count again when it
/// lands.
void TestObjectHandlingTask::aDropIsToldOnce() {
    HandlingDriver d(oneOvary());
    int told = 0;
    d.observe = [&](HandlingDriver& now) { told += (now.out.events & bits::kSlipped) != 0 ? 1 : 0; };
    d.startRunning();
    d.graspObject();
    d.open(); // where it lies
    d.ticks(5);
    QCOMPARE(told, 0);
    d.graspObject(0, 0.0004); // too loose: it slides out on the way up and falls from there
    d.moveBy(Vec3(0.0, 0.0, 0.060), 0.25);
    d.ticks(500);
    QCOMPARE(d.q(q::kHeld), 0.0);
    QCOMPARE(told, 1);
    d.graspObject();
    d.moveBy(Vec3(0.0, 0.0, 0.040), 0.6);
    d.jawTo(2.0 * d.parameters.radius_m + 0.006, 0.02); // dropped on purpose: it lands hard, once
    d.ticks(500);
    QCOMPARE(told, 2);
}

void TestObjectHandlingTask::overSqueezeIsToldOnceAndRearmed() {
    HandlingDriver d(oneOvary());
    int damaged = 0;
    d.observe = [&](HandlingDriver& now) { damaged += (now.out.events & bits::kDamaged) != 0 ? 1 : 0; };
    d.startRunning();
    d.graspObject(0, 0.004);
    const ElasticLaw law = elasticOf(d.parameters.object);
    QVERIFY(law.tension(0.004) < d.parameters.squeezeLimit_N);
    QCOMPARE(damaged, 0);
    d.jawTo(d.openingFor(0.0065), 0.2);
    QVERIFY(d.q(q::kSqueeze) > d.parameters.squeezeLimit_N);
    QCOMPARE(damaged, 1);
    d.jawTo(d.openingFor(0.0055), 0.2);
    QVERIFY(d.q(q::kSqueeze) < d.parameters.squeezeLimit_N &&
            d.q(q::kSqueeze) > 0.8 * d.parameters.squeezeLimit_N);
    d.jawTo(d.openingFor(0.0065), 0.2);
    QCOMPARE(damaged, 1); // not let off enough
    d.jawTo(d.openingFor(0.003), 0.2);
    d.jawTo(d.openingFor(0.0065), 0.2);
    QCOMPARE(damaged, 2);
}

void TestObjectHandlingTask::pauseKeepsTheGrip() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.graspObject();
    d.moveBy(Vec3(0.0, 0.0, 0.040), 0.6);
    const double left = d.out.cues.timeLeft_s;
    d.in.paused = true;
    d.open();
    d.ticks(200);
    QCOMPARE(d.q(q::kHeld), 1.0);
    QCOMPARE(d.out.cues.timeLeft_s, left);
    d.tool().jaw_rad = d.jawFor(d.openingFor(0.002));
    d.in.paused = false;
    d.ticks(10);
    QCOMPARE(d.q(q::kHeld), 1.0);
    QVERIFY((d.events & (bits::kSlipped | bits::kReleased)) == 0);
}

void TestObjectHandlingTask::weighingBySeed() {
    ObjectHandlingParameters p = threeToWeigh();
    p.trials = 32;
    std::array<int, 3> heaviest{};
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const auto plan = planObjectHandlingTrials(p, seed);
        for (const ObjectHandlingTrial& trial : plan) {
            ++heaviest[static_cast<std::size_t>(trial.heaviest)];
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY(trial.mass_kg[i] >= p.massLow_kg && trial.mass_kg[i] <= p.massHigh_kg);
                if (static_cast<int>(i) != trial.heaviest)
                    QVERIFY(trial.mass_kg[static_cast<std::size_t>(trial.heaviest)] >=
                            p.massRatio * trial.mass_kg[i] - 1e-12);
                QVERIFY(trial.place_m[i].norm() <= p.placesRadius_m + 1e-12);
                QVERIFY((trial.place_m[i] - trial.target_m).norm() >= targetSpacing_m(p) - 1e-12);
                for (std::size_t k = 0; k < i; ++k)
                    QVERIFY((trial.place_m[i] - trial.place_m[k]).norm() >= objectSpacing_m(p) - 1e-12);
            }
        }
        QVERIFY(std::memcmp(&plan[0].mass_kg, &planObjectHandlingTrials(p, seed)[0].mass_kg,
                            sizeof(plan[0].mass_kg)) == 0);
    }
    for (const int count : heaviest) // 960 draws: 320 ± 15
        QVERIFY(count > 260 && count < 380);
}

void TestObjectHandlingTask::anyObjectEndsAWeighing() {
    for (const bool heavy : {true, false}) {
        HandlingDriver d(threeToWeigh(), 9);
        d.startRunning();
        const int heaviest = d.trial().heaviest;
        const auto i = static_cast<std::size_t>(heavy ? heaviest : (heaviest + 1) % 3);
        d.graspObject(i, 0.0012);
        d.moveBy(Vec3(0.0, 0.0, 0.030), 0.6);
        d.ticks(5);
        QVERIFY(std::abs(d.force().z() + d.trial().mass_kg[i] * core::kStandardGravity) <
                1e-9); // what is felt tells them apart
        d.moveBy(Vec3(0.0, 0.0, -0.030), 0.6);
        carryToTarget(d);
        d.ticks(600);
        QCOMPARE(d.events & bits::kCompleted, bits::kCompleted);
    }
}

void TestObjectHandlingTask::cuesFollowTheLevel() {
    ObjectHandlingParameters p = oneOvary();
    for (const bool object : {false, true})
        for (const bool bars : {false, true}) {
            p.cues = {"tool"};
            if (object)
                p.cues.push_back("object");
            if (bars)
                p.cues.push_back("bars");
            HandlingDriver d(p);
            d.startRunning();
            d.graspObject();
            const core::LaparoscopyCues& shown = d.out.cues.exercise.of<core::LaparoscopyCues>();
            QVERIFY(shown.present);
            QCOMPARE(shown.objectShown, object);
            QCOMPARE(shown.targetShown, object);
            QCOMPARE(shown.bodies, object ? 1 : 0);
            QCOMPARE(shown.body[0].heldBy, std::uint8_t(object ? 1 : 0));
            QCOMPARE(shown.body[0].radius_m, object ? p.radius_m : 0.0);
            QCOMPARE(shown.targetRadius_m, object ? p.targetRadius_m : 0.0);
            QCOMPARE(shown.squeezeShown, bars);
            QCOMPARE(shown.squeeze_N[0] > 0.0, bars);
            QCOMPARE(shown.squeezeLimit_N, bars ? p.squeezeLimit_N : 0.0);
            QVERIFY(!d.out.cues.objectShown);
        }
}

void TestObjectHandlingTask::notANumberTouchesNothing() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.tool().p_WT = Vec3(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
    d.scene.respond(d.source.next(0), d.in, d.out);
    QCOMPARE(d.force().norm(), 0.0);
    d.in.tools.count = 0;
    d.scene.respond(d.source.next(0), d.in, d.out);
    QCOMPARE(d.out.tissue.count, 0);
    QVERIFY(d.body().p_W.allFinite());
}

void TestObjectHandlingTask::sameInputsSameBits() {
    const auto run = [] {
        HandlingDriver d(threeToWeigh(), 4);
        std::vector<double> seen;
        d.observe = [&](HandlingDriver& now) {
            seen.insert(seen.end(),
                        {now.force().x(), now.force().y(), now.force().z(), now.out.storedEnergy_J});
            seen.insert(seen.end(), now.out.quantities.begin(), now.out.quantities.end());
        };
        d.startRunning();
        d.tool().jaw_rad = 0.0;
        d.moveTo(d.body(1).p_W + Vec3(0.001, 0.0, 0.004), 0.5); // pushes one away
        d.moveBy(Vec3(0.01, 0.01, 0.03), 0.4);
        d.graspObject(2, 0.0012);
        carryToTarget(d);
        return seen;
    };
    const auto a = run();
    const auto b = run();
    QCOMPARE(a.size(), b.size());
    QVERIFY(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

QTEST_APPLESS_MAIN(TestObjectHandlingTask)
#include "test_object_handling_task.moc"
