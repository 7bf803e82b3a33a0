// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/random.h"
#include "handling_driver.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

/// Without friction, damping and recovery: what is left is conservative.
ObjectHandlingParameters lossless() {
    ObjectHandlingParameters p = oneOvary();
    p.object.damping_Ns_per_m = 0.0;
    p.bed.damping_Ns_per_m = 0.0;
    p.bed.friction = 0.0;
    return p;
}

} // namespace

/// Energy of object handling: what is put in, what is stored, and that nothing is made.
class TestObjectHandlingEnergy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void heldObjectOverClosedPathsAndTheirReverses();
    void placedAwayAndBackAgain();
    void theBookAgreesWithTheWork();
    void pushingMakesNoEnergy();
    void droppingMakesNoEnergy();
    void slippingMakesNoEnergy();
};

/// Lift, carry, press into the bed (no rolling: straight down), random closed paths: ≥ −1 µJ either way.
void TestObjectHandlingEnergy::heldObjectOverClosedPathsAndTheirReverses() {
    core::Random random(11);
    HandlingDriver d(lossless());
    d.startRunning();
    d.graspObject(0, 0.004);
    d.moveBy(Vec3(0.0, 0.0, 0.010), 0.1);
    const Vec3 home = d.tool().p_WT;
    for (int path = 0; path < 200; ++path) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 3; ++i)
            corners.push_back(home + Vec3(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03),
                                          random.uniform(-0.008, 0.04)));
        const double before = d.work_J;
        for (const Vec3& corner : corners)
            d.moveTo(corner, 0.05);
        d.moveTo(home, 0.05);
        d.tick();
        const double forward = d.work_J - before;
        for (auto corner = corners.rbegin(); corner != corners.rend(); ++corner)
            d.moveTo(*corner, 0.05);
        d.moveTo(home, 0.05);
        d.tick();
        const double backward = d.work_J - before - forward;
        QVERIFY2(forward > -1e-6 && backward > -1e-6,
                 qPrintable(QString("%1 %2").arg(forward).arg(backward)));
    }
}

/// Grasp, lift, carry, place, let go; then the same the other way round: the weight gives back what it took.
void TestObjectHandlingEnergy::placedAwayAndBackAgain() {
    HandlingDriver d(lossless());
    d.startRunning();
    const Vec3 start = d.body().p_W;
    d.graspObject();
    const auto carry = [&](double side) {
        const double before = d.work_J;
        d.moveBy(Vec3(0.0, 0.0, 0.020), 0.8);
        d.moveBy(side * Vec3(0.020, 0.010, 0.0), 0.4);
        d.moveBy(Vec3(0.0, 0.0, -0.020), 0.8);
        d.jawTo(2.0 * d.parameters.radius_m + 0.006, 0.3);
        return d.work_J - before;
    };
    const double there = carry(1.0);
    QVERIFY2(std::abs(there) < 1e-6, qPrintable(QString::number(there)));
    QVERIFY((d.body().p_W - start - Vec3(0.020, 0.010, 0.0)).norm() < 1e-4);
    d.jawTo(d.openingFor(0.002), 0.3);
    const double back = carry(-1.0);
    QVERIFY2(std::abs(back) < 1e-6, qPrintable(QString::number(back)));
}

/// Held and in the conservative part: what is stored is what was put in, at every tick.
void TestObjectHandlingEnergy::theBookAgreesWithTheWork() {
    HandlingDriver d(lossless());
    d.startRunning();
    d.graspObject(0, 0.004);
    const double before = d.work_J;
    double worst = 0.0;
    d.observe = [&](HandlingDriver& now) {
        worst = std::max(worst, std::abs(now.work_J - before - now.out.storedEnergy_J));
    };
    d.moveBy(Vec3(0.0, 0.0, -0.0005), 1.0); // into the bed
    d.moveBy(Vec3(0.0, 0.0, 0.020), 2.0);
    d.ticks(5);
    QVERIFY2(worst < 2e-6, qPrintable(QString::number(worst))); // ½ k v² T² of the sampled spring, added up
    QVERIFY(d.out.storedEnergy_J > 0.0015);
}

/// A closed tip that pushes an object about, presses on it and lets it roll away gets no more than it gave.
void TestObjectHandlingEnergy::pushingMakesNoEnergy() {
    core::Random random(5);
    for (int run = 0; run < 12; ++run) {
        ObjectHandlingParameters p = oneOvary();
        p.object.roughness_m = run % 2 == 0 ? 40e-6 : 0.0;
        p.object.roughnessWavelength_m = 0.003;
        HandlingDriver d(p, 100 + static_cast<std::uint64_t>(run));
        d.startRunning();
        d.tool().jaw_rad = 0.0;
        double strongest = 0.0;
        d.observe = [&](HandlingDriver& now) { strongest = std::max(strongest, now.force().norm()); };
        for (int touch = 0; touch < 6; ++touch) {
            d.moveTo(d.body().p_W + Vec3(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), 0.030),
                     0.3);
            d.work_J = 0.0;
            d.moveTo(d.body().p_W + Vec3(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01),
                                         random.uniform(0.002, 0.009)),
                     0.4);
            d.moveBy(
                Vec3(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), random.uniform(-0.001, 0.001)),
                0.3);
            d.moveBy(Vec3(0.0, 0.0, 0.030), 0.3); // free again: nothing is stored any more
            QVERIFY2(d.work_J > -20e-6, qPrintable(QString::number(d.work_J)));
            d.ticks(300);
        }
        QVERIFY2(strongest > 0.2, qPrintable(QString::number(strongest)));
        QVERIFY(d.body().p_W.head<2>().norm() < 0.075); // it did not get lost
    }
}

void TestObjectHandlingEnergy::droppingMakesNoEnergy() {
    HandlingDriver d(lossless());
    d.startRunning();
    d.graspObject();
    d.work_J = 0.0;
    d.moveBy(Vec3(0.0, 0.0, 0.030), 0.5);
    const double lifted = d.work_J;
    d.jawTo(2.0 * d.parameters.radius_m + 0.006, 0.05);
    QVERIFY(d.work_J > 0.9 * lifted); // the tool stands: the fall gives nothing back
    QVERIFY(d.out.storedEnergy_J < 1e-9);
    d.moveBy(Vec3(0.0, 0.0, 0.050), 0.5);
    QVERIFY(d.work_J > 0.9 * lifted);
}

/// What slides in the jaws takes energy out of the book, never in: work − stored only grows.
void TestObjectHandlingEnergy::slippingMakesNoEnergy() {
    HandlingDriver d(lossless());
    d.startRunning();
    d.graspObject(0, 0.0006);
    d.work_J = 0.0;
    double lost = 0.0;
    double worst = 0.0;
    d.observe = [&](HandlingDriver& now) {
        const double gone = now.work_J - now.out.storedEnergy_J;
        worst = std::min(worst, gone - lost);
        lost = std::max(lost, gone);
    };
    d.moveBy(Vec3(0.0, 0.0, 0.030), 1.2);
    d.ticks(500);
    QCOMPARE(d.events & core::event_bits::kSlipped, core::event_bits::kSlipped);
    QVERIFY2(worst > -1e-6, qPrintable(QString::number(worst)));
    QVERIFY(lost > 1e-5);
}

QTEST_APPLESS_MAIN(TestObjectHandlingEnergy)
#include "test_object_handling_energy.moc"
