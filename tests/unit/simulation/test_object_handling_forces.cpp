// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "core/fp_environment.h"
#include "core/units.h"
#include "handling_driver.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
namespace bits = core::event_bits;
namespace q = handling_quantity;

namespace {

constexpr double kWeight_N = 0.010 * core::kStandardGravity;

bool isNear(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

} // namespace

/// Closed forms and continuity of what object handling makes felt.
class TestObjectHandlingForces : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void liesAtRestWhereTheBedCarriesIt();
    void squeezeFollowsTheLaw_data();
    void squeezeFollowsTheLaw();
    void openJawsGoRoundWithoutForce();
    void graspingChangesNothing();
    void liftedItWeighsItsWeight();
    void liftingCostsItsPotentialEnergy();
    void everyPartIsContinuous();
    void tipPushesItAlong();
    void closedJawsCannotTakeHold();
    void heldAgainstAnotherItIsStiffer();
    void theCheckedRangeOfTheBed_data();
    void theCheckedRangeOfTheBed();
    void theCheckedRangeOfABody();
    void theCheckedRangeOfAGrip();
};

void TestObjectHandlingForces::liesAtRestWhereTheBedCarriesIt() {
    for (const double stiffening : {0.0, 80.0}) {
        ObjectHandlingParameters p = oneOvary();
        p.bed.stiffening_per_m = stiffening;
        HandlingDriver d(p);
        d.startRunning();
        const double depth = d.body().bedDepth_m();
        QVERIFY(isNear(elasticOf(p.bed).tension(depth), kWeight_N, 1e-12));
        if (stiffening == 0.0)
            QVERIFY(isNear(depth, kWeight_N / 800.0, 1e-15));
        const Vec3 place = d.body().p_W;
        d.ticks(2000);
        QVERIFY((d.body().p_W - place).norm() < 1e-12);
        QCOMPARE(d.out.storedEnergy_J, 0.0);
        QCOMPARE(d.force().norm(), 0.0);
    }
}

void TestObjectHandlingForces::squeezeFollowsTheLaw_data() {
    QTest::addColumn<double>("stiffening");
    QTest::addColumn<double>("depth_m");
    for (const double b : {0.0, 60.0})
        for (const double depth : {0.0005, 0.002, 0.005})
            QTest::addRow("b %g, %g mm", b, 1000.0 * depth) << b << depth;
}

void TestObjectHandlingForces::squeezeFollowsTheLaw() {
    QFETCH(double, stiffening);
    QFETCH(double, depth_m);
    ObjectHandlingParameters p = oneOvary();
    p.object.stiffening_per_m = stiffening;
    HandlingDriver d(p);
    d.startRunning();
    d.graspObject(0, depth_m);
    const double expected =
        stiffening > 0.0 ? 300.0 / stiffening * std::expm1(stiffening * depth_m) : 300.0 * depth_m;
    QCOMPARE(d.q(q::kHeld), 1.0);
    QVERIFY(isNear(d.q(q::kSqueeze), expected, 1e-9));
    QVERIFY(isNear(d.out.cues.exercise.of<core::LaparoscopyCues>().body[0].squeeze_m, 2.0 * depth_m, 1e-12));
}

void TestObjectHandlingForces::openJawsGoRoundWithoutForce() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    const Vec3 middle = d.body().p_W;
    d.moveTo(middle + Vec3(0.0, 0.0, 0.040), 0.4);
    d.largestStep_N = 0.0;
    d.moveTo(middle, 0.4);
    d.moveBy(Vec3(0.0, 0.0, 0.040), 0.4);
    QCOMPARE(d.largestStep_N, 0.0);
    QVERIFY((d.body().p_W - middle).norm() < 1e-12);
}

void TestObjectHandlingForces::graspingChangesNothing() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    const Vec3 middle = d.body().p_W;
    d.graspObject();
    QCOMPARE(d.events & bits::kGrasped, bits::kGrasped);
    QVERIFY2(d.largestStep_N < 1e-9, qPrintable(QString::number(d.largestStep_N)));
    QVERIFY(d.force().norm() < 1e-9);
    QVERIFY((d.body().p_W - middle).norm() < 1e-12);
}

void TestObjectHandlingForces::liftedItWeighsItsWeight() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.graspObject();
    for (int step = 0; step < 40; ++step) { // while the bed still carries some of it
        d.moveBy(Vec3(0.0, 0.0, 5e-6), 0.01);
        d.ticks(5);
        const double depth = std::max(0.0, d.body().bedDepth_m());
        QVERIFY(isNear(d.force().z(), 800.0 * depth - kWeight_N, 1e-9));
    }
    d.moveBy(Vec3(0.010, -0.020, 0.030), 0.5);
    d.ticks(5);
    QVERIFY((d.force() - Vec3(0.0, 0.0, -kWeight_N)).norm() < 1e-12);
}

void TestObjectHandlingForces::liftingCostsItsPotentialEnergy() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.graspObject();
    d.moveBy(Vec3(0.0, 0.0, 0.002), 0.2);
    const double before = d.work_J;
    const double storedBefore = d.out.storedEnergy_J;
    d.moveBy(Vec3(0.015, 0.005, 0.040), 0.8);
    d.ticks(1);
    QVERIFY(isNear(d.work_J - before, kWeight_N * 0.040, 1e-9));
    QVERIFY(isNear(d.out.storedEnergy_J - storedBefore, kWeight_N * 0.040, 1e-12));
    d.moveBy(Vec3(-0.015, -0.005, -0.040), 0.8);
    d.ticks(1);
    QVERIFY(isNear(d.work_J - before, 0.0, 1e-9));
}

void TestObjectHandlingForces::everyPartIsContinuous() {
    ObjectHandlingParameters p = oneOvary();
    p.object.roughness_m = 40e-6;
    p.object.roughnessWavelength_m = 0.003;
    p.object.recoveryTime_s = 0.3;
    p.object.recoveryShare = 0.5;
    HandlingDriver d(p);
    d.startRunning();
    d.graspObject();
    d.moveBy(Vec3(0.0, 0.0, 0.040), 0.8);
    QVERIFY2(d.largestStep_N < 0.005, qPrintable(QString::number(d.largestStep_N))); // grasp and lift-off
    d.moveTo(d.overTarget(0.050), 0.8);
    d.moveTo(d.overTarget(d.parameters.radius_m - 0.0005), 0.8);
    QVERIFY2(d.largestStep_N < 0.020, qPrintable(QString::number(d.largestStep_N))); // set-down
    d.open();
    d.tool().jaw_rad = d.jawFor(d.openingFor(0.002));
    d.jawTo(2.0 * p.radius_m + 0.005, 0.4);
    QVERIFY2(d.largestStep_N < 0.050,
             qPrintable(QString::number(d.largestStep_N))); // pressed 0.4 N into the bed, let go
    QCOMPARE(d.events & bits::kReleased, bits::kReleased);
    QVERIFY((d.events & bits::kSlipped) == 0);
}

void TestObjectHandlingForces::tipPushesItAlong() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.tool().jaw_rad = 0.0;
    const Vec3 start = d.body().p_W;
    d.moveTo(start + Vec3(-0.020, 0.0, 0.0), 1.0);
    d.largestStep_N = 0.0;
    d.moveBy(Vec3(0.030, 0.0, 0.0), 1.5);
    QVERIFY(d.body().p_W.x() - start.x() > 0.015);
    QVERIFY2(d.largestStep_N < 0.05, qPrintable(QString::number(d.largestStep_N)));
    d.moveBy(Vec3(-0.010, 0.0, 0.030), 0.5);
    d.ticks(500);
    QVERIFY(d.body().v_W.norm() < 1e-4); // it lies again
    QVERIFY(isNear(d.body().bedDepth_m(), d.body().restDepth_m(), 1e-7));
}

void TestObjectHandlingForces::closedJawsCannotTakeHold() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.tool().jaw_rad = d.jawFor(0.015);
    const Vec3 start = d.body().p_W;
    d.moveTo(start + Vec3(0.0, 0.0, 0.030), 0.5);
    d.moveTo(start + Vec3(0.0, 0.0, 0.010), 0.5);
    d.jawTo(0.0, 0.2);
    QVERIFY((d.events & bits::kGrasped) == 0);
    QVERIFY(d.force().norm() > 0.05); // it presses on it instead
}

/// The passivity credit needs the stiffness that the hand feels: of two bodies, where either is the one in
/// the jaws.
void TestObjectHandlingForces::heldAgainstAnotherItIsStiffer() {
    for (const std::size_t held : {std::size_t{0}, std::size_t{1}}) {
        ObjectHandlingParameters p = oneOvary();
        p.task = HandlingTask::weigh;
        p.objects = 2;
        p.object.friction = 0.4;
        p.massLow_kg = 0.010;
        p.massHigh_kg = 0.012;
        p.placesRadius_m = 0.040;
        p.squeezeLimit_N = 3.0;
        HandlingDriver d(p);
        d.startRunning();
        d.graspObject(held, 0.003);
        QCOMPARE(d.q(q::kHeld), 1.0 + static_cast<double>(held));
        d.moveBy(Vec3(0.0, 0.0, 0.040), 0.5);
        const double inAir = d.out.contactStiffness_N_per_m;
        const double bedAlone = d.force().z();
        const Vec3 above = d.body(1 - held).p_W + Vec3(0.0, 0.0, 2.0 * p.radius_m + 0.005);
        d.moveBy(above - d.body(held).p_W, 0.5);
        QCOMPARE(d.out.contactStiffness_N_per_m, inAir);
        d.moveBy(Vec3(0.0, 0.0, -0.007), 0.2);
        QVERIFY(d.force().z() > bedAlone + 0.1);
        QVERIFY(isNear(d.out.contactStiffness_N_per_m, inAir + 0.5 * p.object.stiffness_N_per_m, 1e-9));
    }
}

namespace {

bool isBeyondChecked(const HandlingDriver& d) {
    return (d.out.contact[0] & core::contact_bits::kBeyondChecked) != 0;
}

} // namespace

void TestObjectHandlingForces::theCheckedRangeOfTheBed_data() {
    QTest::addColumn<bool>("organ");
    QTest::newRow("plane") << false;
    QTest::newRow("organ") << true;
}

/// Flagged where the tip is deeper than what was checked, in and out again; on the plane the force is the
/// law's up to there.
void TestObjectHandlingForces::theCheckedRangeOfTheBed() {
    QFETCH(bool, organ);
    ObjectHandlingParameters p = oneOvary();
    p.bed.friction = 0.0;
    if (organ)
        p = onOrgan(p);
    HandlingDriver d(p);
    d.startRunning();
    d.tool().jaw_rad = 0.0;
    // Beside the ovary, on top of the organ
    const Vec3 off = d.body().p_W.x() > 0.0 ? Vec3(-0.020, 0.0, 0.0) : Vec3(0.020, 0.0, 0.0);
    d.moveTo(off + Vec3(0.0, 0.0, 0.030), 0.4);
    d.moveTo(off + Vec3(0.0, 0.0, organ ? -0.004 : -0.0059), 2.0);
    if (!organ) {
        d.ticks(5);
        QVERIFY(isNear(d.force().z(), elasticOf(p.bed).tension(0.0059), 1e-9));
        QVERIFY(!isBeyondChecked(d));
        d.moveTo(off + Vec3(0.0, 0.0, -0.0061), 0.2);
        QVERIFY(isBeyondChecked(d));
        QCOMPARE(int(d.out.contact[0]), int(core::contact_bits::kBeyondChecked)); // and nothing gave way
        d.moveTo(off + Vec3(0.0, 0.0, -0.0059), 0.2);
        QVERIFY(!isBeyondChecked(d));
        return;
    }
    QVERIFY(!isBeyondChecked(d));
    d.moveTo(off + Vec3(0.0, 0.0, -0.016), 0.05); // faster than the slow model answers
    QVERIFY(isBeyondChecked(d));
    d.moveTo(off + Vec3(0.0, 0.0, 0.030), 0.5);
    QCOMPARE(int(d.out.contact[0]), 0);
}

/// By the depth of the tip in the body as it lay in that tick.
void TestObjectHandlingForces::theCheckedRangeOfABody() {
    HandlingDriver d(oneOvary());
    d.startRunning();
    d.tool().jaw_rad = 0.0;
    const Vec3 top = d.body().p_W + Vec3(0.0, 0.0, d.parameters.radius_m);
    d.moveTo(top + Vec3(0.0, 0.0, 0.010), 0.5);
    int within = 0, beyond = 0;
    for (int tick = 0; tick < 1000; ++tick) { // down 20 mm; the ovary gives way into the bed
        d.tool().p_WT.z() -= 2e-5;
        const Vec3 was = d.body().p_W;
        d.tick();
        const double depth_m = d.parameters.radius_m - (d.tool().p_WT - was).norm();
        if (std::abs(depth_m - kCheckedContactDepth_m) < 1e-9 || d.tool().p_WT.z() < 0.0)
            continue;
        QCOMPARE(isBeyondChecked(d), depth_m > kCheckedContactDepth_m);
        (depth_m > kCheckedContactDepth_m ? beyond : within) += depth_m > 0.0 ? 1 : 0;
    }
    QVERIFY2(within > 100 && beyond > 10, qPrintable(QStringLiteral("%1 %2").arg(within).arg(beyond)));
}

/// What the jaws press, and what the held ovary presses, is felt through the grip.
void TestObjectHandlingForces::theCheckedRangeOfAGrip() {
    ObjectHandlingParameters p = oneOvary();
    p.object.friction = 2.0; // so that it does not slide out when it is pressed down
    p.squeezeLimit_N = 10.0;
    HandlingDriver d(p);
    d.startRunning();
    d.graspObject(0, 0.0055);
    QCOMPARE(d.q(q::kHeld), 1.0);
    QVERIFY(!isBeyondChecked(d));
    d.jawTo(d.openingFor(0.0065), 0.2);
    QVERIFY(isBeyondChecked(d)); // by each jaw
    d.jawTo(d.openingFor(0.0055), 0.2);
    QVERIFY(!isBeyondChecked(d));
    d.moveBy(Vec3(0.0, 0.0, -0.0065), 0.5);
    QCOMPARE(d.q(q::kHeld), 1.0);
    QVERIFY(d.body().bedDepth_m() > kCheckedContactDepth_m); // or the test has nothing to show
    QVERIFY(isBeyondChecked(d));
    d.moveBy(Vec3(0.0, 0.0, 0.030), 0.5);
    QVERIFY(!isBeyondChecked(d));
}

QTEST_APPLESS_MAIN(TestObjectHandlingForces)
#include "test_object_handling_forces.moc"
