// SPDX-License-Identifier: GPL-3.0-or-later
// Caps, slew, over-velocity, set-up: exact numbers.
#include "core/random.h"
#include "haptics/safety_caps.h"
#include "haptics/safety_slew.h"
#include "unit/haptics/safety_rig.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using core::CommandKind;
using core::ForceState;
using core::Vec3;
using test::SafetyRig;
using test::sixAxisDevice;
namespace guard_bits = core::guard_bits;

class TestSafetyLimits : public QObject {
    Q_OBJECT
private slots:
    void forceCapIsTheSmallestOfThree();
    void axisCapsHoldInTheDevicesFrame();
    void aForceMayBendIntoItsCap();
    void aLoadIsCapped();
    void axisCapsFollowThePose();
    void capsHoldWhereTheSlewKeepsPartOfTheLastForce();
    void aKinematicsWithoutAnAnswerGivesNoForce();
    void passiveAxesAreLeftOut();
    void devicesWithoutTorqueKeepTheirForce();
    void hugeRequestsKeepTheirDirection();
    void leftHandedWorkspaceMirrorsForceAndTorque();
    void risesAreSlewedAndDecreasesAreNot();
    void turnsAreSlewed();
    void torqueIsSlewed();
    void slewNeverExceedsTheTarget();
    void overVelocityIsLatchedAndDampsOnly();
    void overVelocityDampsOnlyWhatPushes();
    void overVelocityCountsTheHandsSpeed();
    void configureRefusesNonsense();
};

void TestSafetyLimits::forceCapIsTheSmallestOfThree() {
    const auto capped = [](double device, double exercise, double site) {
        auto descriptor = sixAxisDevice(100.0);
        descriptor.maximumForce_N = device;
        haptics::SafetySettings settings;
        settings.exerciseForce_N = exercise;
        settings.siteForce_N = site;
        SafetyRig rig(descriptor, settings);
        rig.arm();
        rig.ask(Vec3(30, 40, 0));
        rig.ticks(100);
        return rig.force();
    };
    QVERIFY((capped(10, 4, 4) - Vec3(2.4, 3.2, 0)).norm() < 1e-9);
    QVERIFY((capped(2, 4, 4) - Vec3(1.2, 1.6, 0)).norm() < 1e-9);
    QVERIFY((capped(10, 1, 4) - Vec3(0.6, 0.8, 0)).norm() < 1e-9);
    QVERIFY(capped(10, 4, 4).norm() <= 4.0);
    QCOMPARE(capped(0, 4, 4), Vec3(0, 0, 0)); // a device without force
}

void TestSafetyLimits::axisCapsHoldInTheDevicesFrame() {
    auto device = sixAxisDevice(10.0);
    device.axes[0].continuousRating = 1.0;
    SafetyRig rig(device);
    rig.arm();
    rig.ask(Vec3(2, 1, 0), Vec3(0.04, 0, 0));
    rig.ticks(10);
    // Halved as a whole, torque included: the direction of the wrench is kept.
    QVERIFY((rig.force() - Vec3(1, 0.5, 0)).norm() < 1e-9);
    QVERIFY(std::abs(rig.out.tools[0].wrench_W.torque.x() - 0.02) < 1e-9);
    QVERIFY(rig.force().x() <= 1.0);
    QVERIFY(rig.out.guards & guard_bits::kCap);
}

// x up to 1 − w, ever nearer to 1 beyond, and no corner between; nothing is ever more than asked for, or more
// than the cap.
void TestSafetyLimits::aForceMayBendIntoItsCap() {
    for (const double w : {0.05, 0.2, 0.5}) {
        double before = 0.0, slope = 1.0, sum = 0.0;
        const double dx = 1e-4;
        for (double x = dx; x < 2.0; x += dx) {
            const double y = haptics::bentToCap(x, w), steep = (y - before) / dx;
            QVERIFY(y <= std::min(1.0, x) + 1e-12 && y >= before);
            QVERIFY(std::abs(steep - slope) <= 1.01 * dx / w + 1e-9); // bends by 1/w at most
            sum += 0.5 * (y + before) * dx;
            QVERIFY(std::abs(haptics::bentEnergy(x, w) * 0.5 * x * x - sum) < 1e-6);
            before = y;
            slope = steep;
        }
        QCOMPARE(haptics::bentToCap(1.0 - w, w), 1.0 - w);
        QVERIFY(haptics::bentToCap(1.0 + 30.0 * w, w) > 1.0 - 1e-12);
    }
    QCOMPARE(haptics::bentToCap(0.999, 0.0), 0.999);
    QCOMPARE(haptics::bentToCap(1.001, 0.0), 1.0);

    haptics::SafetySettings settings;
    settings.capKnee = 0.2;
    const auto felt = [&](const Vec3& asked) {
        SafetyRig rig(sixAxisDevice(100.0), settings);
        rig.arm();
        rig.ask(asked);
        rig.ticks(100);
        return std::pair(rig.force(), (rig.out.guards & guard_bits::kCap) != 0);
    };
    QCOMPARE(felt(Vec3(0, 0, 3.2)).first, Vec3(0, 0, 3.2));
    QVERIFY(!felt(Vec3(0, 0, 3.2)).second);
    const double part = 1.0 - 0.2 * std::exp(-1.0);
    QVERIFY((felt(Vec3(2.4, 3.2, 0)).first - part * Vec3(2.4, 3.2, 0)).norm() < 1e-9); // 4 N: 3.71
    QVERIFY(felt(Vec3(2.4, 3.2, 0)).second);
    QVERIFY(felt(Vec3(30, 40, 0)).first.norm() <= 4.0);
    for (const double bad : {-0.1, 0.6, std::numeric_limits<double>::quiet_NaN()}) {
        settings.capKnee = bad;
        QVERIFY(!SafetyRig(sixAxisDevice(), settings).accepted);
    }
}

// A scene that says how much a place loads at most is capped by that, whatever it answers there.
void TestSafetyLimits::aLoadIsCapped() {
    SafetyRig rig(sixAxisDevice(100.0));
    rig.arm();
    rig.ask(Vec3(2, 0, 0));
    rig.scene.load_N[0] = 8.0;
    rig.ticks(100);
    QVERIFY((rig.force() - Vec3(1, 0, 0)).norm() < 1e-9);
    rig.scene.load_N[0] = 1.0; // less than what is asked for: that counts
    rig.ask(Vec3(8, 0, 0));
    rig.ticks(100);
    QVERIFY((rig.force() - Vec3(4, 0, 0)).norm() < 1e-9);
    rig.scene.load_N[0] = std::numeric_limits<double>::quiet_NaN();
    rig.ticks(10);
    QVERIFY((rig.force() - Vec3(4, 0, 0)).norm() < 1e-9);
}

void TestSafetyLimits::axisCapsFollowThePose() {
    // A 0.2 m arm with 0.3 N·m: 1.5 N across it, and 4 N along it, wherever it points.
    auto device = sixAxisDevice(0.3, 0.0);
    const test::ArmKinematics arm;
    SafetyRig rig(device, {}, {}, &arm);
    rig.arm();
    rig.ask(Vec3(0, 4, 0));
    rig.ticks(10);
    QVERIFY((rig.force() - Vec3(0, 1.5, 0)).norm() < 1e-9);
    rig.samples[0].counts[0] = 1'570'796; // a quarter turn: y is now along the arm
    rig.ticks(10);
    QVERIFY((rig.force() - Vec3(0, 4, 0)).norm() < 1e-9);
    rig.samples[0].counts[0] = 0; // and back at once: the cap of this pose holds in this tick
    rig.tick();
    QVERIFY(0.2 * rig.force().y() <= 0.3);
}

void TestSafetyLimits::capsHoldWhereTheSlewKeepsPartOfTheLastForce() {
    auto device = sixAxisDevice(0.3, 0.0);
    haptics::SafetySettings settings;
    settings.slewForce_N_per_ms = 0.1;
    const test::ArmKinematics arm;
    SafetyRig rig(device, settings, {}, &arm);
    rig.arm();
    rig.samples[0].counts[0] = 785'398; // the arm points along x = y: so may 4 N
    rig.ask(Vec3(2.8, 2.8, 0));
    rig.ticks(100);
    QVERIFY(rig.force().norm() > 3.9);
    rig.samples[0].counts[0] = 0; // now it lies along x, where y may have 1.5 N; x alone is asked for
    rig.ask(Vec3(4, 0, 0));
    rig.tick();
    QVERIFY(rig.out.guards & guard_bits::kSlew); // 2 N of the old y are still there before the last caps
    QVERIFY(0.2 * rig.force().y() <= 0.3);
    QVERIFY(rig.force().y() > 1.4);
}

/// Where the kinematics gives an effort that is not finite, on any axis, no force or torque is rendered at
/// all.
void TestSafetyLimits::aKinematicsWithoutAnAnswerGivesNoForce() {
    class Unanswered : public test::CartesianKinematics {
    public:
        Unanswered(double value, std::size_t axis) : m_value(value), m_axis(axis) {}
        devices::AxisValues efforts(const core::DeviceSample& sample,
                                    const core::Wrench& w) const noexcept override {
            auto all = CartesianKinematics::efforts(sample, w);
            if (sample.counts[0] > 500)
                all[m_axis] = m_value;
            return all;
        }

    private:
        double m_value;
        std::size_t m_axis;
    };
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), kInfinite, -kInfinite}) {
        for (const std::size_t axis : {std::size_t{0}, std::size_t{5}}) {
            const Unanswered kinematics(value, axis);
            SafetyRig rig(sixAxisDevice(), {}, {}, &kinematics);
            rig.arm();
            rig.ask(Vec3(1, 0.5, 0));
            rig.ticks(100);
            QVERIFY((rig.force() - Vec3(1, 0.5, 0)).norm() < 1e-9);
            rig.samples[0].counts[0] = 501;
            rig.tick();
            QCOMPARE(rig.force(), Vec3(0, 0, 0));
            QCOMPARE(rig.out.tools[0].wrench_W.torque, Vec3(0, 0, 0));
        }
    }
}

void TestSafetyLimits::passiveAxesAreLeftOut() {
    auto device = sixAxisDevice();
    device.axes[2].continuousRating = 0.0; // measured, not driven
    SafetyRig rig(device);
    rig.arm();
    rig.ask(Vec3(1, 0, 1));
    rig.ticks(10);
    QCOMPARE(rig.force(), Vec3(1, 0, 1));
}

void TestSafetyLimits::devicesWithoutTorqueKeepTheirForce() {
    auto device = sixAxisDevice();
    device.maximumTorque_Nm = 0.0;
    SafetyRig rig(device);
    rig.arm();
    rig.ask(Vec3(1, 0, 0), Vec3(0, 0.1, 0));
    rig.ticks(10);
    QCOMPARE(rig.force(), Vec3(1, 0, 0));
    QCOMPARE(rig.out.tools[0].wrench_W.torque, Vec3(0, 0, 0));
}

void TestSafetyLimits::hugeRequestsKeepTheirDirection() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(3e307, 4e307, 0));
    rig.ticks(10);
    QVERIFY((rig.force() - Vec3(2.4, 3.2, 0)).norm() < 1e-9);
}

void TestSafetyLimits::leftHandedWorkspaceMirrorsForceAndTorque() {
    devices::WorkspaceMapping mapping;
    mapping.leftHanded = true;
    mapping.scale = 3.0; // does not change forces
    SafetyRig rig(sixAxisDevice(), {}, mapping);
    rig.arm();
    rig.ask(Vec3(1, 2, 3), Vec3(0.01, 0.02, 0.03));
    rig.ticks(10);
    QCOMPARE(rig.out.tools[0].wrench_D.force, Vec3(-1, 2, 3));
    QCOMPARE(rig.out.tools[0].wrench_D.torque, Vec3(0.01, -0.02, -0.03)); // axial: det(H)·H
}

void TestSafetyLimits::risesAreSlewedAndDecreasesAreNot() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(3.5, 0, 0));
    rig.tick();
    QCOMPARE(rig.force(), Vec3(2, 0, 0));
    QVERIFY(rig.out.guards & guard_bits::kSlew);
    rig.tick();
    QCOMPARE(rig.force(), Vec3(3.5, 0, 0));
    rig.ask(Vec3(0.25, 0, 0));
    rig.tick();
    QCOMPARE(rig.force(), Vec3(0.25, 0, 0));
    QCOMPARE(rig.out.guards & guard_bits::kSlew, 0u);
    rig.ask(Vec3(2.25, 0, 0)); // exactly 2 N more is allowed
    rig.tick();
    QCOMPARE(rig.force(), Vec3(2.25, 0, 0));
}

void TestSafetyLimits::turnsAreSlewed() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(4, 0, 0));
    rig.ticks(5);
    rig.ask(Vec3(-4, 0, 0)); // the same magnitude: only the direction turns
    rig.tick();
    QVERIFY((rig.force() - Vec3(-2, 0, 0)).norm() < 1e-9);
    rig.tick();
    QVERIFY((rig.force() - Vec3(-4, 0, 0)).norm() < 1e-9);
    rig.ask(Vec3(0, 4, 0));
    rig.tick();
    QVERIFY((rig.force() - Vec3(0, 2, 0)).norm() < 1e-9);
    rig.tick();
    QVERIFY((rig.force() - Vec3(0, 4, 0)).norm() < 1e-9);
    rig.ask(4.0 * Vec3(0.6, 0.8, 0)); // from the 3.2 N of it that may stay 2.4 N are left to turn
    rig.tick();
    const Vec3 kept(0, 3.2, 0);
    QVERIFY((rig.force() - (kept + 2.0 * Vec3(1, 0, 0))).norm() < 1e-9);
}

void TestSafetyLimits::torqueIsSlewed() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3::Zero(), Vec3(0, 0.140, 0));
    rig.tick();
    QVERIFY((rig.out.tools[0].wrench_W.torque - Vec3(0, 0.100, 0)).norm() < 1e-12);
    rig.tick();
    QVERIFY((rig.out.tools[0].wrench_W.torque - Vec3(0, 0.140, 0)).norm() < 1e-12);
    rig.ask(Vec3::Zero(), Vec3(0, -0.140, 0));
    rig.tick();
    QVERIFY((rig.out.tools[0].wrench_W.torque - Vec3(0, -0.100, 0)).norm() < 1e-12);
}

void TestSafetyLimits::slewNeverExceedsTheTarget() {
    core::Random random(20);
    for (int i = 0; i < 100000; ++i) {
        const Vec3 last(random.normal(), random.normal(), random.normal());
        const Vec3 target(random.normal(), random.normal(), random.normal());
        bool limited = false;
        const Vec3 shown = haptics::limitSlew(last, target, 0.3, limited);
        QVERIFY(shown.norm() <= target.norm() * (1.0 + 1e-12));
        // Never farther from the target than before: it converges.
        QVERIFY((shown - target).norm() <= (last - target).norm() * (1.0 + 1e-12));
        QCOMPARE(limited, shown != target);
    }
}

/// A device that measures and cannot push is too fast like any other, and is commanded nothing for it.
void TestSafetyLimits::overVelocityDampsOnlyWhatPushes() {
    auto onlyMeasures = sixAxisDevice(10.0);
    for (auto& axis : onlyMeasures.axes)
        axis.continuousRating = 0.0;
    auto rendersNothing = sixAxisDevice(10.0);
    rendersNothing.rendersForce = false;
    for (const auto& device : {onlyMeasures, rendersNothing}) {
        SafetyRig rig(device);
        rig.arm();
        rig.states.tools[0].v_WT = Vec3(0.6, 0, 0.81);
        rig.ticks(3);
        QCOMPARE(rig.force(), Vec3(0, 0, 0));
        rig.states.tools[0].v_WT = Vec3(0.1, 0, 0);
        rig.ticks(3);
        QCOMPARE(rig.force(), Vec3(0, 0, 0));
    }
}

void TestSafetyLimits::overVelocityIsLatchedAndDampsOnly() {
    SafetyRig rig;
    rig.arm();
    rig.ask(Vec3(0, 0, 1));
    rig.states.tools[0].v_WT = Vec3(1.0, 0, 0); // not above
    rig.tick();
    QCOMPARE(rig.force(), Vec3(0, 0, 1));
    rig.states.tools[0].v_WT = Vec3(0.6, 0, 0.81);
    rig.tick();
    rig.tick();
    QVERIFY(rig.out.guards & guard_bits::kOverVelocity);
    rig.ticks(5);
    const Vec3 damping = -5.0 * Vec3(0.6, 0, 0.81); // 5.04 N, capped at 4 N
    QVERIFY((rig.force() - 4.0 * damping.normalized()).norm() < 1e-9);
    rig.states.tools[0].v_WT = Vec3(0.1, 0, 0);
    rig.tick();
    QVERIFY((rig.force() - Vec3(-0.5, 0, 0)).norm() < 1e-12); // slow again: still damping only
    rig.states.tools[0].v_WT.setZero();
    rig.ticks(1000);
    QCOMPARE(rig.force(), Vec3(0, 0, 0));
    QVERIFY(!rig.out.forceReady);
    rig.ask(Vec3::Zero());
    rig.tick({CommandKind::rearm});
    QCOMPARE(rig.out.force, ForceState::arming);
}

void TestSafetyLimits::overVelocityCountsTheHandsSpeed() {
    devices::WorkspaceMapping mapping;
    mapping.scale = 2.0; // the drawn tool is twice as fast as the hand
    SafetyRig rig(sixAxisDevice(), {}, mapping);
    rig.arm();
    rig.states.tools[0].v_WT = Vec3(1.9, 0, 0);
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::on);
    rig.states.tools[0].v_WT = Vec3(2.1, 0, 0);
    rig.tick();
    QCOMPARE(rig.out.force, ForceState::fault);
}

void TestSafetyLimits::configureRefusesNonsense() {
    QVERIFY(SafetyRig().accepted);
    haptics::SafetySettings settings;
    settings.siteForce_N = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!SafetyRig(sixAxisDevice(), settings).accepted);
    settings = {};
    settings.armingRamp_ms = 0;
    QVERIFY(!SafetyRig(sixAxisDevice(), settings).accepted);
    devices::WorkspaceMapping mapping;
    mapping.scale = 0.0;
    QVERIFY(!SafetyRig(sixAxisDevice(), {}, mapping).accepted);
    auto device = sixAxisDevice();
    device.period_us = 0;
    QVERIFY(!SafetyRig(device).accepted);
    device = sixAxisDevice();
    device.oldestSample_us = 8000; // energy is balanced for samples as old as this
    QVERIFY(SafetyRig(device).accepted);
    device.oldestSample_us = 8001;
    QVERIFY(!SafetyRig(device).accepted);
    device.rendersForce = false;
    QVERIFY(SafetyRig(device).accepted);
    device = sixAxisDevice();
    device.axes.clear();
    QVERIFY(!SafetyRig(device).accepted);
    device = sixAxisDevice();
    device.axes[3].continuousRating = -1.0;
    QVERIFY(!SafetyRig(device).accepted);
    QVERIFY(!SafetyRig(std::vector<devices::DeviceDescriptor>(5, sixAxisDevice()), {}).accepted);
    QVERIFY(!SafetyRig(std::vector<devices::DeviceDescriptor>{}, {}).accepted);
}

QTEST_APPLESS_MAIN(TestSafetyLimits)
#include "test_safety_limits.moc"
