// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <thread>

using namespace chiron;
using devices::KeyboardMouseDevice;

namespace {
/// A device, its ticks, and where it was last.
struct Bench {
    explicit Bench(const devices::KeyboardMouseSettings& settings = {})
        : device(std::move(*KeyboardMouseDevice::create(settings))) {
        (void)device->open();
    }
    core::DeviceSample tick() {
        const realtime::HapticTick now = ticks.next(static_cast<std::int64_t>(ticks.executed()) * 1'000'000);
        return device->read(now);
    }
    void showForce(double force_N) {
        core::VisibleCues cues;
        cues.shownForce_N = force_N;
        device->show(ticks.next(0), cues);
    }
    std::unique_ptr<KeyboardMouseDevice> device;
    realtime::TickSource ticks;
};
} // namespace

class TestKeyboardMouse : public QObject {
    Q_OBJECT
private slots:
    void saysThatItShowsAndDoesNotRenderForce() {
        const Bench bench;
        const devices::DeviceDescriptor& d = bench.device->descriptor();
        QVERIFY(!d.rendersForce);
        QVERIFY(d.deviceClass() == devices::DeviceClass::shown);
        QVERIFY(d.inProcess);
        QCOMPARE(d.period_us, 1000u);
        QCOMPARE(d.axes.size(), std::size_t{3});
        QCOMPARE(d.axes[0].resolution, 1e-6);
    }

    /// A jaw moves as fast as it is told and for as long, between closed and its stop; the rest of the tool
    /// stays.
    void aJawOpensAndCloses() {
        Bench bench({.widestJaw_rad = 1.0, .homeJaw_rad = 0.4, .following_s = 0.025});
        QCOMPARE(bench.device->descriptor().jawResolution_rad, KeyboardMouseDevice::kJawGrid_rad);
        const auto jaw = [&bench](int ticks) {
            core::DeviceSample sample;
            for (int n = 0; n < ticks; ++n)
                sample = bench.tick();
            return bench.device->kinematics().pose(sample).jaw_rad;
        };
        const core::DeviceSample start = bench.tick();
        QCOMPARE(bench.device->kinematics().pose(start).jaw_rad, 0.4);
        bench.device->mailbox().setJawRate(-1.0);
        QVERIFY(std::abs(jaw(100) - 0.3) < 1e-9);
        bench.device->mailbox().setJawRate(0.0);
        QVERIFY(std::abs(jaw(100) - 0.3) < 1e-9);        // let go: it stays
        bench.device->mailbox().setRate(0.01, 0.0, 0.0); // and moving the tool is another matter
        bench.device->mailbox().setJawRate(-1.0);
        QCOMPARE(jaw(1000), 0.0);
        bench.device->mailbox().setRate(0.0, 0.0, 0.0);
        QCOMPARE(jaw(10), 0.0);
        bench.device->mailbox().setJawRate(2.0);
        QCOMPARE(jaw(1000), 1.0);
        QVERIFY(bench.tick().counts[0] > start.counts[0] + 9000);
        QVERIFY(bench.tick().counts[1] == start.counts[1] && bench.tick().counts[2] == start.counts[2]);
        QVERIFY(bench.device->open());
        QCOMPARE(bench.device->kinematics().pose(bench.tick()).jaw_rad,
                 0.402); // home again, and opening goes on
    }

    void aToolWithoutAJawHasNone() {
        Bench bench;
        QCOMPARE(bench.device->descriptor().jawResolution_rad, 0.0);
        bench.device->mailbox().setJawRate(1.0);
        for (int n = 0; n < 100; ++n)
            QCOMPARE(bench.tick().jawCounts, 0);
        QVERIFY(!KeyboardMouseDevice::create({.widestJaw_rad = 0.5, .homeJaw_rad = 0.6}));
        QVERIFY(!KeyboardMouseDevice::create({.widestJaw_rad = 1.7}));
        QVERIFY(!KeyboardMouseDevice::create({.homeJaw_rad = -0.1}));
    }

    /// A pointer's jump of 2 mm becomes a movement: never faster than its first tick, nothing lost, nothing
    /// past the goal.
    void aJumpIsFollowed() {
        Bench bench({.following_s = 0.025});
        const std::int32_t start = bench.tick().counts[0];
        bench.device->mailbox().move(0.002, 0.0, 0.0);
        std::int32_t before = start;
        std::int32_t largest = 0;
        for (int n = 0; n < 300; ++n) {
            const std::int32_t now = bench.tick().counts[0];
            QVERIFY(now >= before && now <= start + 2000);
            largest = std::max(largest, now - before);
            before = now;
        }
        QVERIFY(largest <= 80); // 2 mm / 25 ms a tick
        QCOMPARE(before, start + 2000);
        for (const double bad : {-0.001, 0.3, std::nan("")})
            QVERIFY(!KeyboardMouseDevice::create({.following_s = bad}));
    }

    void movementArrivesOnceAndInFull() {
        Bench bench;
        QCOMPARE(bench.tick().counts[2], 60'000);
        bench.device->mailbox().move(0.001, 0.002, 0.0);
        bench.device->mailbox().move(0.001, 0.0, -0.003);
        const core::DeviceSample s = bench.tick();
        QCOMPARE(s.counts[0], 2000);
        QCOMPARE(s.counts[1], 2000);
        QCOMPARE(s.counts[2], 57'000);
        QCOMPARE(bench.tick().counts[0], 2000);
    }

    void movementBelowTheGridAddsUp() {
        Bench bench;
        for (int n = 0; n < 10; ++n) {
            bench.device->mailbox().move(0.25e-6, 0.0, 0.0);
            bench.tick();
        }
        const std::int32_t x = bench.tick().counts[0];
        QVERIFY2(x == 2 || x == 3, qPrintable(QString::number(x))); // 2.5 µm, rounded to the grid
    }

    void keysMoveByTheTick() {
        Bench bench;
        bench.device->mailbox().setRate(0.0, 0.0, -0.05);
        for (int n = 0; n < 100; ++n)
            bench.tick();
        bench.device->mailbox().setRate(0.0, 0.0, 0.0);
        QCOMPARE(bench.tick().counts[2], 55'000); // 0.05 m/s for 100 ticks of 1 ms
        QCOMPARE(bench.tick().counts[2], 55'000);
    }

    void staysInsideItsWorkspaceAndComesBackAtOnce() {
        Bench bench;
        bench.device->mailbox().move(5.0, -5.0, 0.0);
        core::DeviceSample s = bench.tick();
        QCOMPARE(s.counts[0], 80'000);
        QCOMPARE(s.counts[1], -80'000);
        bench.device->mailbox().move(-0.001, 0.001, 0.0);
        s = bench.tick();
        QCOMPARE(s.counts[0], 79'000);
        QCOMPARE(s.counts[1], -79'000);
    }

    void valuesThatAreNoNumbersAreIgnored() {
        Bench bench;
        const double nan = std::nan("");
        const double infinity = std::numeric_limits<double>::infinity();
        bench.device->mailbox().move(nan, 0.0, 0.0);
        bench.device->mailbox().move(0.0, infinity, 0.0);
        bench.device->mailbox().setRate(0.0, 0.0, nan);
        bench.device->mailbox().move(0.001, 0.0, 0.0);
        const core::DeviceSample s = bench.tick();
        QCOMPARE(s.counts[0], 1000);
        QCOMPARE(s.counts[1], 0);
        QCOMPARE(s.counts[2], 60'000);
    }

    void aClickBetweenTwoTicksShowsForOne() {
        Bench bench;
        bench.tick();
        bench.device->mailbox().press(core::kButtonMark);
        bench.device->mailbox().release(core::kButtonMark);
        QCOMPARE(bench.tick().buttons, core::kButtonMark);
        QCOMPARE(bench.tick().buttons, 0u);
        bench.device->mailbox().press(core::kButtonMark);
        QCOMPARE(bench.tick().buttons, core::kButtonMark);
        QCOMPARE(bench.tick().buttons, core::kButtonMark);
        bench.device->mailbox().release(core::kButtonMark);
        QCOMPARE(bench.tick().buttons, 0u);
    }

    void motionSlowsInProportionToTheShownForce_data() {
        QTest::addColumn<double>("force_N");
        QTest::addColumn<int>("counts");
        // r(F) = 1 - 0.7 min(1, F/4): 1, 0.825, 0.65, 0.3, 0.3
        QTest::newRow("none") << 0.0 << 1000;
        QTest::newRow("1 N") << 1.0 << 825;
        QTest::newRow("2 N") << 2.0 << 650;
        QTest::newRow("4 N") << 4.0 << 300;
        QTest::newRow("more") << 400.0 << 300;
    }
    void motionSlowsInProportionToTheShownForce() {
        QFETCH(double, force_N);
        QFETCH(int, counts);
        Bench bench;
        bench.tick();
        bench.showForce(force_N);
        bench.device->mailbox().move(0.001, 0.0, 0.0);
        QCOMPARE(bench.tick().counts[0], counts);
    }

    void aForceThatIsNoNumberSlowsMostAndDoesNotStay() {
        Bench bench;
        bench.tick();
        bench.showForce(std::nan(""));
        bench.device->mailbox().move(0.001, 0.0, 0.0);
        QCOMPARE(bench.tick().counts[0], 300);
        bench.showForce(0.0);
        bench.device->mailbox().move(0.001, 0.0, 0.0);
        QCOMPARE(bench.tick().counts[0], 1300);
    }

    void packetsAndTimeGoOnWithTheTicks() {
        Bench bench;
        const core::DeviceSample first = bench.tick();
        const core::DeviceSample second = bench.tick();
        QCOMPARE(second.packet, first.packet + 1);
        QCOMPARE(second.deviceTime_us, first.deviceTime_us + 1000);
        QCOMPARE(second.arrival_ns, 1'000'000);
    }

    void badSettingsAreRefused() {
        devices::KeyboardMouseSettings s;
        s.home_m[1] = 1.0;
        const auto outside = KeyboardMouseDevice::create(s);
        QVERIFY(!outside);
        QVERIFY(outside.error().message.find('y') != std::string::npos);
        s = {};
        s.maximum_m[0] = 5000.0;
        QVERIFY(!KeyboardMouseDevice::create(s));
        s = {};
        s.pseudoHaptics.slowestRatio = 0.0;
        QVERIFY(!KeyboardMouseDevice::create(s));
        s.pseudoHaptics.slowestRatio = std::nan("");
        QVERIFY(!KeyboardMouseDevice::create(s));
        s = {};
        s.pseudoHaptics.slowestAt_N = 0.0;
        QVERIFY(!KeyboardMouseDevice::create(s));
    }

    void aWindowOnAnotherThreadLosesNothing() {
        Bench bench;
        constexpr int kMoves = 20'000;
        std::atomic<bool> done{false};
        std::thread window([&] {
            for (int n = 0; n < kMoves; ++n)
                bench.device->mailbox().move(1e-6, 0.0, 0.0);
            done.store(true);
        });
        std::int32_t last = 0;
        bool backwards = false;
        while (!done.load()) {
            const std::int32_t x = bench.tick().counts[0];
            backwards = backwards || x < last;
            last = x;
        }
        window.join();
        QCOMPARE(bench.tick().counts[0], kMoves);
        QVERIFY(!backwards);
    }
};

QTEST_APPLESS_MAIN(TestKeyboardMouse)
#include "test_keyboard_mouse.moc"
