// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "devices/kinematics_catalogue.h"
#include "mechanisms/rotation_vector.h"

#include <QtTest>
#include <cmath>
#include <vector>

using namespace chiron;
using core::Vec3;
using devices::SimulatedEndoscopeDevice;
using mechanisms::SphericalJoint;

namespace {

/// A hand that goes to a place and a pose in two seconds and remembers what it felt.
class Goer final : public mechanisms::HandStrategy {
public:
    explicit Goer(mechanisms::HandPerception* felt = nullptr) : m_felt(felt) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        if (m_felt != nullptr)
            *m_felt = seen;
        const double share = std::min(1.0, seen.time_s / 2.0);
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = Vec3(0.0, -0.069 + 0.06 * share, 0.03 * share);
        wanted.q_DDesired = SphericalJoint({0.6 * share, 0.1 * share, 0.4 * share}).orientation_DT();
        return wanted;
    }

private:
    mechanisms::HandPerception* m_felt;
};

std::unique_ptr<SimulatedEndoscopeDevice>
make(mechanisms::HandPerception* felt = nullptr,
     const SimulatedEndoscopeDevice::Configuration& configuration = {}) {
    auto device = SimulatedEndoscopeDevice::create(configuration, std::make_unique<Goer>(felt));
    return device ? std::move(*device) : nullptr;
}

} // namespace

class TestSimulatedEndoscope : public QObject {
    Q_OBJECT
private slots:
    void beginsBeforeTheEntranceLookingIn() {
        auto device = make();
        QVERIFY(device && device->open());
        realtime::TickSource source;
        const core::ToolState tool = device->kinematics().pose(device->read(source.next(0)));
        QVERIFY((tool.p_WT - Vec3(0.0, -0.069, 0.0)).norm() < 25e-6);
        QVERIFY((tool.q_WT * -Vec3::UnitZ() - Vec3::UnitY()).norm() < 2e-4);
        QVERIFY(tool.p_WT.x() == 0.0);
    }

    void followsItsHandInPlaceAndTurn() {
        mechanisms::HandPerception felt;
        auto device = make(&felt);
        QVERIFY(device->open().has_value());
        realtime::TickSource source;
        devices::ForceCommand command;
        command.enabled = true;
        for (int n = 0; n < 4000; ++n) {
            const auto now = source.next(0);
            const auto sample = device->read(now);
            const core::ToolState tool = device->kinematics().pose(sample);
            const auto truth = device->plant().motion();
            // The host sees the motors: off by the grid and by what the tendons stretch.
            QVERIFY((tool.p_WT - truth.p_DT).norm() < 250e-6);
            QVERIFY(tool.q_WT.angularDistance(truth.q_DT) < 8e-3);
            device->command(now, command);
        }
        const auto truth = device->plant().motion();
        QVERIFY((truth.p_DT - Vec3(0.0, -0.009, 0.03)).norm() < 1.5e-3);
        QVERIFY(truth.q_DT.angularDistance(SphericalJoint({0.6, 0.1, 0.4}).orientation_DT()) < 0.02);
        QVERIFY(felt.q_DT.angularDistance(truth.q_DT) < 0.02 && felt.t_T_D.norm() < 0.05);
    }

    void isSteppedByTickNotByClock() {
        auto a = make(), b = make();
        QVERIFY(a->open() && b->open());
        realtime::TickSource clockA, clockB;
        for (int n = 0; n < 1500; ++n) {
            const auto nowA = clockA.next(0);
            const auto nowB = clockB.next(static_cast<std::int64_t>(n) * 1'000'000 + (n % 7) * 333'333);
            const auto sampleA = a->read(nowA), sampleB = b->read(nowB);
            QVERIFY(sampleA.counts == sampleB.counts && sampleA.measured == sampleB.measured);
            devices::ForceCommand command;
            command.enabled = true;
            command.wrench_D = {Vec3(0.0, 0.5 * std::sin(0.01 * n), 0.3),
                                Vec3(0.02, 0.01 * std::sin(0.02 * n), 0.001)};
            a->command(nowA, command);
            b->command(nowB, command);
        }
    }

    void reopenedItDoesTheSameAgain() {
        auto device = make();
        const auto run = [&device] {
            std::vector<core::Vec3> wrist;
            realtime::TickSource source;
            for (int n = 0; n < 300; ++n) {
                device->command(source.next(0), {});
                wrist.push_back(device->wrist().w_D());
            }
            return wrist;
        };
        QVERIFY(device->open().has_value());
        const std::vector<core::Vec3> once = run();
        device->close();
        QVERIFY(device->open().has_value());
        QVERIFY(run() == once);
        QVERIFY(once.back().norm() > 0.0);
    }

    /// Force and torque reach the hand, and `measured` says what the motors gave, torque included, in W.
    void wrenchReachesTheHandAndIsMeasured() {
        for (const bool leftHanded : {false, true}) {
            mechanisms::HandPerception felt;
            SimulatedEndoscopeDevice::Configuration configuration;
            configuration.mapping.leftHanded = leftHanded;
            configuration.hand.tremorRms_m = 0.0;
            configuration.hand.wristTremorRms_rad = 0.0;
            auto device = make(&felt, configuration);
            QVERIFY(device->open().has_value());
            realtime::TickSource source;
            devices::ForceCommand command;
            command.enabled = true;
            for (int n = 0; n < 4000; ++n) {
                const auto now = source.next(0);
                device->read(now);
                const Vec3 along = device->plant().dynamics().joint().view_D();
                const Vec3 yawAxis = device->plant().dynamics().joint().yawAxis_D();
                command.wrench_D = {Vec3(0.0, 1.0, -0.8),
                                    0.08 * Vec3::UnitX() + 0.05 * yawAxis + 0.004 * along};
                device->command(now, command);
            }
            const auto sample = device->read(source.next(0));
            const core::Wrench measured = core::toWrench(sample.measured);
            const core::Wrench expected =
                devices::WorkspaceMap(configuration.mapping).wrenchToW(command.wrench_D);
            QVERIFY2((measured.force - expected.force).norm() < 0.02,
                     qPrintable(QString::number((measured.force - expected.force).norm())));
            QVERIFY2((measured.torque - expected.torque).norm() < 2e-3,
                     qPrintable(QString::number((measured.torque - expected.torque).norm())));
            // The hand feels it, less what friction holds (0.1 N; 3, 3 and 0.3 mN·m) and weight that is not
            // carried.
            QVERIFY2((felt.f_T_D - command.wrench_D.force).norm() < 0.25,
                     qPrintable(QString::number((felt.f_T_D - command.wrench_D.force).norm())));
            QVERIFY2((felt.t_T_D - command.wrench_D.torque).norm() < 0.012,
                     qPrintable(QString::number((felt.t_T_D - command.wrench_D.torque).norm())));
            // And is turned by it: 80 mN·m at 2 N·m/rad.
            const auto turned = SphericalJoint::anglesOf(device->wrist().q_D());
            QVERIFY2(std::abs(turned.pitch - 0.6 - 0.04) < 0.01, qPrintable(QString::number(turned.pitch)));
        }
    }

    void descriptorHoldsP1sLimits() {
        const auto device = make();
        const auto& d = device->descriptor();
        QCOMPARE(d.kinematics, std::string("five_bar_spherical"));
        QCOMPARE(d.axes.size(), std::size_t{5});
        QVERIFY(d.maximumForce_N == 4.5 && d.maximumTorque_Nm == 0.150 && d.rendersForce && d.measuresForce);
        QVERIFY(d.axes[2].continuousRating == 0.150 && d.axes[3].continuousRating == 0.150);
        QVERIFY(d.axes[4].continuousRating == 0.010); // what the supervisor's cap of the roll axis holds
        QVERIFY(std::abs(d.axes[4].maximum - 3.141592653589793) < 1e-12);
        QVERIFY(std::abs(d.axes[3].maximum - 0.5235987755982988) < 1e-12);
        // 30° to either side of the centre-line, wherever on it: from 0° at the entrance to 66.2° at the
        // bladder neck.
        const double mounting = d.kinematicsParameters[5];
        QVERIFY(mounting + d.axes[2].minimum <= -0.5235 + 2e-3);
        QVERIFY(mounting + d.axes[2].maximum >= std::atan(2.0 * 13.0 * 0.0877) + 0.5235 - 2e-3);
    }

    /// The same kinematics again from what is stored, as a replay makes it; and nonsense refused.
    void catalogueMakesItsKinematics() {
        auto device = make();
        const auto again = devices::makeKinematics(device->descriptor());
        QVERIFY(again.has_value());
        QVERIFY(device->open().has_value());
        realtime::TickSource source;
        const auto sample = device->read(source.next(0));
        QVERIFY((*again)->pose(sample).p_WT == device->kinematics().pose(sample).p_WT);
        QVERIFY((*again)->pose(sample).q_WT.coeffs() == device->kinematics().pose(sample).q_WT.coeffs());
        devices::AxisValues rates{300.0, -200.0, 100.0, 50.0, 70.0};
        Vec3 v, w;
        (*again)->velocity(sample, rates, v, w);
        const core::Wrench wrench{Vec3(0.3, 1.0, -2.0), Vec3(0.01, 0.02, 0.003)};
        const auto tau = (*again)->efforts(sample, wrench);
        double power = 0.0;
        for (std::size_t axis = 0; axis < 5; ++axis)
            power += tau[axis] * rates[axis] * device->descriptor().axes[axis].resolution;
        QVERIFY(std::abs(power - wrench.force.dot(v) - wrench.torque.dot(w)) < 1e-14);
        QVERIFY(v.x() == 0.0 && v.norm() > 1e-3);
        for (int fault = 0; fault < 4; ++fault) {
            auto bad = device->descriptor();
            if (fault == 0)
                bad.axes.pop_back();
            if (fault == 1)
                bad.kinematicsParameters[1] = 0.0;
            if (fault == 2)
                bad.kinematicsParameters.pop_back();
            if (fault == 3)
                bad.axes[3].resolution = std::nan("");
            const auto refused = devices::makeKinematics(bad);
            QVERIFY(!refused && refused.error().code == core::ErrorCode::badInput);
        }
    }

    /// Left-handed: the picture is mirrored, pitch stays, yaw and roll change sign.
    void mirroredWorkspaceMirrorsTheTurn() {
        auto device = make();
        QVERIFY(device->open().has_value());
        core::DeviceSample sample = device->read(realtime::TickSource().next(0));
        sample.counts[2] = 1000;
        sample.counts[3] = 800;
        sample.counts[4] = 1200;
        const devices::WorkspaceMap map({.origin_m = {}, .scale = 1.0, .leftHanded = true});
        const auto straight = SphericalJoint::anglesOf(device->kinematics().pose(sample).q_WT);
        const auto mirrored = SphericalJoint::anglesOf(map.pose(device->kinematics(), sample).q_WT);
        QVERIFY(std::abs(mirrored.pitch - straight.pitch) < 1e-12);
        QVERIFY(std::abs(mirrored.yaw + straight.yaw) < 1e-12 &&
                std::abs(mirrored.roll + straight.roll) < 1e-12);
    }

    void reopeningStartsAfresh() {
        auto device = make();
        realtime::TickSource source;
        QVERIFY(device->open().has_value());
        const auto first = device->read(source.next(0)).counts;
        devices::ForceCommand command;
        command.enabled = true;
        for (int n = 0; n < 800; ++n) {
            const auto now = source.next(0);
            device->read(now);
            device->command(now, command);
        }
        QVERIFY(device->read(source.next(0)).counts != first);
        device->close();
        QVERIFY(device->open().has_value());
        QCOMPARE(device->read(source.next(0)).counts, first);
    }

    /// Each axis alone, by its name, where its travel ends before the start or begins beyond it.
    void theStartHasToBeWithinEveryTravel() {
        const std::vector<devices::AxisDescriptor> axes = make()->descriptor().axes;
        QCOMPARE(axes.size(), std::size_t{5});
        for (std::size_t axis = 0; axis < axes.size(); ++axis)
            for (const bool low : {false, true}) {
                SimulatedEndoscopeDevice::Configuration configuration;
                auto& plant = configuration.plant;
                if (low)
                    plant.maximum[axis] = plant.minimum[axis] + 1e-6;
                else
                    plant.minimum[axis] = plant.maximum[axis] - 1e-6;
                const auto far = SimulatedEndoscopeDevice::create(configuration, std::make_unique<Goer>());
                QVERIFY2(!far, axes[axis].id.c_str());
                QVERIFY2(far.error().message.ends_with("axis " + axes[axis].id), far.error().message.c_str());
            }
    }

    void refusesBadConfigurations() {
        QVERIFY(!SimulatedEndoscopeDevice::create({}, nullptr));
        SimulatedEndoscopeDevice::Configuration configuration;
        configuration.start_D = Vec3(0.0, 0.0, 0.6);
        QVERIFY(make(nullptr, configuration) == nullptr); // out of reach
        configuration = {};
        configuration.startAngles.yaw = 0.8;
        const auto far = SimulatedEndoscopeDevice::create(configuration, std::make_unique<Goer>());
        QVERIFY(!far && far.error().message.find("yaw") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestSimulatedEndoscope)
#include "test_simulated_endoscope.moc"
