// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "mechanisms/rotation_vector.h"
#include "mechanisms/spherical_joint.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Quat;
using core::Vec3;
using mechanisms::EndoscopeAngles;
using mechanisms::SphericalJoint;

namespace {
EndoscopeAngles draw(core::Random& random) {
    return {random.uniform(-0.6, 1.7), random.uniform(-0.9, 0.9), random.uniform(-3.1, 3.1)};
}
EndoscopeAngles moved(EndoscopeAngles a, int axis, double by) {
    (axis == 0 ? a.pitch : axis == 1 ? a.yaw : a.roll) += by;
    return a;
}
} // namespace

class TestSphericalJoint : public QObject {
    Q_OBJECT
private slots:
    /// R_x(pitch) R_y'(yaw) R_a(roll) on "looking along +y_D with y_T up", written with matrices.
    void orientationIsThatOfTheDefinition() {
        core::Random random(1);
        core::Mat3 level; // columns: x_T, y_T, z_T in D
        level << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        for (int n = 0; n < 500; ++n) {
            const EndoscopeAngles a = draw(random);
            const core::Mat3 pitched = Eigen::AngleAxisd(a.pitch, Vec3::UnitX()) * level;
            const core::Mat3 yawed = Eigen::AngleAxisd(a.yaw, Vec3(pitched.col(1))) * pitched;
            const core::Mat3 rolled = Eigen::AngleAxisd(a.roll, Vec3(-yawed.col(2))) * yawed;
            const SphericalJoint joint(a);
            QVERIFY((joint.orientation_DT().toRotationMatrix() - rolled).norm() < 1e-13);
            QVERIFY((joint.view_D() + rolled.col(2)).norm() < 1e-13);
            QVERIFY((joint.yawAxis_D() - pitched.col(1)).norm() < 1e-13);
        }
        QVERIFY((SphericalJoint().view_D() - Vec3::UnitY()).norm() < 1e-15);
        QVERIFY((SphericalJoint({core::radFromDeg(90.0), 0.0, 0.0}).view_D() - Vec3::UnitZ()).norm() < 1e-15);
    }

    void jacobianMatchesFiniteDifferences() {
        core::Random random(2);
        const double h = 1e-6;
        for (int n = 0; n < 300; ++n) {
            const EndoscopeAngles a = draw(random);
            for (int axis = 0; axis < 3; ++axis) {
                const Quat turn = SphericalJoint(moved(a, axis, h)).orientation_DT() *
                                  SphericalJoint(moved(a, axis, -h)).orientation_DT().conjugate();
                QVERIFY(
                    (mechanisms::rotationVectorOf(turn) / (2.0 * h) - SphericalJoint(a).column(axis)).norm() <
                    1e-9);
            }
        }
    }

    void biasAccelerationMatchesFiniteDifferences() {
        core::Random random(3);
        for (int n = 0; n < 300; ++n) {
            const EndoscopeAngles a = draw(random);
            const Vec3 rates(random.normal(), random.normal(), random.normal());
            const auto omega = [&](double t) {
                return SphericalJoint({a.pitch + rates[0] * t, a.yaw + rates[1] * t, a.roll + rates[2] * t})
                    .angularVelocity_D(rates);
            };
            const double h = 1e-5;
            QVERIFY(
                ((omega(h) - omega(-h)) / (2.0 * h) - SphericalJoint(a).biasAcceleration_D(rates)).norm() <
                1e-8);
        }
    }

    void effortsConservePowerAndCanBeTurnedBack() {
        core::Random random(4);
        for (int n = 0; n < 300; ++n) {
            const SphericalJoint joint(draw(random));
            const Vec3 torque(random.normal(), random.normal(), random.normal());
            const Vec3 rates(random.normal(), random.normal(), random.normal());
            QVERIFY(std::abs(joint.efforts(torque).dot(rates) - torque.dot(joint.angularVelocity_D(rates))) <
                    1e-13);
            QVERIFY((joint.torque_D(joint.efforts(torque)) - torque).norm() < 1e-12);
            QVERIFY((joint.rates(joint.angularVelocity_D(rates)) - rates).norm() < 1e-12);
        }
    }

    void anglesComeBack() {
        core::Random random(5);
        for (int n = 0; n < 500; ++n) {
            const EndoscopeAngles a = draw(random);
            const Quat q = SphericalJoint(a).orientation_DT();
            for (const Quat& same : {q, Quat(-q.coeffs())})
                QVERIFY((SphericalJoint::anglesOf(same).vector() - a.vector()).norm() < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(TestSphericalJoint)
#include "test_spherical_joint.moc"
