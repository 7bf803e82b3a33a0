// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "mechanisms/gimbal_kinematics.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using core::Vec3;
using mechanisms::GimbalCoordinates;
using mechanisms::GimbalKinematics;
using mechanisms::GimbalVector;
using mechanisms::PolarMap;

class TestGimbalKinematics : public QObject {
    Q_OBJECT
private slots:
    void vendorAxesBecomeD();
    void inverseUndoesForward();
    void inverseRefusesBadTips();
    void jacobianMatchesFiniteDifferences();
    void orientationCarriesTheAngularVelocity();
    void effortsConservePower();
    void forceOfEffortsIsTheForce();
    void publishedIsExactOnlyOnTheAxes();
    void publishedErrsByTheKnownShare();
    void weightAsPublished();
    void liftingCostsWeightTimesHeight();
};

namespace {

GimbalCoordinates draw(core::Random& random, double angle = core::radFromDeg(30.0)) {
    return {random.uniform(-angle, angle), random.uniform(-angle, angle), random.uniform(-3.0, 3.0),
            random.uniform(0.1, 0.3)};
}

Vec3 drawVector(core::Random& random) {
    return {random.normal(), random.normal(), random.normal()};
}

GimbalCoordinates moved(GimbalCoordinates q, int axis, double by) {
    (axis == 0 ? q.h : axis == 1 ? q.p : axis == 2 ? q.r : q.d) += by;
    return q;
}

} // namespace

void TestGimbalKinematics::vendorAxesBecomeD() {
    const GimbalKinematics gimbal(0.18);
    const auto near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-15; };
    QVERIFY(near(gimbal.tip_D({0.0, 0.0, 0.0, 0.18}), Vec3::Zero())); // straight down to the table
    QVERIFY(gimbal.tip_D({0.1, 0.0, 0.0, 0.18}).x() > 0.0);           // heading right: +x
    QVERIFY(gimbal.tip_D({0.0, 0.1, 0.0, 0.18}).y() < 0.0);           // pitch: −y
    QVERIFY(gimbal.tip_D({0.0, 0.0, 0.0, 0.20}).z() < 0.0);           // deeper: below the table
    QVERIFY(near(GimbalKinematics::axis_V(0.3, 0.2),
                 Vec3(std::sin(0.3) * std::cos(0.2), std::sin(0.2), std::cos(0.3) * std::cos(0.2))));
    QVERIFY(near(gimbal.orientation_DT({}) * Vec3(1, 2, 3), Vec3(1, 2, 3))); // T = D at rest
    // The instrument's own −z points from the pivot to the tip.
    const GimbalCoordinates q{0.2, -0.3, 0.7, 0.2};
    const Vec3 along = gimbal.orientation_DT(q) * -Vec3::UnitZ();
    QVERIFY((gimbal.tip_D(q) - (Vec3(0, 0, 0.18) + 0.2 * along)).norm() < 1e-15);
    // det R_DV = +1: right-handed stays right-handed.
    const Vec3 x = GimbalKinematics::directionToD(Vec3::UnitX());
    const Vec3 y = GimbalKinematics::directionToD(Vec3::UnitY());
    QVERIFY(near(x.cross(y), GimbalKinematics::directionToD(Vec3::UnitZ())));
}

void TestGimbalKinematics::inverseUndoesForward() {
    const GimbalKinematics gimbal;
    core::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const auto q = draw(random, 1.2);
        const auto back = gimbal.inverse(gimbal.tip_D(q), q.r);
        QVERIFY(back.has_value());
        QVERIFY(std::abs(back->h - q.h) < 1e-12 && std::abs(back->p - q.p) < 1e-12);
        QVERIFY(std::abs(back->d - q.d) < 1e-12 && back->r == q.r);
    }
}

void TestGimbalKinematics::inverseRefusesBadTips() {
    const GimbalKinematics gimbal(0.18);
    QVERIFY(!gimbal.inverse({0.0, 0.0, 0.18}));
    QVERIFY(!gimbal.inverse({0.1, 0.0, 0.18}));
    QVERIFY(!gimbal.inverse({0.0, 0.0, 0.30}));
    QVERIFY(!gimbal.inverse({std::nan(""), 0.0, 0.0}));
}

void TestGimbalKinematics::jacobianMatchesFiniteDifferences() {
    const GimbalKinematics gimbal;
    core::Random random(2);
    const double step = 1e-6;
    for (int i = 0; i < 200; ++i) {
        const auto q = draw(random);
        const auto jacobian = gimbal.jacobian_D(q);
        for (int axis = 0; axis < 4; ++axis) {
            const Vec3 difference =
                (gimbal.tip_D(moved(q, axis, step)) - gimbal.tip_D(moved(q, axis, -step))) / (2 * step);
            QVERIFY((difference - jacobian.col(axis).head<3>()).norm() < 1e-9);
        }
    }
}

void TestGimbalKinematics::orientationCarriesTheAngularVelocity() {
    const GimbalKinematics gimbal;
    core::Random random(3);
    const double step = 1e-6;
    for (int i = 0; i < 200; ++i) {
        const auto q = draw(random);
        const auto jacobian = gimbal.jacobian_D(q);
        for (int axis = 0; axis < 4; ++axis) {
            const core::Quat turn = gimbal.orientation_DT(moved(q, axis, step)) *
                                    gimbal.orientation_DT(moved(q, axis, -step)).conjugate();
            const Vec3 omega = turn.vec() / step; // small turn: angle·axis = 2 vec, over 2 step
            QVERIFY((omega - jacobian.col(axis).tail<3>()).norm() < 1e-8);
        }
    }
}

void TestGimbalKinematics::effortsConservePower() {
    const GimbalKinematics gimbal;
    core::Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const auto q = draw(random, 1.0);
        const core::Wrench wrench{drawVector(random), drawVector(random)};
        const GimbalVector rates(random.normal(), random.normal(), random.normal(), random.normal());
        const Eigen::Matrix<double, 6, 1> twist = gimbal.jacobian_D(q) * rates;
        const double power = twist.head<3>().dot(wrench.force) + twist.tail<3>().dot(wrench.torque);
        QVERIFY(std::abs(GimbalKinematics::efforts(q, wrench, PolarMap::exact).dot(rates) - power) < 1e-12);
    }
}

void TestGimbalKinematics::forceOfEffortsIsTheForce() {
    core::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const auto q = draw(random, 1.0);
        core::Wrench wrench;
        wrench.force = drawVector(random);
        const auto tau = GimbalKinematics::efforts(q, wrench, PolarMap::exact);
        QVERIFY((GimbalKinematics::force_D(q, tau) - wrench.force).norm() < 1e-12);
    }
}

void TestGimbalKinematics::publishedIsExactOnlyOnTheAxes() {
    core::Random random(6);
    double worstOnAxes = 0.0, worstOff = 0.0;
    for (int i = 0; i < 2000; ++i) {
        GimbalCoordinates q = draw(random);
        core::Wrench wrench;
        wrench.force = drawVector(random).normalized();
        const auto error = [&](const GimbalCoordinates& at) {
            const auto tau = GimbalKinematics::efforts(at, wrench, PolarMap::asPublished);
            return (GimbalKinematics::force_D(at, tau) - wrench.force).norm();
        };
        worstOff = std::max(worstOff, error(q));
        GimbalCoordinates heading = q, pitch = q;
        heading.p = 0.0;
        pitch.h = 0.0;
        worstOnAxes = std::max({worstOnAxes, error(heading), error(pitch)});
    }
    QVERIFY2(worstOnAxes < 1e-12, qPrintable(QString::number(worstOnAxes)));
    QVERIFY2(worstOff > 0.1, qPrintable(QString::number(worstOff)));
}

// models.md §2.1: up to 26.7 % of the force within ±30°. The worst direction at each angle is the largest
// singular value of the difference between the published and the exact map, here by sampling directions
// densely.
void TestGimbalKinematics::publishedErrsByTheKnownShare() {
    double worst = 0.0;
    const double limit = core::radFromDeg(30.0);
    for (int ih = -10; ih <= 10; ++ih) {
        for (int ip = -10; ip <= 10; ++ip) {
            const GimbalCoordinates q{limit * ih / 10.0, limit * ip / 10.0, 0.0, 0.18};
            Eigen::Matrix3d realised;
            for (int axis = 0; axis < 3; ++axis) {
                core::Wrench wrench;
                wrench.force = Vec3::Unit(axis);
                realised.col(axis) =
                    GimbalKinematics::force_D(q, GimbalKinematics::efforts(q, wrench, PolarMap::asPublished));
            }
            const Eigen::Matrix3d error = realised - Eigen::Matrix3d::Identity();
            // Largest singular value by power iteration on EᵀE.
            Vec3 v(0.6, -0.3, 0.74);
            for (int i = 0; i < 200 && v.norm() > 0.0; ++i) {
                v = error.transpose() * (error * v);
                if (v.norm() > 0.0)
                    v.normalize();
            }
            worst = std::max(worst, (error * v).norm());
        }
    }
    QVERIFY2(std::abs(worst - 0.267) < 0.0005, qPrintable(QString::number(worst)));
}

void TestGimbalKinematics::weightAsPublished() {
    const double h = 0.3, p = -0.2, mass = 0.010, weight = mass * core::kStandardGravity;
    const auto published = GimbalKinematics::weightAsPublished(h, p, mass);
    QCOMPARE(published.heading_N, weight * std::sin(h));
    QCOMPARE(published.pitch_N, weight * std::sin(p));
    QCOMPARE(published.depth_N, weight * std::cos(h) * std::cos(p));
    // Under P2's own map no force gives all three: gravity along −z gives F_h and F_p, and F_d with the other
    // sign.
    const auto image = GimbalKinematics::polarAsPublished(h, p, Vec3(0.0, 0.0, -weight));
    QVERIFY(std::abs(image.heading_N - published.heading_N) < 1e-15);
    QVERIFY(std::abs(image.pitch_N - published.pitch_N) < 1e-15);
    QVERIFY(std::abs(image.depth_N + published.depth_N) < 1e-15);
}

// Holding f = (0, 0, −mg) on the tool and lifting by Δz costs m g Δz: the efforts' work along a curved path.
void TestGimbalKinematics::liftingCostsWeightTimesHeight() {
    const GimbalKinematics gimbal;
    const double weight = 0.5 * core::kStandardGravity;
    core::Wrench wrench;
    wrench.force = Vec3(0.0, 0.0, -weight);
    const GimbalCoordinates from{-0.4, 0.3, 0.0, 0.25}, to{0.5, -0.2, 1.0, 0.12};
    const int steps = 20000;
    double work = 0.0;
    const auto at = [&](double t) {
        return GimbalCoordinates{from.h + t * (to.h - from.h), from.p + t * (to.p - from.p),
                                 from.r + t * (to.r - from.r), from.d + t * (to.d - from.d)};
    };
    const GimbalVector rate(to.h - from.h, to.p - from.p, to.r - from.r, to.d - from.d);
    for (int i = 0; i < steps; ++i) { // Simpson over each step
        const auto power = [&](double t) {
            return GimbalKinematics::efforts(at(t), wrench, PolarMap::exact).dot(rate);
        };
        const double a = static_cast<double>(i) / steps, b = static_cast<double>(i + 1) / steps;
        work += (power(a) + 4.0 * power(0.5 * (a + b)) + power(b)) / (6.0 * steps);
    }
    const double lifted = gimbal.tip_D(to).z() - gimbal.tip_D(from).z();
    QVERIFY(lifted > 0.05);
    QVERIFY2(std::abs(-work - weight * lifted) < 1e-9, qPrintable(QString::number(-work - weight * lifted)));
}

QTEST_APPLESS_MAIN(TestGimbalKinematics)
#include "test_gimbal_kinematics.moc"
