// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "mechanisms/finger_pad.h"
#include "mechanisms/fingertip_kinematics.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Mat3;
using core::Vec3;
using mechanisms::FingertipKinematics;
using mechanisms::FingertipLoop;
using mechanisms::FingertipPose;

namespace {

FingertipPose anyPose(core::Random& random, const mechanisms::FingertipGeometry& g) {
    return {random.uniform(-0.006, 0.006), random.uniform(-g.maximumPitch_rad, g.maximumPitch_rad),
            random.uniform(-g.maximumRoll_rad, g.maximumRoll_rad)};
}

} // namespace

class TestFingertipKinematics : public QObject {
    Q_OBJECT
private slots:
    void levelIsWhereTheFormulaSays();
    void theLegsAreAsLongAsTheyAre();
    void turnAndShiftAreThoseOfTheRadialPlanes();
    void roundTrips();
    void jacobianAgreesWithDifferences();
    void powerIsKept();
    void normalIsThatOfPitchThenRoll();
    void whatIsOutOfReachIsRefused();
    void padGradientAgreesWithDifferences();
};

void TestFingertipKinematics::levelIsWhereTheFormulaSays() {
    const FingertipKinematics k;
    const auto& g = k.geometry();
    const double s = g.railRadius_m - g.platformRadius_m;
    const auto q = k.inverse({0.003, 0.0, 0.0});
    QVERIFY(q.has_value());
    for (int i = 0; i < 3; ++i)
        QVERIFY(std::abs((*q)[i] - (0.003 - std::sqrt(g.leg_m * g.leg_m - s * s))) < 1e-15);
    const FingertipLoop tilted =
        k.loop({0.0, g.maximumPitch_rad, g.maximumRoll_rad}); // devices.md §5: about 1 mm
    QVERIFY(tilted.centre.head<2>().norm() > 0.7e-3 && tilted.centre.head<2>().norm() < 1.6e-3);
}

// Independent of the code's own way: joints from the loop's turn and centre, carriages on their rails.
void TestFingertipKinematics::theLegsAreAsLongAsTheyAre() {
    const FingertipKinematics k;
    core::Random random(1);
    for (int n = 0; n < 500; ++n) {
        const FingertipLoop at = k.loop(anyPose(random, k.geometry()));
        for (int i = 0; i < 3; ++i) {
            const double phi = i * 2.0 * core::kPi / 3.0;
            const Vec3 out(std::cos(phi), std::sin(phi), 0.0);
            const Vec3 joint = at.centre + at.turn * (k.geometry().platformRadius_m * out);
            const Vec3 carriage = k.geometry().railRadius_m * out + Vec3(0.0, 0.0, at.drives[i]);
            QVERIFY(std::abs((joint - carriage).norm() - k.geometry().leg_m) < 1e-12);
            QVERIFY(std::abs(joint.dot(Vec3(-std::sin(phi), std::cos(phi), 0.0))) <
                    1e-15); // in its radial plane
            QVERIFY(joint.z() > carriage.z());
        }
    }
}

void TestFingertipKinematics::turnAndShiftAreThoseOfTheRadialPlanes() {
    const FingertipKinematics k;
    const double r = k.geometry().platformRadius_m;
    core::Random random(2);
    for (int n = 0; n < 200; ++n) {
        const FingertipPose pose = anyPose(random, k.geometry());
        const FingertipLoop at = k.loop(pose);
        const Mat3 before = (Eigen::AngleAxisd(pose.pitch_rad, Vec3::UnitX()) *
                             Eigen::AngleAxisd(pose.roll_rad, Vec3::UnitY()))
                                .toRotationMatrix();
        const double gamma = std::atan2(before(0, 1) - before(1, 0), before(0, 0) + before(1, 1));
        const Mat3 m = before * Eigen::AngleAxisd(gamma, Vec3::UnitZ()).toRotationMatrix();
        QVERIFY((m - at.turn).norm() < 1e-14);
        QVERIFY(std::abs(m(0, 1) - m(1, 0)) < 1e-15);
        QVERIFY((at.centre - Vec3(0.5 * r * (m(0, 0) - m(1, 1)), -r * m(1, 0), pose.z_m)).norm() < 1e-16);
    }
}

void TestFingertipKinematics::roundTrips() {
    const FingertipKinematics k;
    core::Random random(3);
    for (int n = 0; n < 1000; ++n) {
        const FingertipPose pose = anyPose(random, k.geometry());
        const auto q = k.inverse(pose);
        QVERIFY(q.has_value());
        const auto back = k.forward(*q);
        QVERIFY(back.has_value());
        QVERIFY(std::abs(back->z_m - pose.z_m) < 1e-12 &&
                std::abs(back->pitch_rad - pose.pitch_rad) < 1e-11 &&
                std::abs(back->roll_rad - pose.roll_rad) < 1e-11);
        QVERIFY((k.loop(*back).drives - *q).cwiseAbs().maxCoeff() < 1e-12);
    }
}

void TestFingertipKinematics::jacobianAgreesWithDifferences() {
    const FingertipKinematics k;
    core::Random random(4);
    constexpr double kStep = 1e-6;
    for (int n = 0; n < 200; ++n) {
        const Vec3 x = anyPose(random, k.geometry()).vector();
        const FingertipLoop at = k.loop(FingertipPose::of(x));
        for (int i = 0; i < 3; ++i) {
            const Vec3 e = kStep * Vec3::Unit(i);
            const FingertipLoop a = k.loop(FingertipPose::of(x - e)), b = k.loop(FingertipPose::of(x + e));
            QVERIFY(((b.drives - a.drives) / (2.0 * kStep) - at.jacobian.col(i)).norm() < 1e-9);
            QVERIFY(((b.centre - a.centre) / (2.0 * kStep) - at.centreBy.col(i)).norm() < 1e-9);
            QVERIFY(((b.normal - a.normal) / (2.0 * kStep) - at.normalBy.col(i)).norm() < 1e-9);
        }
    }
}

void TestFingertipKinematics::powerIsKept() {
    const FingertipKinematics k;
    core::Random random(5);
    for (int n = 0; n < 200; ++n) {
        const FingertipLoop at = k.loop(anyPose(random, k.geometry()));
        const Vec3 wanted(random.normal(), 0.01 * random.normal(), 0.01 * random.normal());
        const Vec3 rates(random.normal(), random.normal(), random.normal());
        const Vec3 drive = FingertipKinematics::driveForces(at, wanted);
        QVERIFY(std::abs(drive.dot(at.jacobian * rates) - wanted.dot(rates)) < 1e-9);
        QVERIFY((FingertipKinematics::onPlatform(at, drive) - wanted).norm() < 1e-12);
    }
    const FingertipLoop level = k.loop({});
    const Vec3 equal = FingertipKinematics::driveForces(level, {3.0, 0.0, 0.0});
    QVERIFY((equal - Vec3::Ones()).norm() < 1e-12); // a third each
}

// The lean's signs (brief of the display): positive roll leans to +x, positive pitch to −y.
void TestFingertipKinematics::normalIsThatOfPitchThenRoll() {
    const FingertipKinematics k;
    QVERIFY(k.loop({0.0, 0.0, 0.2}).normal.x() > 0.19);
    QVERIFY(k.loop({0.0, 0.2, 0.0}).normal.y() < -0.19);
}

void TestFingertipKinematics::whatIsOutOfReachIsRefused() {
    const FingertipKinematics k;
    const auto& g = k.geometry();
    QVERIFY(k.inverse({0.0, g.maximumPitch_rad, g.maximumRoll_rad}).has_value());
    QVERIFY(k.inverse({0.0, -g.maximumPitch_rad, -g.maximumRoll_rad}).has_value());
    for (const FingertipPose bad :
         {FingertipPose{0.0, g.maximumPitch_rad + 1e-6, 0.0},
          FingertipPose{0.0, 0.0, -g.maximumRoll_rad - 1e-6}, FingertipPose{0.05, 0.0, 0.0},
          FingertipPose{-0.05, 0.0, 0.0}, FingertipPose{std::nan(""), 0.0, 0.0},
          FingertipPose{0.0, std::nan(""), 0.0}}) {
        const auto refused = k.inverse(bad);
        QVERIFY(!refused && refused.error().code == core::ErrorCode::badInput);
    }
    mechanisms::FingertipGeometry shortLegs = g;
    shortLegs.leg_m = 0.005; // no longer than the gap it has to bridge: it lies flat
    QVERIFY(!FingertipKinematics(shortLegs).inverse({}));
    QVERIFY(!k.forward(Vec3(0.0, 0.1, -0.1)));
    QVERIFY(!k.forward(Vec3(std::nan(""), 0.0, 0.0)));
}

void TestFingertipKinematics::padGradientAgreesWithDifferences() {
    const FingertipKinematics k;
    const mechanisms::FingerPad pad{mechanisms::FingerPadParameters{}};
    core::Random random(6);
    constexpr double kStep = 1e-6;
    QVERIFY(std::abs(pad.penetration(k.loop({}))) < 1e-15); // level at zero just touches
    for (const double surface_m : {-0.0011, 0.0008}) { // a thin and a thick finger: touched where its skin is
        mechanisms::FingerPadParameters finger;
        finger.surface_m = surface_m;
        QVERIFY(std::abs(mechanisms::FingerPad(finger).penetration(k.loop({surface_m, 0.0, 0.0}))) < 1e-15);
        QVERIFY(std::abs(mechanisms::FingerPad(finger).penetration(k.loop({surface_m + 0.0005, 0.0, 0.0})) -
                         0.0005) < 1e-12);
        QVERIFY(std::abs(mechanisms::FingerPad(finger).heightFor(k.loop({}), 0.0) - surface_m) < 1e-12);
    }
    for (int n = 0; n < 100; ++n) {
        const Vec3 x = anyPose(random, k.geometry()).vector();
        const Vec3 gradient = pad.gradient(k.loop(FingertipPose::of(x)));
        for (int i = 0; i < 3; ++i) {
            const Vec3 e = kStep * Vec3::Unit(i);
            const double d = pad.penetration(k.loop(FingertipPose::of(x + e))) -
                             pad.penetration(k.loop(FingertipPose::of(x - e)));
            QVERIFY(std::abs(d / (2.0 * kStep) - gradient[i]) < 1e-9);
        }
        const FingertipLoop at = k.loop(FingertipPose::of(x));
        const double height = pad.heightFor(at, 0.001);
        QVERIFY(std::abs(pad.penetration(k.loop({height, x[1], x[2]})) - 0.001) < 1e-12);
    }
    for (const double force : {0.0, 0.01, 1.0, 4.0})
        QVERIFY(std::abs(pad.elasticForce(pad.depthOf(force)) - force) < 1e-12);
    QVERIFY(std::abs((pad.energy_J(0.001 + 1e-7) - pad.energy_J(0.001 - 1e-7)) / 2e-7 -
                     pad.elasticForce(0.001)) < 1e-6);
}

QTEST_APPLESS_MAIN(TestFingertipKinematics)
#include "test_fingertip_kinematics.moc"
