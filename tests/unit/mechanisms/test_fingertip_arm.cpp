// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_arm_plant.h"
#include "mechanisms/fingertip_arm_verification.h"
#include "mechanisms/rotation_vector.h"

#include <Eigen/SVD>
#include <QtTest>
#include <cmath>
#include <limits>

using namespace chiron;
using core::Quat;
using core::Vec3;
using mechanisms::ArmReach;
using mechanisms::FingertipArmJoints;
using mechanisms::FingertipArmParameters;
using mechanisms::FingertipArmPlace;
using mechanisms::FingertipArmPlant;

namespace {

constexpr int kHandle = FingertipArmParameters::kHandle;

/// Corners, edges, faces and middle of the box that sessions use.
template <class Visit> void everywhere(const FingertipArmParameters& p, int steps, Visit&& visit) {
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            for (int k = 0; k <= steps; ++k) {
                const Vec3 share(static_cast<double>(i) / steps, static_cast<double>(j) / steps,
                                 static_cast<double>(k) / steps);
                visit(Vec3(p.boxMinimum_m + share.cwiseProduct(p.boxMaximum_m - p.boxMinimum_m)));
            }
}

FingertipArmParameters frictionless() {
    FingertipArmParameters p;
    for (auto& friction : p.friction)
        friction = {};
    p.fingerStiffness_Nm_per_rad = p.fingerDamping_Nms_per_rad = 0.0;
    return p;
}

QString wordsOf(const FingertipArmJoints& v) {
    QString out;
    for (int i = 0; i < FingertipArmParameters::kJoints; ++i)
        out += QString::number(v[i], 'g', 4) + ' ';
    return out;
}

double energyDrift(int substeps) {
    FingertipArmParameters p = frictionless();
    p.counterbalance = 0.0;
    FingertipArmPlant arm(p, 1);
    arm.reset({0.02, 0.03, 0.08});
    arm.ratesForTests() << 0.8, -0.5, 0.4, 1.0, -0.8, 1.2, 0.0;
    const double start = arm.energy_J();
    double worst = 0.0;
    for (int n = 0; n < 100 * substeps; ++n) {
        arm.step(core::kTickSeconds / substeps, {});
        worst = std::max(worst, std::abs(arm.energy_J() - start));
    }
    return worst;
}

} // namespace

class TestFingertipArm : public QObject {
    Q_OBJECT
private slots:
    void placeAgreesWithTheChain();
    void jacobianOfThePlaceIsItsDerivative();
    void inverseAndForwardAgree();
    void theWholeBoxIsReachedFarFromSingular();
    void posesOutOfReachAreAnswered();
    void singularPosesAreAnswered();
    void energyErrorFallsWithTheStep();
    void frictionTakesEnergyAlways();
    void aHeldArmStaysAndAHandFeelsLittleWeight();
    void gravityFallsOnTheHandWhenNothingBalances();
    void stopsHoldTheTravel();
    void strongPushesStayFinite();
    void encodersSayWhereThePadIs();
    void encodersHaveTheirResolution();
    void imuReadsAtItsRates();
    void imuTakesNoPeriodForEveryTick();
    void imuFollowsTheHandleWithinItsErrors();
    void theLeverFollowsTheFingers();
    void theApparentMassIsThatOfAPush();
    void theVerificationHolds();
    void theVerificationNoticesAWorseArm();
    void everyFigureOfTheVerificationHasItsBound();
    void theVerificationRefusesSettingsOutOfRange();
    void sameSeedSameBits();
};

void TestFingertipArm::placeAgreesWithTheChain() {
    core::Random random(11);
    const FingertipArmParameters p;
    mechanisms::FingertipArmDynamics chain(mechanisms::fingertipArmLinks(p));
    const FingertipArmPlace place(p.geometry);
    for (int n = 0; n < 100; ++n) {
        FingertipArmJoints q;
        for (int i = 0; i < FingertipArmParameters::kJoints; ++i)
            q[i] = random.uniform(-2.0, 2.0);
        chain.place(q);
        QVERIFY((chain.joint(FingertipArmParameters::kWrist) - place.place_D(q.head<3>())).norm() < 1e-14);
        QVERIFY((chain.joint(kHandle) - place.place_D(q.head<3>())).norm() <
                1e-14); // the wrist's axes meet in the pad
    }
}

void TestFingertipArm::jacobianOfThePlaceIsItsDerivative() {
    core::Random random(12);
    const FingertipArmPlace place;
    for (int n = 0; n < 100; ++n) {
        const Vec3 q(random.uniform(-1.2, 1.2), random.uniform(-1.4, 1.0), random.uniform(0.5, 2.7));
        const core::Mat3 j = place.jacobian(q);
        for (int i = 0; i < 3; ++i) {
            const Vec3 step = 1e-6 * Vec3::Unit(i);
            QVERIFY((j.col(i) - (place.place_D(q + step) - place.place_D(q - step)) / 2e-6).norm() < 1e-9);
        }
        const auto values = Eigen::JacobiSVD<core::Mat3>(j).singularValues();
        QVERIFY(std::abs(FingertipArmPlace::conditionNumber(j) / (values[0] / values[2]) - 1.0) < 1e-6);
    }
}

void TestFingertipArm::inverseAndForwardAgree() {
    core::Random random(13);
    const FingertipArmParameters p;
    mechanisms::FingertipArmDynamics chain(mechanisms::fingertipArmLinks(p));
    int reached = 0;
    for (int n = 0; n < 2000; ++n) {
        const Vec3 at(random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15), random.uniform(-0.05, 0.20));
        const Quat turn =
            mechanisms::turned(Quat::Identity(), Vec3(random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9),
                                                      random.uniform(-0.9, 0.9)));
        const auto posture = mechanisms::fingertipArmPosture(p, at, turn, 0.4);
        if (posture.reach != ArmReach::reached)
            continue;
        ++reached;
        chain.place(posture.q);
        QVERIFY((chain.joint(kHandle) - at).norm() < 1e-12);
        QVERIFY(mechanisms::rotationVectorOf(Quat(chain.orientation(kHandle)) * turn.conjugate()).norm() <
                1e-7);
        QCOMPARE(posture.q[6], 0.4);
        QVERIFY(posture.q[2] > 0.0); // elbow up
        const double elbow = chain.joint(2).z(), middle = 0.5 * (p.geometry.shoulder_D.z() + at.z());
        QVERIFY(elbow > middle);
    }
    QVERIFY2(reached > 1900, qPrintable(QString::number(reached)));
}

void TestFingertipArm::theWholeBoxIsReachedFarFromSingular() {
    const FingertipArmParameters p;
    const FingertipArmPlace place(p.geometry);
    double worst = 0.0, coarsest = 0.0;
    everywhere(p, 8, [&](const Vec3& at) {
        for (const Vec3& lean : {Vec3(0.0, 0.0, 0.0), Vec3(0.6, 0.0, 0.0), Vec3(-0.6, 0.0, 0.0),
                                 Vec3(0.0, 0.6, 0.0), Vec3(0.0, -0.6, 0.0), Vec3(0.0, 0.0, 0.8)}) {
            const auto posture =
                mechanisms::fingertipArmPosture(p, at, mechanisms::turned(Quat::Identity(), lean));
            QVERIFY2(posture.reach == ArmReach::reached,
                     qPrintable(QString("%1 %2 %3: %4, joint %5")
                                    .arg(at.x())
                                    .arg(at.y())
                                    .arg(at.z())
                                    .arg(mechanisms::wordsFor(posture.reach))
                                    .arg(posture.joint)));
            const core::Mat3 j = place.jacobian(posture.q.head<3>());
            worst = std::max(worst, FingertipArmPlace::conditionNumber(j));
            coarsest = std::max(coarsest, p.encoderResolution_rad() * j.colwise().norm().maxCoeff());
        }
    });
    qInfo("condition number at most %.2f, a count at most %.1f um", worst, 1e6 * coarsest);
    QVERIFY2(worst < 5.0, qPrintable(QString::number(worst)));
    QVERIFY(coarsest < 15e-6);
}

void TestFingertipArm::posesOutOfReachAreAnswered() {
    const FingertipArmParameters p;
    const auto reachOf = [&](const Vec3& at, const Quat& turn = Quat::Identity()) {
        return mechanisms::fingertipArmPosture(p, at, turn).reach;
    };
    QCOMPARE(reachOf({0.0, -0.5, 0.0}), ArmReach::tooFar);
    QCOMPARE(reachOf({0.0, 0.0, std::nan("")}), ArmReach::notANumber);
    QCOMPARE(reachOf({0.0, std::numeric_limits<double>::infinity(), 0.0}), ArmReach::notANumber);
    QCOMPARE(reachOf({0.0, 0.0, 0.05}, Quat(0.0, 0.0, 0.0, 0.0)), ArmReach::notANumber);
    QCOMPARE(reachOf(p.geometry.shoulder_D + Vec3(0.05, -0.02, 0.0)),
             ArmReach::beyondTravel); // folded beyond the elbow's stop
    const auto behind =
        mechanisms::fingertipArmPosture(p, p.geometry.shoulder_D + Vec3(0.0, 0.3, -0.1), Quat::Identity());
    QCOMPARE(behind.reach, ArmReach::beyondTravel);
    QCOMPARE(behind.joint, 0);
    QCOMPARE(reachOf({0.0, 0.0, 0.05}, mechanisms::turned(Quat::Identity(), Vec3(0.0, 1.4, 0.0))),
             ArmReach::beyondTravel); // the wrist's roll
    for (const ArmReach reach : {ArmReach::notANumber, ArmReach::tooFar, ArmReach::overShoulder,
                                 ArmReach::gimbalLock, ArmReach::beyondTravel})
        QVERIFY(QString::fromLatin1(mechanisms::wordsFor(reach)).size() > 10);
    FingertipArmPlant arm(p, 1); // a place out of reach: it stands in the middle of its box
    arm.reset({0.0, -5.0, 0.0});
    QVERIFY((arm.motion().p_DT - 0.5 * (p.boxMinimum_m + p.boxMaximum_m)).norm() < 1e-12);
}

void TestFingertipArm::singularPosesAreAnswered() {
    const FingertipArmParameters p;
    const mechanisms::FingertipArmGeometry& g = p.geometry;
    QCOMPARE(mechanisms::fingertipArmPosture(p, g.shoulder_D + Vec3(0.0, 0.0, -0.3), Quat::Identity()).reach,
             ArmReach::overShoulder);
    const auto stretched = mechanisms::fingertipArmPosture(
        p, g.shoulder_D + Vec3(0.0, -0.9999 * (g.upper_m + g.fore_m), 0.0), Quat::Identity());
    QCOMPARE(stretched.reach, ArmReach::beyondTravel); // the elbow's stop keeps it off
    QVERIFY(
        std::isinf(FingertipArmPlace::conditionNumber(FingertipArmPlace(g).jacobian(Vec3(0.2, -0.1, 0.0)))));
    const Quat locked = mechanisms::turned(
        Quat::Identity(), Vec3(0.0, 0.5 * core::kPi, 0.0)); // straight ahead, where the yaw is 0
    QCOMPARE(mechanisms::fingertipArmPosture(p, {0.0, 0.0, 0.05}, locked).reach, ArmReach::gimbalLock);
}

void TestFingertipArm::energyErrorFallsWithTheStep() {
    const double coarse = energyDrift(4), fine = energyDrift(32);
    QVERIFY2(fine < coarse / 4.0 && coarse < 0.02, qPrintable(QString("%1 %2").arg(coarse).arg(fine)));
}

void TestFingertipArm::frictionTakesEnergyAlways() {
    FingertipArmPlant arm({}, 1);
    arm.reset({0.0, 0.0, 0.05});
    core::Wrench push;
    push.force = Vec3(0.4, -0.3, 0.2);
    push.torque = Vec3(0.004, 0.002, -0.006);
    for (int n = 0; n < 400; ++n)
        arm.step(0.00025, push);
    double before = arm.energy_J();
    const double start = before;
    for (int n = 0; n < 4000; ++n) {
        arm.step(0.00025, {});
        // The step is of first order: a hundred-thousandth of what it began with is what it may ripple by.
        QVERIFY2(arm.energy_J() <= before + 1e-5 * std::abs(start),
                 qPrintable(QString("%1 %2").arg(n).arg(arm.energy_J() - before)));
        before = arm.energy_J();
    }
    QVERIFY2(arm.rates().norm() < 0.05, qPrintable(wordsOf(arm.rates())));
}

// Balanced to 98 %: what is left is about what friction holds, so that the arm stays where it is let go of,
// or sinks by 2 mm in half a second.
void TestFingertipArm::aHeldArmStaysAndAHandFeelsLittleWeight() {
    const FingertipArmParameters p;
    double most = 0.0;
    everywhere(p, 2, [&](const Vec3& at) {
        FingertipArmPlant arm(p, 1);
        arm.reset(at);
        // The force at the pad that carries what is left: the arm's three joints by their Jacobian.
        const Vec3 left = (1.0 - p.counterbalance) * arm.dynamics().gravity().head<3>();
        const core::Mat3 j = FingertipArmPlace(p.geometry).jacobian(arm.q().head<3>());
        most = std::max(most, Vec3(j.transpose().inverse() * left).norm());
        const Vec3 before = arm.motion().p_DT;
        for (int n = 0; n < 2000; ++n)
            arm.step(0.00025, {});
        const double sank = (arm.motion().p_DT - before).norm();
        QVERIFY2(sank < 3e-3, qPrintable(QString("%1 mm in half a second without a hand").arg(1e3 * sank)));
    });
    qInfo("weight at the pad at most %.3f N", most);
    QVERIFY2(most < 0.06, qPrintable(QString::number(most)));
}

void TestFingertipArm::gravityFallsOnTheHandWhenNothingBalances() {
    FingertipArmParameters p;
    p.counterbalance = 0.0;
    FingertipArmPlant arm(p, 1);
    arm.reset({0.0, 0.0, 0.1});
    for (int n = 0; n < 400; ++n)
        arm.step(0.00025, {});
    QVERIFY2(arm.motion().p_DT.z() < 0.08, qPrintable(QString::number(arm.motion().p_DT.z())));
}

void TestFingertipArm::stopsHoldTheTravel() {
    const FingertipArmParameters p;
    FingertipArmPlant arm(p, 1);
    for (const Vec3& direction : {Vec3(1.0, 0.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.3),
                                  Vec3(0.0, -1.0, -0.3), Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)}) {
        arm.reset({0.0, 0.0, 0.05});
        core::Wrench push;
        push.force = 5.0 * direction;
        push.torque = Vec3(0.05, 0.05, -0.05);
        for (int n = 0; n < 16000; ++n)
            arm.step(0.00025, push);
        for (int i = 0; i < FingertipArmParameters::kJoints; ++i) {
            const auto at = static_cast<std::size_t>(i);
            QVERIFY2(arm.q()[i] > p.minimum[at] - 0.1 && arm.q()[i] < p.maximum[at] + 0.1,
                     qPrintable(QString("joint %1: %2").arg(i).arg(arm.q()[i])));
        }
        QVERIFY2(arm.rates().norm() < 0.5, qPrintable(wordsOf(arm.rates()) + " at " + wordsOf(arm.q())));
    }
}

void TestFingertipArm::strongPushesStayFinite() {
    core::Random random(14);
    FingertipArmPlant arm({}, 1);
    core::Wrench push;
    for (int n = 0; n < 20000; ++n) {
        if (n % 200 == 0) {
            push.force =
                Vec3(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0));
            push.torque =
                Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
            arm.holdLever(random.uniform(0.0, 1.6));
        }
        arm.step(0.00025, push);
        QVERIFY2(arm.rates().allFinite() && arm.rates().norm() < 500.0,
                 qPrintable(QString("%1: %2").arg(n).arg(arm.rates().norm())));
    }
}

// Through forward kinematics: off by the run-out of the magnets, which is smooth, and a count or two.
void TestFingertipArm::encodersSayWhereThePadIs() {
    const FingertipArmParameters p;
    const FingertipArmPlace place(p.geometry);
    double worst = 0.0;
    everywhere(p, 4, [&](const Vec3& at) {
        FingertipArmPlant arm(p, 3);
        arm.reset(at);
        const auto counts = arm.encoderCounts();
        const Vec3 q = p.encoderResolution_rad() * Vec3(counts[0], counts[1], counts[2]);
        worst = std::max(worst, (place.place_D(q) - at).norm());
    });
    qInfo("the pad is taken to be up to %.2f mm beside", 1e3 * worst);
    QVERIFY2(worst < 0.5e-3, qPrintable(QString::number(worst)));
    QVERIFY(worst > 0.02e-3); // the run-out is there
}

void TestFingertipArm::encodersHaveTheirResolution() {
    for (const int bits : {14, 18}) {
        FingertipArmParameters p;
        p.encoderBits = bits;
        p.encoderRunout_rad = {0.0, 0.0};
        p.encoderNoise_counts = 0.0;
        QCOMPARE(p.encoderResolution_rad() * std::pow(2.0, bits), 2.0 * core::kPi);
        FingertipArmPlant arm(p, 1);
        arm.reset({0.03, 0.02, 0.05});
        for (int i = 0; i < 3; ++i)
            QVERIFY(std::abs(arm.encoderCounts()[static_cast<std::size_t>(i)] * p.encoderResolution_rad() -
                             arm.q()[i]) <= 0.5 * p.encoderResolution_rad() + 1e-12);
    }
}

void TestFingertipArm::imuReadsAtItsRates() {
    mechanisms::AttitudeSensorParameters p;
    p.gyroPeriod_ticks = 4;
    mechanisms::AttitudeSensor imu(p, 1);
    int rates = 0, accelerations = 0;
    Vec3 rate = imu.rate_T(), acceleration = imu.acceleration_T();
    for (int n = 0; n < 1000; ++n) {
        imu.tick(Quat::Identity(), Vec3::Zero(), Vec3::Zero());
        rates += imu.rate_T() != rate ? 1 : 0;
        accelerations += imu.acceleration_T() != acceleration ? 1 : 0;
        rate = imu.rate_T();
        acceleration = imu.acceleration_T();
    }
    QCOMPARE(rates, 250);
    QCOMPARE(accelerations, 100); // 100 Hz
}

/// A period of no tick is that of every tick, for each of the three readings.
void TestFingertipArm::imuTakesNoPeriodForEveryTick() {
    using mechanisms::AttitudeSensor;
    const auto sensor = [](int gyro, int tilt, int heading) {
        mechanisms::AttitudeSensorParameters p;
        p.gyroPeriod_ticks = gyro;
        p.tiltPeriod_ticks = tilt;
        p.headingPeriod_ticks = heading;
        return AttitudeSensor(p, 7);
    };
    const auto differs = [](AttitudeSensor a, AttitudeSensor b) {
        bool different = false;
        for (int n = 0; n < 200; ++n) {
            const Quat q = mechanisms::turned(Quat::Identity(), {0.002 * n, 0.0, 0.001 * n});
            for (AttitudeSensor* one : {&a, &b})
                one->tick(q, {2.0, 0.0, 1.0}, {0.1, 0.0, -0.2});
            different = different || a.counts() != b.counts() ||
                        a.attitude().coeffs() != b.attitude().coeffs() || a.rate_T() != b.rate_T() ||
                        a.acceleration_T() != b.acceleration_T();
        }
        return different;
    };
    const AttitudeSensor every = sensor(1, 1, 1);
    QVERIFY(!differs(every, sensor(0, 1, 1)) && !differs(every, sensor(1, 0, 1)) &&
            !differs(every, sensor(1, 1, 0)));
    QVERIFY(differs(every, sensor(2, 1, 1)) && differs(every, sensor(1, 2, 1)) &&
            differs(every, sensor(1, 1, 2)));
}

void TestFingertipArm::imuFollowsTheHandleWithinItsErrors() {
    // Without errors it is exact but for the step and the count; with them within a degree, over two minutes
    // of turning and shaking.
    mechanisms::AttitudeSensorParameters perfect;
    perfect.rateNoise_rad_per_s_rtHz = perfect.rateBias_rad_per_s = perfect.accelerationNoise_m_per_s2_rtHz =
        0.0;
    perfect.accelerationBias_m_per_s2 = perfect.headingError_rad = 0.0;
    const auto worstOf = [](const mechanisms::AttitudeSensorParameters& p, std::uint64_t seed,
                            double shake_m_per_s2, int ticks) {
        mechanisms::AttitudeSensor imu(p, seed);
        Quat q = Quat::Identity();
        double worst = 0.0;
        for (int n = 0; n < ticks; ++n) {
            const double t = 1e-3 * n;
            const Vec3 w(0.6 * std::cos(1.3 * t), 0.5 * std::cos(0.9 * t), 0.4 * std::cos(0.7 * t));
            q = mechanisms::turned(q, 1e-3 * w);
            imu.tick(q, w,
                     Vec3(shake_m_per_s2 * std::sin(12.0 * t), 0.0, shake_m_per_s2 * std::cos(9.0 * t)));
            const Vec3 told(imu.counts()[0] * p.resolution_rad, imu.counts()[1] * p.resolution_rad,
                            imu.counts()[2] * p.resolution_rad);
            worst = std::max(worst, mechanisms::rotationVectorOf(mechanisms::turned(Quat::Identity(), told) *
                                                                 q.conjugate())
                                        .norm());
        }
        return worst;
    };
    const double exact = worstOf(perfect, 1, 0.0, 20000);
    QVERIFY2(exact < 2e-4, qPrintable(QString::number(exact)));
    double worst = 0.0, least = 1.0;
    for (std::uint64_t seed = 21; seed < 27; ++seed) {
        const double one = worstOf({}, seed, 2.0, 120000);
        worst = std::max(worst, one);
        least = std::min(least, one);
    }
    QVERIFY2(worst < core::radFromDeg(2.5) && least > core::radFromDeg(0.1),
             qPrintable(QString("%1 %2").arg(worst).arg(least)));
}

void TestFingertipArm::theLeverFollowsTheFingers() {
    FingertipArmPlant arm({}, 1);
    const FingertipArmParameters p;
    QCOMPARE(arm.jawCounts(), 0);
    arm.holdLever(0.8);
    core::Wrench still;
    for (int n = 0; n < 2000; ++n) {
        const auto motion = arm.motion();
        still.force = 2000.0 * (0.5 * (p.boxMinimum_m + p.boxMaximum_m) - motion.p_DT) - 10.0 * motion.v_DT;
        still.torque = -5.0 * mechanisms::rotationVectorOf(motion.q_DT) - 0.025 * motion.w_DT;
        arm.step(0.00025, still);
    }
    arm.endTick();
    QVERIFY2(std::abs(arm.jawCounts() * p.grasp.resolution_rad() - 0.8) < 0.01,
             qPrintable(QString::number(arm.jawCounts())));
    QVERIFY(mechanisms::rotationVectorOf(arm.motion().q_DT).norm() < 0.01); // squeezing turns nothing
}

void TestFingertipArm::theApparentMassIsThatOfAPush() {
    const FingertipArmParameters p = frictionless();
    double least = 1e9, most = 0.0;
    everywhere(p, 2, [&](const Vec3& at) {
        FingertipArmPlant arm(p, 1);
        arm.reset(at);
        least = std::min(least, arm.apparentMass_kg());
        most = std::max(most, arm.apparentMass_kg());
    });
    qInfo("%.3f to %.3f kg", least, most);
    QVERIFY2(least > 0.12 && most < 0.35, qPrintable(QString("%1 %2").arg(least).arg(most)));
    FingertipArmPlant arm(p, 1);
    arm.reset({0.0, 0.0, 0.05});
    double sum = 0.0;
    for (int axis = 0; axis < 3;
         ++axis) { // with the handle held from turning, as a hand does: an upper bound of what moves freely
        FingertipArmPlant pushed(p, 1);
        pushed.reset({0.0, 0.0, 0.05});
        core::Wrench push;
        push.force = Vec3::Unit(axis);
        pushed.step(1e-5, push);
        sum += pushed.motion().v_DT[axis] / 1e-5;
    }
    QVERIFY(sum / 3.0 > 0.8 / arm.apparentMass_kg() && sum / 3.0 < 1.6 / arm.apparentMass_kg());
}

void TestFingertipArm::theVerificationHolds() {
    const auto v = mechanisms::verifyFingertipArm({}, 77).value();
    QVERIFY(v.holds());
    QCOMPARE(v.poses, 9 * 9 * 9 * 6);
    QCOMPARE(v.drags.size(), std::size_t{9});
    for (const auto& drag : v.drags) // in the middle of the travel: 0.06 N and 0.5 N·s/m at the pad
                                     // (models.md §4), by direction and with the wrist's
        QVERIFY2(drag.felt_N > 0.04 && drag.felt_N < 0.12 + 1.0 * drag.speed_m_per_s,
                 qPrintable(QString("%1 %2: %3").arg(drag.axis).arg(drag.speed_m_per_s).arg(drag.felt_N)));
    qInfo("friction %.2f %%, condition %.3f, weight %.3f N, sinks %.2f mm, place %.3f mm, jacobian %.1e, "
          "gravity %.1e",
          100.0 * v.frictionError(), v.condition, v.weight_N, 1e3 * v.sinks_m, 1e3 * v.place_m, v.jacobian,
          v.gravity_Nm);
}

// Each figure has to be able to fail.
void TestFingertipArm::theVerificationNoticesAWorseArm() {
    using Bounds = mechanisms::FingertipArmBounds;
    const auto with = [](auto&& change) {
        FingertipArmParameters p;
        change(p);
        return mechanisms::verifyFingertipArm(p, 77, {.grid = 2, .speeds_m_per_s = {0.20}}).value();
    };
    const auto asItIs = with([](FingertipArmParameters&) {});
    QVERIFY(asItIs.holds());
    const auto shorter = with([](FingertipArmParameters& p) { p.geometry.fore_m = 0.20; });
    QVERIFY(shorter.reached < shorter.poses && !shorter.holds());
    const auto heavy = with([](FingertipArmParameters& p) { p.counterbalance = 0.90; });
    QVERIFY(heavy.weight_N > Bounds::kWeight_N && heavy.sinks_m > Bounds::kSinks_m && !heavy.holds());
    const auto coarse = with([](FingertipArmParameters& p) {
        p.encoderBits = 14;
        p.encoderRunout_rad[0] *= 5.0;
    });
    QVERIFY(coarse.countMost_m > Bounds::kCount_m && coarse.place_m > Bounds::kPlace_m && !coarse.holds());
    const auto rough =
        with([](FingertipArmParameters& p) { // what the joints were given is what is felt, whatever it is
            for (auto& friction : p.friction)
                friction.coulomb *= 3.0;
        });
    QVERIFY(rough.frictionError() < Bounds::kFriction);
    QVERIFY(rough.drags[0].felt_N > 1.5 * asItIs.drags[0].felt_N);
    auto other = asItIs;
    other.drags[0].felt_N = 1.06 * other.drags[0].given_N;
    QVERIFY(!other.holds());
    other.drags[0].felt_N = std::nan(""); // not measured is not fulfilled, wherever it stands
    QVERIFY(std::isnan(other.frictionError()) && !other.holds());
    other = asItIs;
    other.drags.back().felt_N = std::nan("");
    QVERIFY(std::isnan(other.frictionError()) && !other.holds());
    QVERIFY(!mechanisms::FingertipArmVerification{}.holds());
}

/// Each figure decides alone, at the bound that is stated for it, whatever the others are.
void TestFingertipArm::everyFigureOfTheVerificationHasItsBound() {
    using V = mechanisms::FingertipArmVerification;
    V most;
    most.poses = most.reached = 6;
    most.drags.push_back({0, 0.1, 1.05, 1.0});
    const std::pair<double V::*, double> figures[] = {
        {&V::condition, 5.0}, {&V::inverse_m, 1e-9},    {&V::inverse_rad, 1e-6},
        {&V::jacobian, 1e-6}, {&V::gravity_Nm, 1e-6},   {&V::weight_N, 0.06},
        {&V::sinks_m, 0.003}, {&V::countMost_m, 15e-6}, {&V::place_m, 0.0005}};
    for (const auto& [figure, bound] : figures)
        most.*figure = 0.999 * bound;
    most.drags[0].felt_N = 1.0499;
    QVERIFY(most.holds());
    const auto holds = [&most](auto change) {
        V v = most;
        change(v);
        return v.holds();
    };
    for (const auto& [figure, bound] : figures)
        for (const double value : {1.001 * bound, std::nan("")})
            QVERIFY2(!holds([f = figure, value](V& v) { v.*f = value; }), qPrintable(QString::number(value)));
    QVERIFY(!holds([](V& v) { v.reached = 5; }));
    QVERIFY(!holds([](V& v) { v.poses = v.reached = 0; }));
    QVERIFY(!holds([](V& v) { v.drags.clear(); }));
    QVERIFY(!holds([](V& v) { v.drags[0].felt_N = 1.0501; }));
}

/// Of no grid at all every figure would be 0, or not a number, and at no speed the pad would be moved for
/// ever.
void TestFingertipArm::theVerificationRefusesSettingsOutOfRange() {
    const auto refused = [](int grid, const std::vector<double>& speeds_m_per_s) {
        const auto v = mechanisms::verifyFingertipArm({}, 77, {grid, speeds_m_per_s});
        return !v && v.error().code == core::ErrorCode::badInput;
    };
    for (const int grid : {-1, 0, 51})
        QVERIFY2(refused(grid, {0.2}), qPrintable(QString::number(grid)));
    QVERIFY(refused(2, {}));
    for (const double speed : {0.0, -0.2, 0.0049, 1.001, HUGE_VAL, std::nan("")}) {
        QVERIFY2(refused(2, {speed}), qPrintable(QString::number(speed)));
        QVERIFY2(refused(2, {0.2, speed}), qPrintable(QString::number(speed)));
    }
    const auto coarsest = mechanisms::verifyFingertipArm({}, 77, {1, {1.0}});
    QVERIFY(coarsest.has_value());
    QCOMPARE(coarsest->poses, 2 * 2 * 2 * 6);
    QCOMPARE(coarsest->drags.size(), std::size_t{3});
    for (const auto& drag : coarsest->drags)
        QVERIFY(std::isfinite(drag.felt_N) && drag.given_N > 0.0);
}

void TestFingertipArm::sameSeedSameBits() {
    FingertipArmPlant a({}, 5), b({}, 5), c({}, 6);
    bool differs = false;
    core::Wrench push;
    for (int n = 0; n < 1000; ++n) {
        push.force = Vec3(0.3 * std::sin(0.01 * n), 0.2, 0.1);
        for (FingertipArmPlant* arm : {&a, &b, &c}) {
            for (int step = 0; step < 4; ++step)
                arm->step(0.00025, push);
            arm->endTick();
        }
        QVERIFY(std::equal(a.encoderCounts().begin(), a.encoderCounts().end(), b.encoderCounts().begin()));
        differs = differs ||
                  !std::equal(a.encoderCounts().begin(), a.encoderCounts().end(), c.encoderCounts().begin());
    }
    QVERIFY(differs);
    a.reset({0.0, 0.0, 0.05});
    FingertipArmPlant fresh({}, 5);
    fresh.reset({0.0, 0.0, 0.05});
    for (int n = 0; n < 200; ++n) {
        a.step(0.001, push);
        a.endTick();
        fresh.step(0.001, push);
        fresh.endTick();
        QVERIFY(
            std::equal(a.encoderCounts().begin(), a.encoderCounts().end(), fresh.encoderCounts().begin()));
    }
}

QTEST_APPLESS_MAIN(TestFingertipArm)
#include "test_fingertip_arm.moc"
