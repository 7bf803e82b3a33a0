// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "devices/drivers/endoscope_pointer/endoscope_pointer_device.h"
#include "devices/kinematics_catalogue.h"
#include "mechanisms/rotation_vector.h"

#include <QtTest>
#include <cmath>
#include <thread>

using namespace chiron;
using core::Vec3;
using devices::EndoscopeMovement;
using devices::EndoscopePointerDevice;
using devices::EndoscopePointerSettings;

namespace {
struct Bench {
    explicit Bench(const EndoscopePointerSettings& settings = {})
        : device(std::move(*EndoscopePointerDevice::create(settings))) {
        (void)device->open();
    }
    core::DeviceSample tick() {
        return device->read(ticks.next(static_cast<std::int64_t>(ticks.executed()) * 1'000'000));
    }
    core::ToolState pose() { return device->kinematics().pose(tick()); }
    void move(const EndoscopeMovement& by) { device->mailbox().move(by); }
    std::unique_ptr<EndoscopePointerDevice> device;
    realtime::TickSource ticks;
};

Vec3 viewOf(const core::ToolState& tool) {
    return tool.q_WT * -Vec3::UnitZ();
}
} // namespace

class TestEndoscopePointer : public QObject {
    Q_OBJECT
private slots:
    void beginsBeforeTheEntranceLookingIn() {
        Bench bench;
        const core::ToolState tool = bench.pose();
        QVERIFY((tool.p_WT - Vec3(0.0, -0.069, 0.0)).norm() < 1e-9);
        QVERIFY((viewOf(tool) - Vec3::UnitY()).norm() < 1e-12);
        QVERIFY((tool.q_WT * Vec3::UnitY() - Vec3::UnitZ()).norm() < 1e-12);
        const auto& d = bench.device->descriptor();
        QVERIFY(!d.rendersForce && d.inProcess && d.deviceClass() == devices::DeviceClass::shown);
        QCOMPARE(d.kinematics, std::string("endoscope_pose"));
    }

    void goesWhereItLooks() {
        Bench bench;
        bench.move({.turnUp_rad = 0.5});
        bench.move({.advance_m = 0.010});
        bench
            .tick(); // one tick: advanced along the old direction, turned; the next goes on along the new one
        bench.move({.advance_m = 0.010});
        const core::ToolState tool = bench.pose();
        QVERIFY((viewOf(tool) - Vec3(0.0, std::cos(0.5), std::sin(0.5))).norm() < 2e-5);
        QVERIFY(
            (tool.p_WT - Vec3(0.0, -0.069 + 0.010 + 0.010 * std::cos(0.5), 0.010 * std::sin(0.5))).norm() <
            3e-6);
    }

    /// Up, right and spin are those of the picture, whichever way the endoscope is rolled.
    void turnsAsThePictureShows() {
        for (const double roll : {0.0, 0.9, -2.0}) {
            EndoscopePointerSettings settings;
            settings.home_rad = {0.6, 0.1, roll};
            Bench bench(settings);
            const core::Quat before = bench.pose().q_WT;
            bench.move({.turnUp_rad = 0.02, .turnRight_rad = 0.01, .spin_rad = 0.03});
            const core::Quat after = bench.pose().q_WT;
            const Vec3 inTool = mechanisms::rotationVectorOf(before.conjugate() * after);
            QVERIFY2((inTool - Vec3(0.02, -0.01, -0.03)).norm() < 6e-4,
                     qPrintable(QString::number((inTool - Vec3(0.02, -0.01, -0.03)).norm())));
            const Vec3 view = before.conjugate() * viewOf(bench.pose()); // in the old picture: x right, y up
            QVERIFY(view.y() > 0.015 && view.x() > 0.005);
        }
    }

    void shiftsInThePlaneOfThePicture() {
        EndoscopePointerSettings settings;
        settings.home_rad = {0.5, 0.0, 0.0};
        settings.planar = false;
        Bench bench(settings);
        const core::ToolState before = bench.pose();
        bench.move({.right_m = 0.003, .up_m = 0.002});
        const Vec3 moved = bench.pose().p_WT - before.p_WT;
        QVERIFY((before.q_WT.conjugate() * moved - Vec3(0.003, 0.002, 0.0)).norm() < 3e-6);
    }

    /// P1's mechanism cannot leave the plane of symmetry, and neither does the mouse, unless it is told to.
    void staysInThePlaneUnlessFreed() {
        for (const bool planar : {true, false}) {
            EndoscopePointerSettings settings;
            settings.home_rad = {0.0, 0.3, 0.0};
            settings.planar = planar;
            Bench bench(settings);
            bench.move({.advance_m = 0.010, .right_m = 0.001});
            const core::ToolState tool = bench.pose();
            QVERIFY(planar ? tool.p_WT.x() == 0.0 : tool.p_WT.x() < -0.0015);
            QVERIFY(std::abs(viewOf(tool).x() + std::sin(0.3)) <
                    1e-5); // the picture shows the yaw either way
        }
    }

    void resistanceSlowsTheAdvanceOnly() {
        Bench bench;
        bench.tick();
        core::VisibleCues cues;
        cues.shownForce_N = 2.0; // r = 1 − 0.7·½
        bench.device->show(bench.ticks.next(0), cues);
        bench.move({.advance_m = 0.010, .up_m = 0.004, .spin_rad = 0.2});
        const core::DeviceSample s = bench.tick();
        QCOMPARE(s.counts[1], -69'000 + 6'500);
        QCOMPARE(s.counts[2], 4'000);
        QCOMPARE(s.counts[5], 20'000);
    }

    void staysInItsBoxAndTravelAndComesBackAtOnce() {
        Bench bench;
        bench.move({.advance_m = 5.0, .turnUp_rad = 9.0, .spin_rad = -9.0});
        core::DeviceSample s = bench.tick();
        const auto& axes = bench.device->descriptor().axes;
        QCOMPARE(s.counts[1], static_cast<std::int32_t>(std::lround(axes[1].maximum / axes[1].resolution)));
        QCOMPARE(s.counts[3], static_cast<std::int32_t>(std::lround(axes[3].maximum / axes[3].resolution)));
        QCOMPARE(s.counts[5], static_cast<std::int32_t>(std::lround(axes[5].minimum / axes[5].resolution)));
        bench.move({.spin_rad = 0.1});
        QVERIFY(bench.tick().counts[5] > s.counts[5]);
    }

    void keysMoveByTheTickAndClicksShow() {
        Bench bench;
        bench.device->mailbox().setRate({.advance_m = 0.02, .spin_rad = 0.5});
        for (int n = 0; n < 100; ++n)
            bench.tick();
        bench.device->mailbox().setRate({});
        bench.device->mailbox().press(core::kButtonMark);
        bench.device->mailbox().release(core::kButtonMark);
        const core::DeviceSample s = bench.tick();
        QCOMPARE(s.counts[1], -69'000 + 2'000);
        QCOMPARE(s.counts[5], 5'000);
        QCOMPARE(s.buttons, core::kButtonMark);
        QCOMPARE(bench.tick().buttons, 0u);
    }

    void reopeningStartsAfresh() {
        Bench bench;
        bench.move({.advance_m = 0.03});
        bench.tick();
        bench.move({.advance_m = 0.03});
        QVERIFY(bench.device->open().has_value());
        QCOMPARE(bench.tick().counts[1], -69'000);
    }

    void aWindowOnAnotherThreadLosesNothing() {
        Bench bench;
        std::atomic<bool> done{false};
        std::thread window([&] {
            for (int n = 0; n < 20'000; ++n)
                bench.move({.advance_m = 2e-6, .spin_rad = 5e-5});
            done.store(true);
        });
        while (!done.load())
            bench.tick();
        window.join();
        const core::DeviceSample s = bench.tick();
        QCOMPARE(s.counts[1], -69'000 + 40'000);
        QCOMPARE(s.counts[5], 100'000);
    }

    void velocityAndEffortsBelongToThePose() {
        const Bench bench;
        const auto made = devices::makeKinematics(bench.device->descriptor()); // as a replay does
        QVERIFY(made.has_value());
        core::Random random(3);
        for (int n = 0; n < 200; ++n) {
            core::DeviceSample sample;
            sample.counts = {100,
                             -20'000,
                             30'000,
                             static_cast<std::int32_t>(random.uniform(-3e4, 1.5e5)),
                             static_cast<std::int32_t>(random.uniform(-5e4, 5e4)),
                             static_cast<std::int32_t>(random.uniform(-3e5, 3e5))};
            devices::AxisValues rates{};
            core::DeviceSample later = sample;
            for (std::size_t axis = 0; axis < 6; ++axis) {
                rates[axis] = random.uniform(-20.0, 20.0);
                later.counts[axis] += static_cast<std::int32_t>(std::lround(rates[axis]));
                rates[axis] = std::round(rates[axis]) / 1e-3;
            }
            Vec3 v, w;
            (*made)->velocity(sample, rates, v, w);
            const core::ToolState a = (*made)->pose(sample), b = (*made)->pose(later);
            QVERIFY(((b.p_WT - a.p_WT) / 1e-3 - v).norm() < 1e-9);
            QVERIFY((mechanisms::rotationVectorOf(b.q_WT * a.q_WT.conjugate()) / 1e-3 - w).norm() < 1e-3);
            const core::Wrench wrench{Vec3(random.normal(), random.normal(), random.normal()),
                                      Vec3(random.normal(), random.normal(), random.normal())};
            const auto tau = (*made)->efforts(sample, wrench);
            double power = 0.0;
            for (std::size_t axis = 0; axis < 6; ++axis)
                power += tau[axis] * rates[axis] * bench.device->descriptor().axes[axis].resolution;
            QVERIFY(std::abs(power - wrench.force.dot(v) - wrench.torque.dot(w)) < 1e-12);
        }
        auto bad = bench.device->descriptor();
        bad.axes[4].unit = devices::AxisUnit::metre;
        QVERIFY(!devices::makeKinematics(bad));
        bad = bench.device->descriptor();
        bad.axes.pop_back();
        QVERIFY(!devices::makeKinematics(bad));
    }

    void badSettingsAreRefused() {
        EndoscopePointerSettings s;
        s.home_m[2] = 1.0;
        QVERIFY(!EndoscopePointerDevice::create(s));
        s = {};
        s.maximum_rad[1] = 1.5; // the angles' singularity is near
        const auto wide = EndoscopePointerDevice::create(s);
        QVERIFY(!wide && wide.error().message.find("yaw") != std::string::npos);
        s = {};
        s.pseudoHaptics.slowestRatio = 0.0;
        QVERIFY(!EndoscopePointerDevice::create(s));
        s = {};
        s.following_s = std::nan("");
        QVERIFY(!EndoscopePointerDevice::create(s));
    }
};

QTEST_APPLESS_MAIN(TestEndoscopePointer)
#include "test_endoscope_pointer.moc"
