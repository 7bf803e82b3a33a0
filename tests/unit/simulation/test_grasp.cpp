// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/objects/grasp.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

constexpr double kTick = core::kTickSeconds;
constexpr double g = core::kStandardGravity;

} // namespace

class TestGrasp : public QObject {
    Q_OBJECT
private slots:
    void jawOpeningAndBack();
    void jawTakesHoldOnlyWhileClosing();
    void jawLetsGoWithHysteresis();
    void closedJawCannotSpear();
    void squeezeIsTwoPresses();
    void gripPassesOnAtMostItsLimit();
    void slideHoldsExactly();
    void slideFallsAtTheRestOfTheLoad();
    void slideStopsWithoutChatter();
    void slideNeverDoesPositiveWork();
};

void TestGrasp::jawOpeningAndBack() {
    const JawGeometry jaw{0.020};
    QVERIFY(std::abs(jaw.opening_m(core::kPi / 3.0) - 0.020) < 1e-15); // 2 · 20 mm · sin 30°
    QCOMPARE(jaw.opening_m(0.0), 0.0);
    QCOMPARE(jaw.opening_m(-0.1), 0.0);
    for (double angle = 0.0; angle < 3.1; angle += 0.01)
        QVERIFY(std::abs(jaw.angle_rad(jaw.opening_m(angle)) - angle) < 1e-9);
}

void TestGrasp::jawTakesHoldOnlyWhileClosing() {
    GraspLatch latch;
    QVERIFY(latch.update(0.10, 0.20, 0.35, true) == GraspChange::none); // has not been open yet
    latch.update(0.50, 0.20, 0.35, true);
    QVERIFY(latch.ready());
    QVERIFY(latch.update(0.30, 0.20, 0.35, true) == GraspChange::none); // not closed enough
    QVERIFY(latch.update(0.19, 0.20, 0.35, true) == GraspChange::grasped && latch.held());
    QVERIFY(latch.update(0.05, 0.20, 0.35, true) == GraspChange::none && latch.held());
    QVERIFY(latch.update(0.05, 0.20, 0.35, false) == GraspChange::none &&
            latch.held()); // reach was for the catch
}

void TestGrasp::jawLetsGoWithHysteresis() {
    GraspLatch latch;
    latch.update(0.50, 0.20, 0.35, true);
    latch.update(0.10, 0.20, 0.35, true);
    int changes = 0;
    for (int n = 0; n < 1000; ++n) // trembling about the lower threshold
        changes += latch.update(0.20 + 0.1 * std::sin(n), 0.20, 0.35, true) != GraspChange::none ? 1 : 0;
    QCOMPARE(changes, 0);
    QVERIFY(latch.update(0.36, 0.20, 0.35, true) == GraspChange::released && !latch.held());
    QVERIFY(latch.update(0.15, 0.20, 0.35, true) == GraspChange::grasped);
    latch.lose();
    QVERIFY(!latch.held() && latch.update(0.10, 0.20, 0.35, true) == GraspChange::none);
}

void TestGrasp::closedJawCannotSpear() {
    GraspLatch latch;
    latch.update(0.50, 0.20, 0.35, false);
    QVERIFY(latch.update(0.10, 0.20, 0.35, false) == GraspChange::none && !latch.held()); // closed on nothing
    for (int n = 0; n < 100; ++n)
        QVERIFY(latch.update(0.10, 0.20, 0.35, true) == GraspChange::none); // then moved onto the thing
    latch.update(0.50, 0.20, 0.35, true);
    QVERIFY(latch.update(0.10, 0.20, 0.35, true) == GraspChange::grasped);
}

void TestGrasp::squeezeIsTwoPresses() {
    const ElasticLaw law{300.0, 60.0};
    const Squeeze none = Squeeze::of(law, 0.022, 0.022);
    QVERIFY(none.force_N == 0.0 && none.energy_J == 0.0 && none.compression_m == 0.0);
    const Squeeze some = Squeeze::of(law, 0.022, 0.018);
    QVERIFY(std::abs(some.force_N - 5.0 * std::expm1(0.12)) < 1e-12);
    // closing a jaw by dc costs N dc: the energy's derivative is the force
    const double e = 1e-7;
    const double slope =
        (Squeeze::of(law, 0.022, 0.018 - e).energy_J - Squeeze::of(law, 0.022, 0.018 + e).energy_J) / (2 * e);
    QVERIFY(std::abs(slope - some.force_N) < 1e-7);
    QCOMPARE(gripLimit_N(0.25, 0.4), 0.2);
}

void TestGrasp::gripPassesOnAtMostItsLimit() {
    const GripLoad within = GripLoad::of(Vec3(0.1, 0.0, -0.1), 0.2);
    QVERIFY(!within.slips && within.held == Vec3(0.1, 0.0, -0.1));
    const GripLoad over = GripLoad::of(Vec3(0.3, 0.0, -0.4), 0.2);
    QVERIFY(over.slips && (over.held - Vec3(0.12, 0.0, -0.16)).norm() < 1e-15);
    QVERIFY(GripLoad::of(Vec3::Zero(), 0.0).slips == false);
}

void TestGrasp::slideHoldsExactly() {
    GripSlide slide;
    const Vec3 weight(0.0, 0.0, -0.010 * g);
    for (int n = 0; n < 10000; ++n) {
        QVERIFY((slide.step(weight, 0.0981, 0.010, kTick) + weight).norm() < 1e-18); // 35 µN to spare
        QVERIFY(!slide.slipping() && slide.offset() == Vec3::Zero());
    }
}

void TestGrasp::slideFallsAtTheRestOfTheLoad() {
    GripSlide slide;
    const double m = 0.010;
    const double limit = 0.5 * m * g;
    for (int n = 1; n <= 100; ++n) {
        const Vec3 f = slide.step(Vec3(0, 0, -m * g), limit, m, kTick);
        QVERIFY(slide.slipping() && std::abs(f.norm() - limit) < 1e-15 && f.z() > 0.0);
        QVERIFY(std::abs(slide.velocity().z() + 0.5 * g * n * kTick) < 1e-12);
    }
}

// Gripped harder while it slides, it comes to rest and stays: no trembling, no going back.
void TestGrasp::slideStopsWithoutChatter() {
    GripSlide slide;
    const double m = 0.010;
    for (int n = 0; n < 100; ++n)
        slide.step(Vec3(0, 0, -m * g), 0.0, m, kTick);
    double last = slide.offset().z();
    int ticks = 0;
    for (; slide.slipping() && ticks < 10000; ++ticks) {
        slide.step(Vec3(0, 0, -m * g), 2.0 * m * g, m, kTick);
        QVERIFY(slide.offset().z() <= last);
        last = slide.offset().z();
    }
    QVERIFY2(ticks >= 99 && ticks <= 102, qPrintable(QString::number(ticks))); // decelerated by g
    for (int n = 0; n < 10000; ++n) {
        const Vec3 f = slide.step(Vec3(0, 0, -m * g), 2.0 * m * g, m, kTick);
        QVERIFY(std::abs(f.z() - m * g) < 1e-15 && slide.offset().z() == last);
    }
}

void TestGrasp::slideNeverDoesPositiveWork() {
    core::Random random(1);
    GripSlide slide;
    for (int n = 0; n < 100000; ++n) {
        const Vec3 load(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const double limit = random.uniform(0.0, 1.5);
        const Vec3 f = slide.step(load, limit, 0.010, kTick);
        QVERIFY(f.norm() <= limit * (1 + 1e-12));
        QVERIFY(!slide.slipping() || f.dot(slide.velocity()) <= 1e-12);
    }
}

QTEST_APPLESS_MAIN(TestGrasp)
#include "test_grasp.moc"
