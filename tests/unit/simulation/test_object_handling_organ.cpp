// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/units.h"
#include "handling_driver.h"

#include <QtTest>
#include <cstring>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
namespace bits = core::event_bits;

/// Object handling on a deformable organ that is simulated at 30 Hz.
class TestObjectHandlingOrgan : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void bodySinksInAndLiesStill();
    void liftedOffItWeighsItsWeight();
    void placedOnItWithoutSteps();
    void lateAnswersAreNoSteps();
    void besideTheOrganIsAFloor();
    void withoutItsOrganNothingIsThere();
    void sameInputsSameBits();
};

void TestObjectHandlingOrgan::bodySinksInAndLiesStill() {
    HandlingDriver d(onOrgan(oneOvary()));
    QVERIFY(d.scene.slowModel() != nullptr);
    d.startRunning();
    const Vec3 start = d.body().p_W;
    d.ticks(3000);
    QCOMPARE(d.events & bits::kSlowApplied, bits::kSlowApplied);
    QVERIFY(d.body().v_W.norm() < 1e-3);
    QVERIFY((d.body().p_W - start).head<2>().norm() < 0.002); // it does not roll off
    QVERIFY(start.z() - d.body().p_W.z() > 1e-4);             // the organ gives way under its 0.1 N
    QVERIFY(start.z() - d.body().p_W.z() < 2e-3);
    QCOMPARE(d.force().norm(), 0.0);
}

void TestObjectHandlingOrgan::liftedOffItWeighsItsWeight() {
    HandlingDriver d(onOrgan(oneOvary()));
    d.startRunning();
    d.ticks(1500);
    d.graspObject();
    d.largestStep_N = 0.0;
    d.moveBy(Vec3(0.0, 0.0, 0.040), 1.0);
    d.ticks(200);
    QVERIFY((d.force() - Vec3(0.0, 0.0, -0.010 * core::kStandardGravity)).norm() < 1e-12);
    QVERIFY2(d.largestStep_N < 0.01, qPrintable(QString::number(d.largestStep_N)));
}

/// Grasp, lift, carry, set down, let go: no step in the force, though the organ moves 30 times a second.
void TestObjectHandlingOrgan::placedOnItWithoutSteps() {
    HandlingDriver d(onOrgan(oneOvary()));
    d.startRunning();
    d.ticks(1500);
    const double height = d.body().lifted_m();
    QVERIFY(std::abs(height) < 1e-4);
    d.graspObject();
    const double grip = d.tool().p_WT.z();
    d.moveBy(Vec3(0.0, 0.0, 0.045), 0.8);
    d.moveTo(d.overTarget(d.tool().p_WT.z()), 0.8);
    d.moveTo(d.overTarget(grip - 0.0005), 1.2);
    d.ticks(300);
    QVERIFY2(d.largestStep_N < 0.03, qPrintable(QString::number(d.largestStep_N)));
    d.jawTo(2.0 * d.parameters.radius_m + 0.006, 0.4);
    d.moveBy(Vec3(0.0, 0.0, 0.040), 0.6);
    d.ticks(1500);
    QCOMPARE(d.events & bits::kCompleted, bits::kCompleted);
}

/// Answers that come late or are held back for a while change when the organ follows, not how smoothly.
void TestObjectHandlingOrgan::lateAnswersAreNoSteps() {
    HandlingDriver d(onOrgan(oneOvary()));
    d.startRunning();
    d.tool().jaw_rad = 0.0;
    d.moveTo(Vec3(-0.01, 0.01, 0.010), 0.5);
    d.largestStep_N = 0.0;
    int n = 0;
    d.observe = [&](HandlingDriver& now) {
        ++n;
        const bool held = n % 400 < 150; // 150 ms without an answer, again and again
        now.in.slow = held ? SlowUpdate::notNow : SlowUpdate::asDue;
    };
    d.moveBy(Vec3(0.0, 0.0, -0.0135), 1.0); // 3 mm into it
    QVERIFY(d.force().norm() > 0.2);
    d.moveBy(Vec3(0.02, 0.0, 0.0), 1.5);
    d.ticks(1000);
    QVERIFY2(d.largestStep_N < 0.05, qPrintable(QString::number(d.largestStep_N)));
}

/// A body that is let go beside the organ lies on the floor it stands on, and the organ feels nothing of it;
/// the tip meets it too.
void TestObjectHandlingOrgan::besideTheOrganIsAFloor() {
    ObjectHandlingParameters p = onOrgan(oneOvary());
    p.bedMesh.halfAxisX_m = p.bedMesh.halfAxisY_m = 0.035; // narrower than content may have it
    HandlingDriver d(p);
    d.startRunning();
    d.ticks(500);
    d.graspObject();
    d.moveBy(Vec3(0.0, 0.0, 0.030), 0.5);
    d.moveTo(Vec3(0.050, 0.0, d.tool().p_WT.z()), 0.8);
    d.moveBy(Vec3(0.0, 0.0, -0.035), 0.8);
    d.open();
    d.ticks(2000);
    const double floor_m = -0.028; // its highest point is at 0, it is 28 mm thick
    QVERIFY2(std::abs(d.body().p_W.z() - (floor_m + p.radius_m)) < 1e-3,
             qPrintable(QString::number(d.body().p_W.z())));
    QVERIFY(d.body().v_W.norm() < 1e-3);
    d.moveBy(Vec3(0.0, 0.0, 0.060), 0.5);
    d.moveTo(Vec3(0.0, 0.060, 0.030), 0.5);
    d.tool().jaw_rad = 0.0;
    d.moveTo(Vec3(0.0, 0.060, floor_m - 0.002), 0.5);
    d.ticks(200);
    QVERIFY2(std::abs(d.force().z() - 0.6) < 0.1,
             qPrintable(QString::number(d.force().z()))); // 2 mm of 300 N/m; the mesh's lowest
                                                          // corner may lie 0.3 mm higher
}

/// An organ that cannot be made is no plane: nothing is felt or shown, and the trial runs out.
void TestObjectHandlingOrgan::withoutItsOrganNothingIsThere() {
    ObjectHandlingParameters p = onOrgan(oneOvary());
    p.bedMesh.shape = MeshSource::Shape::none;
    p.trialLimit_s = 2.0;
    HandlingDriver d(p);
    QVERIFY(d.scene.slowModel() == nullptr);
    d.startRunning();
    d.tool().jaw_rad = 0.0;
    double largest_N = 0.0;
    d.observe = [&](HandlingDriver& now) { largest_N = std::max(largest_N, now.force().norm()); };
    d.moveTo(Vec3(0.0, 0.0, -0.010), 1.0);
    QCOMPARE(largest_N, 0.0);
    QCOMPARE(d.out.cues.exercise.of<core::LaparoscopyCues>().bodies, 0);
    d.ticks(1500);
    QCOMPARE(d.events & bits::kTimedOut, bits::kTimedOut);
    QCOMPARE(d.events & bits::kCompleted, 0U);
}

void TestObjectHandlingOrgan::sameInputsSameBits() {
    const auto run = [] {
        HandlingDriver d(onOrgan(oneOvary()), 3);
        std::vector<double> seen;
        d.observe = [&](HandlingDriver& now) {
            seen.insert(seen.end(),
                        {now.force().x(), now.force().y(), now.force().z(), now.out.storedEnergy_J});
            seen.insert(seen.end(), now.out.quantities.begin(), now.out.quantities.end());
        };
        d.startRunning();
        d.graspObject();
        d.moveBy(Vec3(0.005, 0.0, 0.030), 0.5);
        d.moveBy(Vec3(0.0, 0.0, -0.032), 0.5);
        return seen;
    };
    const auto a = run();
    const auto b = run();
    QCOMPARE(a.size(), b.size());
    QVERIFY(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

QTEST_APPLESS_MAIN(TestObjectHandlingOrgan)
#include "test_object_handling_organ.moc"
