// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/random.h"
#include "scene_driver.h"

#include <QtTest>
#include <bit>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using core::TrialPhase;
using core::Vec3;
namespace bits = core::event_bits;

class TestSphereApexScene : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void forceInADimpleIsNoSteeperThanStated();
    void objectIsGoneBetweenTrials();
    void nextTrialHasItsOwnObject();
    void forceAndStateAreReported();
    void everyToolTouches();
    void contactEventsComeOnce();
    void cuesFollowTheLevel();
    void notANumberTouchesNothing();
    void aDomeThatCannotBeMadeIsNoOther();
    void sameInputsSameBits();
};

/// Between points 1 µm apart, at every place and depth of the decoy.
void TestSphereApexScene::forceInADimpleIsNoSteeperThanStated() {
    SphereApexParameters p = shortTrials();
    p.dimpleDepth_m = 0.0008;
    p.dimpleRadius_m = 0.003;
    p.trialLimit_s = 100.0;
    Driver d(p);
    d.startRunning();
    const auto& trial = d.scene.trials()[0];
    const core::Vec2 centre = trial.dimpleCentre_m;
    constexpr double kStep_m = 1e-6;
    double steepest = 0.0;
    const auto forceAt = [&d](const Vec3& p_WT) {
        d.in.tools.tools[0].p_WT = p_WT;
        return Vec3(d.tick().tissue.tools[0].force);
    };
    for (const double depth_m : {0.001, 0.003, 0.005})
        for (int i = -10; i <= 10; ++i)
            for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
                const core::Vec2 place = centre + core::Vec2(0.1 * i * p.dimpleRadius_m, 0.0);
                const double fromTop_m = (place - core::Vec2(trial.centre_m.x(), trial.centre_m.y())).norm();
                const double surface_m = std::sqrt(p.radius_m * p.radius_m - fromTop_m * fromTop_m);
                const Vec3 at(place.x(), place.y(), surface_m - depth_m);
                const Vec3 before = forceAt(at);
                const double stated = d.out.contactStiffness_N_per_m;
                const double found = (forceAt(at + kStep_m * along) - before).norm() / kStep_m;
                QVERIFY2(found <= 1.001 * stated,
                         qPrintable(QStringLiteral("%1 N/m of %2 stated").arg(found).arg(stated)));
                steepest = std::max(steepest, found / stated);
            }
    QVERIFY2(steepest > 0.3, qPrintable(QString::number(steepest))); // the bound is no empty one
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

void TestSphereApexScene::forceAndStateAreReported() {
    Driver d(shortTrials());
    d.out.p_WProxy.fill(Vec3(7, 7, 7));
    d.startRunning();
    d.pressApex(0.003);
    d.tick();
    QVERIFY(std::abs(d.out.tissue.tools[0].force.z() - 1.5) < 1e-9);
    QCOMPARE(d.out.tissue.tools[0].torque.norm(), 0.0);
    QVERIFY(std::abs(d.out.storedEnergy_J - 0.5 * 500.0 * 9e-6) < 1e-12);
    QCOMPARE(d.out.contactStiffness_N_per_m, 500.0);
    QVERIFY(std::abs(d.out.p_WProxy[0].z() - 0.020) < 1e-12); // drawn at the apex, not 3 mm inside
    QCOMPARE(d.out.display[0].normalForce_N, 0.0);
    for (std::size_t unused = 1; unused < d.out.p_WProxy.size(); ++unused)
        QCOMPARE(d.out.p_WProxy[unused], Vec3(0, 0, 0)); // nothing left from an earlier use of the memory
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

/// A level on meshes whose mesh cannot be made is not done on the exact sphere instead: nothing is felt, and
/// the trial runs out.
void TestSphereApexScene::aDomeThatCannotBeMadeIsNoOther() {
    SphereApexParameters p = shortTrials();
    p.surface = ApexSurface::mesh;
    p.meshEdge_m = -1.0;
    Driver d(p);
    QVERIFY(d.scene.slowModel() == nullptr);
    d.startRunning();
    d.pressApex(0.004);
    std::uint32_t events = 0;
    for (int n = 0; n < 60; ++n) {
        events |= d.tick().events;
        QCOMPARE(d.out.tissue.tools[0].force.norm(), 0.0);
    }
    QCOMPARE(events & bits::kTimedOut, bits::kTimedOut);
    QVERIFY((events & bits::kContactBegan) == 0);
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
