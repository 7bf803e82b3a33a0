// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/api/workspace_map.h"

#include "core/random.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Mat3;
using core::Quat;
using core::Vec3;

namespace {
Vec3 randomVector(core::Random& random) {
    return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}
bool near(const Vec3& a, const Vec3& b) {
    return (a - b).norm() < 1e-12;
}
devices::WorkspaceMapping mapping(bool leftHanded, double scale) {
    devices::WorkspaceMapping made;
    made.origin_m = {0.01, -0.02, 0.03};
    made.scale = scale;
    made.leftHanded = leftHanded;
    return made;
}
devices::WorkspaceMapping turned(bool leftHanded, double scale, const Quat& q) {
    devices::WorkspaceMapping made = mapping(leftHanded, scale);
    made.q_WD = {q.w(), q.x(), q.y(), q.z()};
    return made;
}
} // namespace

class TestWorkspaceMap : public QObject {
    Q_OBJECT
private slots:
    void positionsFollowTheDefinition() {
        const devices::WorkspaceMap map(mapping(true, 2.0));
        QVERIFY(near(map.pointToW({0.1, 0.2, 0.3}), {0.01 - 0.2, -0.02 + 0.4, 0.03 + 0.6}));
        QVERIFY(near(map.pointToD(map.pointToW({0.1, 0.2, 0.3})), {0.1, 0.2, 0.3}));
        const devices::WorkspaceMap plain;
        QVERIFY(near(plain.pointToW({1.0, 2.0, 3.0}), {1.0, 2.0, 3.0}));
    }

    void forcesGoBackUnscaled() {
        const devices::WorkspaceMap map(mapping(true, 3.0));
        const core::Wrench d = map.wrenchToD({Vec3(1.0, 2.0, 3.0), Vec3(0.1, 0.2, 0.3)});
        QVERIFY(near(d.force, {-1.0, 2.0, 3.0}));
        QVERIFY(near(d.torque, {0.1, -0.2, -0.3}));
        const core::Wrench w = map.wrenchToW(d);
        QVERIFY(near(w.force, {1.0, 2.0, 3.0}));
        QVERIFY(near(w.torque, {0.1, 0.2, 0.3}));
    }

    /// What turns is axial: mapping a lever and a force and then crossing them is mapping their torque, and a
    /// point on a turning body moves the same whichever is done first. A polar mapping of torque or spin
    /// fails here.
    void torqueAndSpinAreAxialUnderReflection_data() {
        QTest::addColumn<bool>("leftHanded");
        QTest::newRow("right-handed") << false;
        QTest::newRow("left-handed") << true;
    }
    void torqueAndSpinAreAxialUnderReflection() {
        QFETCH(bool, leftHanded);
        const devices::WorkspaceMap map(mapping(leftHanded, 1.0));
        core::Random random(1);
        for (int n = 0; n < 100; ++n) {
            const Vec3 lever = randomVector(random);
            const Vec3 force = randomVector(random);
            const Vec3 spin = randomVector(random);
            const core::Wrench w = map.wrenchToW({force, lever.cross(force)});
            QVERIFY(near(w.torque, map.velocityToW(lever).cross(w.force)));
            QVERIFY(
                near(map.velocityToW(spin.cross(lever)), map.angularToW(spin).cross(map.velocityToW(lever))));
        }
    }

    void powerIsTheSameOnBothSides() {
        core::Random random(2);
        for (const bool leftHanded : {false, true}) {
            const devices::WorkspaceMap map(mapping(leftHanded, 1.0));
            for (int n = 0; n < 100; ++n) {
                const Vec3 v = randomVector(random);
                const Vec3 w = randomVector(random);
                const core::Wrench tissue{randomVector(random), randomVector(random)};
                const core::Wrench d = map.wrenchToD(tissue);
                const double inW =
                    tissue.force.dot(map.velocityToW(v)) + tissue.torque.dot(map.angularToW(w));
                QVERIFY(std::abs(inW - d.force.dot(v) - d.torque.dot(w)) < 1e-12);
            }
        }
    }

    /// A base mounted otherwise, plain and mirrored: there and back, power, levers and orientation; and by
    /// hand for a quarter turn.
    void aTurnedBaseTurnsEverything() {
        const devices::WorkspaceMap quarter(
            turned(false, 2.0, Quat(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitZ()))));
        QVERIFY(near(quarter.pointToW({0.1, 0.2, 0.3}), {0.01 - 0.4, -0.02 + 0.2, 0.03 + 0.6}));
        QVERIFY(
            near(quarter.wrenchToD({Vec3::UnitX(), Vec3::UnitY()}).force, -Vec3::UnitY())); // W's x is D's -y
        core::Random random(4);
        for (const bool leftHanded : {false, true})
            for (int n = 0; n < 100; ++n) {
                const Quat turn =
                    Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
                const devices::WorkspaceMap map(turned(leftHanded, 1.5, turn));
                const Vec3 p = randomVector(random), v = randomVector(random), w = randomVector(random),
                           f = randomVector(random);
                QVERIFY(near(map.pointToD(map.pointToW(p)), p));
                const core::Wrench tissue{randomVector(random), randomVector(random)};
                const core::Wrench d = map.wrenchToD(tissue);
                QVERIFY(near(map.wrenchToW(d).force, tissue.force) &&
                        near(map.wrenchToW(d).torque, tissue.torque));
                QVERIFY(std::abs(tissue.force.dot(map.velocityToW(v)) - 1.5 * d.force.dot(v)) < 1e-12);
                QVERIFY(std::abs(tissue.torque.dot(map.angularToW(w)) - d.torque.dot(w)) < 1e-12);
                QVERIFY(near(map.wrenchToW({f, v.cross(f)}).torque,
                             (map.velocityToW(v) / 1.5).cross(map.wrenchToW({f, v}).force)));
                const Quat q =
                    Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
                QVERIFY(map.orientationToD(map.orientationToW(q)).angularDistance(q) < 1e-7);
                const Mat3 h = Vec3(leftHanded ? -1.0 : 1.0, 1.0, 1.0).asDiagonal();
                QVERIFY((map.orientationToW(q).toRotationMatrix() -
                         turn.toRotationMatrix() * h * q.toRotationMatrix() * h)
                            .norm() < 1e-12);
            }
    }

    void orientationIsConjugatedByTheReflection() {
        const devices::WorkspaceMap map(mapping(true, 2.0));
        const Mat3 h = Vec3(-1.0, 1.0, 1.0).asDiagonal();
        core::Random random(3);
        for (int n = 0; n < 100; ++n) {
            const Quat q =
                Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
            const Mat3 expected = h * q.toRotationMatrix() * h;
            const Mat3 got = map.orientationToW(q).toRotationMatrix();
            QVERIFY((got - expected).norm() < 1e-12);
            QVERIFY(std::abs(got.determinant() - 1.0) < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(TestWorkspaceMap)
#include "test_workspace_map.moc"
