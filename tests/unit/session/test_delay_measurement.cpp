// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/delay_measurement.h"

#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "mechanisms/scripted_motion.h"

#include <QtTest>

#include <cmath>

using namespace chiron;

namespace {

using Configuration = devices::SimulatedDevice::Configuration;

/// A hand that holds the simulated gimbal still, as still as it trembles.
std::unique_ptr<devices::SimulatedDevice> held(const Configuration& configuration,
                                               std::vector<mechanisms::ScriptedMotion::Term> moved = {}) {
    return *devices::SimulatedDevice::create(
        configuration, std::make_unique<mechanisms::ScriptedMotion>(configuration.start_D, std::move(moved)));
}

core::Result<haptics::DelayEstimate> measured(const Configuration& configuration) {
    const auto device = held(configuration);
    return session::measureDelay(*device, configuration.mapping);
}

Configuration late(int ticks, double amplifierLag_s = 0.0003) {
    Configuration configuration;
    configuration.plant.sampleDelay_ticks = ticks;
    configuration.plant.amplifierLag_s = amplifierLag_s;
    return configuration;
}

/// What the simulated plant really has: the age of its counts, the lag of its motors, less half a step of its
/// integration, which moves the tool by the speed at the end of a step.
double truth_s(const Configuration& configuration) {
    return 1e-3 * configuration.plant.sampleDelay_ticks + configuration.plant.amplifierLag_s -
           0.5e-3 / configuration.plant.substeps;
}

/// A device that counts how it is used.
class Watched final : public devices::IDevice {
public:
    explicit Watched(devices::IDevice& device) : m_device(device) {}
    const devices::DeviceDescriptor& descriptor() const noexcept override { return m_device.descriptor(); }
    const devices::IToolKinematics& kinematics() const noexcept override { return m_device.kinematics(); }
    core::Result<void> open() override {
        ++opened;
        return refuses ? core::fail(core::ErrorCode::device, "unplugged") : m_device.open();
    }
    void close() noexcept override {
        ++closed;
        m_device.close();
    }
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override {
        core::DeviceSample sample = m_device.read(now);
        if (now.index() >= faultsAt)
            sample.status |= core::sample_status::kInvalid;
        return sample;
    }
    void command(const realtime::HapticTick& now, const devices::ForceCommand& command) noexcept override {
        largest_N = std::max(largest_N, command.wrench_D.force.norm());
        m_device.command(now, command);
    }
    int opened = 0, closed = 0;
    bool refuses = false;
    std::uint64_t faultsAt = std::numeric_limits<std::uint64_t>::max();
    double largest_N = 0.0;

private:
    devices::IDevice& m_device;
};

} // namespace

class TestDelayMeasurement : public QObject {
    Q_OBJECT
private slots:
    /// What the plant was given is what is found: samples that are so old, and motors that lag.
    void delayOfThePlantIsFound_data() {
        QTest::addColumn<int>("ticks");
        for (const int ticks : {0, 1, 2, 3})
            QTest::addRow("%d ticks", ticks) << ticks;
    }
    void delayOfThePlantIsFound() {
        QFETCH(int, ticks);
        const auto found = measured(late(ticks));
        QVERIFY2(found, found ? "" : found.error().message.c_str());
        QVERIFY2(std::abs(found->delay_s - truth_s(late(ticks))) < 0.0001,
                 qPrintable(QString::number(found->delay_s)));
        QVERIFY(found->standardError_s > 0.0 && found->standardError_s < 0.0001);
        QVERIFY2(std::abs(found->mass_kg - 0.15) < 0.01,
                 qPrintable(QString::number(found->mass_kg))); // instrument and depth axis
    }
    void whateverHandHoldsIt_data() {
        QTest::addColumn<double>("kg");
        QTest::addColumn<double>("Ns_per_m");
        QTest::addColumn<double>("N_per_m");
        QTest::newRow("default") << 0.3 << 6.0 << 300.0;
        QTest::newRow("light") << 0.1 << 2.0 << 100.0;
        QTest::newRow("firm") << 1.0 << 20.0 << 800.0;
    }
    void whateverHandHoldsIt() {
        QFETCH(double, kg);
        QFETCH(double, Ns_per_m);
        QFETCH(double, N_per_m);
        for (const std::uint64_t seed : {1, 2, 3}) {
            Configuration configuration = late(2);
            configuration.hand.mass_kg = kg;
            configuration.hand.damping_Ns_per_m = Ns_per_m;
            configuration.hand.stiffness_N_per_m = N_per_m;
            configuration.seed = seed;
            const auto found = measured(configuration);
            QVERIFY2(found, found ? "" : found.error().message.c_str());
            QVERIFY2(std::abs(found->delay_s - truth_s(configuration)) < 0.0001,
                     qPrintable(QString::number(found->delay_s)));
        }
    }
    /// A slow motor is not wholly told from the mass it moves: most of its lag counts, and never more than it
    /// is.
    void mostOfALagCounts() {
        const auto found = measured(late(0, 0.001));
        QVERIFY(found);
        QVERIFY2(found->delay_s > 0.0006 && found->delay_s < 0.001,
                 qPrintable(QString::number(found->delay_s)));
    }
    void sameSeedSameNumber() { QCOMPARE(measured(late(1))->delay_s, measured(late(1))->delay_s); }
    void forceStaysGentle() {
        const auto device = held(late(1));
        Watched watched(*device);
        QVERIFY(session::measureDelay(watched, {}));
        QVERIFY(watched.largest_N > 0.5);
        QVERIFY2(watched.largest_N < 1.7, qPrintable(QString::number(watched.largest_N)));
        QCOMPARE(watched.opened, 1);
        QCOMPARE(watched.closed, 1);
    }
    /// Half-way: the device goes, or the person no longer wants.
    void whatStopsHalfWayIsNoNumber() {
        const auto device = held(late(1));
        Watched watched(*device);
        watched.faultsAt = 6000;
        auto found = session::measureDelay(watched, {});
        QVERIFY(!found);
        QCOMPARE(found.error().code, core::ErrorCode::doesNotHold);
        QCOMPARE(watched.closed, 1);
        watched.refuses = true;
        found = session::measureDelay(watched, {});
        QCOMPARE(found.error().code, core::ErrorCode::device);
        QCOMPARE(watched.closed, 1); // what was not opened is not closed
        const auto other = held(late(1));
        const std::atomic<bool> cancel{true};
        found = session::measureDelay(*other, {}, {}, &cancel);
        QCOMPARE(found.error().code, core::ErrorCode::cancelled);
    }
    /// A hand that beats about at the sines' own frequencies: no number rather than a wrong one.
    void aRestlessHandIsRefused() {
        Configuration configuration = late(1);
        configuration.hand.tremorRms_m = 0.004;
        configuration.hand.gripStiffness_N_per_m = 20000.0;
        const auto device = held(configuration, {{core::Vec3(0.0, 0.0, 0.02), 3.3, 0.0},
                                                 {core::Vec3(0.0, 0.0, 0.004), 36.5, 0.4},
                                                 {core::Vec3(0.0, 0.0, 0.004), 63.4, 1.0}});
        const auto found = session::measureDelay(*device, configuration.mapping);
        QVERIFY2(!found, found ? qPrintable(QString::number(found->delay_s)) : "");
        QCOMPARE(found.error().code, core::ErrorCode::doesNotHold);
    }
    void whatGivesNoForceHasNoDelay() {
        const auto mouse = *devices::KeyboardMouseDevice::create({});
        const auto found = session::measureDelay(*mouse, {});
        QVERIFY(!found);
        QCOMPARE(found.error().code, core::ErrorCode::wrongUse);
    }
};

QTEST_APPLESS_MAIN(TestDelayMeasurement)
#include "test_delay_measurement.moc"
