// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "devices/drivers/simulated/simulated_second_finger.h"
#include "devices/kinematics_catalogue.h"
#include "mechanisms/rotation_vector.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <vector>

using namespace chiron;
using core::Vec3;
using devices::ForceCommand;
using devices::SimulatedFingertipDevice;
using devices::SimulatedSecondFinger;

namespace {

/// Stays, then turns and moves away; remembers what it perceived.
class Wanderer final : public mechanisms::HandStrategy {
public:
    explicit Wanderer(mechanisms::HandPerception& seen) : m_seen(seen) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        m_seen = seen;
        mechanisms::HandIntention wanted;
        const double t = seen.time_s;
        wanted.p_DDesired = Vec3(0.02 * std::sin(3.0 * t), 0.01 * std::sin(2.0 * t), 0.05);
        wanted.q_DDesired =
            mechanisms::turned(core::Quat::Identity(), Vec3(0.3 * std::sin(t), 0.0, 0.2 * std::sin(2.0 * t)));
        wanted.jaw_rad = 0.5;
        wanted.buttons = t > 0.5 ? core::kButtonMark : 0u;
        return wanted;
    }

private:
    mechanisms::HandPerception& m_seen;
};

struct Rig {
    mechanisms::HandPerception seen, seenBySecond;
    std::unique_ptr<SimulatedFingertipDevice> first;
    std::unique_ptr<SimulatedSecondFinger> second;
    realtime::TickSource ticks;
    core::DeviceSample sample, sampleOfSecond;

    explicit Rig(SimulatedFingertipDevice::Configuration c = {}) {
        first = std::move(SimulatedFingertipDevice::create(c, std::make_unique<Wanderer>(seen)).value());
        second = std::move(SimulatedSecondFinger::create(*first, {0.018, 0.0, 0.0}, 9,
                                                         std::make_unique<Wanderer>(seenBySecond))
                               .value());
        if (!first->open() || !second->open())
            qFatal("open");
    }
    void tick(const ForceCommand& a, const ForceCommand& b) {
        const auto now = ticks.next(0);
        sample = first->read(now);
        sampleOfSecond = second->read(now);
        first->command(now, a);
        second->command(now, b);
    }
};

ForceCommand shown(double force_N, double pitch_rad = 0.0, double roll_rad = 0.0) {
    ForceCommand c;
    c.enabled = true;
    c.display = {force_N, pitch_rad, roll_rad};
    return c;
}

} // namespace

class TestSimulatedFingertip : public QObject {
    Q_OBJECT
private slots:
    void whatItSaysOfItself();
    void kinematicsAreMadeAgainFromTheDescriptor();
    void descriptorsThatDoNotFitAreRefused();
    void sessionsOfTheSlidingArmKeepTheirPose();
    void velocityIsTheDerivativeOfThePose();
    void theWrenchNeverPushesTheHand();
    void thePadIsPerceivedAndMeasured();
    void twoFingersShareOneArm();
    void sameSeedSameBits();
    void reopenedItDoesTheSameAgain();
    void badConfigurationsAreRefused();
};

void TestSimulatedFingertip::whatItSaysOfItself() {
    const Rig rig;
    const devices::DeviceDescriptor& d = rig.first->descriptor();
    const QStringList ids{"yaw",     "shoulder", "elbow",          "wrist_x",
                          "wrist_y", "wrist_z",  "platform_pitch", "platform_roll"};
    QCOMPARE(d.axes.size(), std::size_t(8));
    for (std::size_t i = 0; i < 8; ++i) {
        QCOMPARE(QString::fromStdString(d.axes[i].id), ids[static_cast<int>(i)]);
        QCOMPARE(d.axes[i].continuousRating, 0.0); // no motor
        QVERIFY(d.axes[i].unit == devices::AxisUnit::radian);
    }
    QVERIFY(d.rendersForce && d.measuresForce && d.inProcess);
    QCOMPARE(d.maximumForce_N, 4.0);
    QCOMPARE(d.maximumTorque_Nm, 0.0);
    QVERIFY(d.jawResolution_rad > 0.0);
}

void TestSimulatedFingertip::kinematicsAreMadeAgainFromTheDescriptor() {
    Rig rig;
    for (int n = 0; n < 700; ++n)
        rig.tick(shown(1.0), shown(1.0));
    for (const bool second : {false, true}) {
        const devices::IDevice& device =
            second ? static_cast<const devices::IDevice&>(*rig.second) : *rig.first;
        const core::DeviceSample& sample = second ? rig.sampleOfSecond : rig.sample;
        const auto again = devices::makeKinematics(device.descriptor());
        QVERIFY(again.has_value());
        const core::ToolState a = device.kinematics().pose(sample), b = (*again)->pose(sample);
        QVERIFY((a.p_WT - b.p_WT).norm() == 0.0 && a.q_WT.coeffs() == b.q_WT.coeffs() &&
                a.jaw_rad == b.jaw_rad);
        QVERIFY(a.jaw_rad > 0.4 && std::abs(a.q_WT.norm() - 1.0) < 1e-12);
    }
}

void TestSimulatedFingertip::descriptorsThatDoNotFitAreRefused() {
    const Rig rig;
    const auto refused = [&](auto change) {
        devices::DeviceDescriptor d = rig.first->descriptor();
        change(d);
        const auto made = devices::makeKinematics(d);
        return !made && made.error().code == core::ErrorCode::badInput;
    };
    QVERIFY(refused([](auto& d) { d.axes.pop_back(); }));
    QVERIFY(refused([](auto& d) { d.axes[4].resolution = 0.0; }));
    QVERIFY(refused([](auto& d) { d.axes[2].unit = devices::AxisUnit::metre; }));
    QVERIFY(refused([](auto& d) { d.kinematicsParameters = {0.0}; }));
    QVERIFY(refused([](auto& d) { d.kinematicsParameters[1] = std::nan(""); }));
    QVERIFY(refused([](auto& d) { d.kinematicsParameters[7] = 0.0; })); // a forearm without length
}

/// As sessions of models id 1 and 2 have stored it: three sliding axes under the same id.
void TestSimulatedFingertip::sessionsOfTheSlidingArmKeepTheirPose() {
    devices::DeviceDescriptor d = Rig().first->descriptor();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        d.axes[axis] = {std::string(1, "xyz"[axis]), devices::AxisUnit::metre, 7.6699e-6, -0.15, 0.2, 0.0};
        d.axes[axis + 3].resolution = 1.0908307824964559e-3;
    }
    d.kinematicsParameters = {0.018, 0.0, 0.0};
    const auto made = devices::makeKinematics(d);
    QVERIFY(made.has_value());
    core::DeviceSample at;
    at.counts = {1000, -2000, 3000, 0, 0, 500, 40, -30};
    const core::ToolState tool = (*made)->pose(at);
    const double angle = 500 * 1.0908307824964559e-3;
    QVERIFY((tool.p_WT -
             Vec3(7.6699e-3 + 0.018 * std::cos(angle), -15.3398e-3 + 0.018 * std::sin(angle), 23.0097e-3))
                .norm() < 1e-12);
    devices::AxisValues rate{};
    rate[0] = 1000.0;
    rate[5] = 100.0;
    Vec3 v, w;
    (*made)->velocity(at, rate, v, w);
    const double spin = 0.10908307824964559;
    QVERIFY((w - Vec3(0.0, 0.0, spin)).norm() < 1e-12);
    QVERIFY(
        (v - Vec3(7.6699e-3 - 0.018 * spin * std::sin(angle), 0.018 * spin * std::cos(angle), 0.0)).norm() <
        1e-12);
    d.kinematicsParameters.push_back(0.0);
    QVERIFY(!devices::makeKinematics(d));
}

// Central difference over fractional counts is not possible, so steps of many counts; the pose is smooth.
void TestSimulatedFingertip::velocityIsTheDerivativeOfThePose() {
    const Rig rig;
    core::DeviceSample at;
    at.counts = {1000, -2000, 3000, 300, -200, 150, 40, -30};
    const auto& kinematics = rig.second->kinematics();
    for (std::size_t axis = 0; axis < 8; ++axis) {
        core::DeviceSample before = at, after = at;
        before.counts[axis] -= 1;
        after.counts[axis] += 1;
        devices::AxisValues rate{};
        rate[axis] = 1.0;
        Vec3 v, w;
        kinematics.velocity(at, rate, v, w);
        const core::ToolState a = kinematics.pose(before), b = kinematics.pose(after);
        QVERIFY((v - 0.5 * (b.p_WT - a.p_WT)).norm() < 1e-10);
        QVERIFY((w - 0.5 * mechanisms::rotationVectorOf(b.q_WT * a.q_WT.conjugate())).norm() < 1e-8);
    }
}

void TestSimulatedFingertip::theWrenchNeverPushesTheHand() {
    Rig quiet, pushed;
    ForceCommand with = shown(2.0, 0.2, 0.1);
    with.wrench_D.force = Vec3(3.0, 2.0, 1.0);
    for (int n = 0; n < 500; ++n) {
        quiet.tick(shown(0.0), shown(0.0));
        pushed.tick(with, with);
    }
    QVERIFY(quiet.first->hand().p_D() == pushed.first->hand().p_D());
    QVERIFY(quiet.first->arm().motion().p_DT == pushed.first->arm().motion().p_DT);
}

void TestSimulatedFingertip::thePadIsPerceivedAndMeasured() {
    Rig rig;
    for (int n = 0; n < 2000; ++n)
        rig.tick(shown(1.5, 0.2, -0.1), shown(0.0));
    QVERIFY(rig.seen.fingertip && rig.seenBySecond.fingertip);
    const core::DisplayPose pad = rig.first->platform().truth();
    QVERIFY2(std::abs(pad.normalForce_N - 1.5) < 0.15, qPrintable(QString::number(pad.normalForce_N)));
    QVERIFY(std::abs(pad.pitch_rad - 0.2) < 0.03 && std::abs(pad.roll_rad + 0.1) < 0.03);
    QVERIFY(std::abs(rig.seen.pad.normalForce_N - pad.normalForce_N) < 0.1);
    QVERIFY(rig.second->platform().truth().normalForce_N < 0.05); // each finger its own
    QVERIFY((rig.sample.status & core::sample_status::kMeasuredForce) != 0);
    const Vec3 measured(rig.sample.measured[0], rig.sample.measured[1], rig.sample.measured[2]);
    QVERIFY2(std::abs(measured.norm() - 1.5) < 0.15, qPrintable(QString::number(measured.norm())));
    const Vec3 normal = rig.first->kinematics().pose(rig.sample).q_WT * Vec3::UnitZ();
    QVERIFY(measured.normalized().dot(normal) > 1.0 - 1e-12);
    const double pitch = rig.sample.counts[6] * rig.first->descriptor().axes[6].resolution;
    QVERIFY2(std::abs(pitch - pad.pitch_rad) < 0.05, qPrintable(QString::number(pitch)));
}

void TestSimulatedFingertip::twoFingersShareOneArm() {
    Rig rig;
    for (int n = 0; n < 900; ++n) {
        rig.tick(shown(0.5), shown(0.5));
        for (std::size_t axis = 0; axis < 6; ++axis)
            QCOMPARE(rig.sample.counts[axis], rig.sampleOfSecond.counts[axis]);
    }
    const core::ToolState a = rig.first->kinematics().pose(rig.sample);
    const core::ToolState b = rig.second->kinematics().pose(rig.sampleOfSecond);
    QVERIFY((b.p_WT - a.p_WT - a.q_WT * Vec3(0.018, 0.0, 0.0)).norm() < 1e-12);
    QVERIFY((rig.seenBySecond.p_DT - rig.seen.p_DT).norm() > 0.0175);
    QVERIFY((rig.sampleOfSecond.buttons & core::kButtonMark) != 0); // its own buttons
}

void TestSimulatedFingertip::sameSeedSameBits() {
    SimulatedFingertipDevice::Configuration other;
    other.seed = 2;
    Rig a, b, c(other);
    bool differs = false;
    for (int n = 0; n < 1500; ++n) {
        const ForceCommand command = shown(1.0 + 0.5 * std::sin(0.01 * n), 0.1, 0.0);
        a.tick(command, command);
        b.tick(command, command);
        c.tick(command, command);
        QVERIFY(a.sample.counts == b.sample.counts && a.sample.measured == b.sample.measured);
        QVERIFY(a.sampleOfSecond.counts == b.sampleOfSecond.counts);
        differs = differs || a.sample.counts != c.sample.counts;
    }
    QVERIFY(differs);
}

/// Arm, platforms, sensors and tremor begin anew, of the second finger too.
void TestSimulatedFingertip::reopenedItDoesTheSameAgain() {
    Rig rig;
    const auto run = [&rig] {
        std::vector<std::array<std::int32_t, core::kMaxCoordinates>> counts;
        rig.ticks = {};
        for (int n = 0; n < 600; ++n) {
            rig.tick(shown(1.0, 0.1, 0.0), shown(0.5));
            counts.push_back(rig.sample.counts);
            counts.push_back(rig.sampleOfSecond.counts);
        }
        return counts;
    };
    const auto once = run();
    rig.first->close();
    rig.second->close();
    QVERIFY(rig.first->open() && rig.second->open());
    QVERIFY(run() == once);
    QVERIFY(once.back() != once[1]);
}

void TestSimulatedFingertip::badConfigurationsAreRefused() {
    SimulatedFingertipDevice::Configuration c;
    mechanisms::HandPerception seen;
    QVERIFY(!SimulatedFingertipDevice::create(c, nullptr));
    c.start_D.x() = 1.0;
    QVERIFY(!SimulatedFingertipDevice::create(c, std::make_unique<Wanderer>(seen)));
    c.start_D.x() = std::nan("");
    QVERIFY(!SimulatedFingertipDevice::create(c, std::make_unique<Wanderer>(seen)));
    const Rig rig;
    QVERIFY(!SimulatedSecondFinger::create(*rig.first, {0.5, 0.0, 0.0}, 1, std::make_unique<Wanderer>(seen)));
    QVERIFY(!SimulatedSecondFinger::create(*rig.first, {0.018, 0.0, 0.0}, 1, nullptr));
}

QTEST_APPLESS_MAIN(TestSimulatedFingertip)
#include "test_simulated_fingertip.moc"
