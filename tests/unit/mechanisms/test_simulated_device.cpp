// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_device.h"
#include "mechanisms/scripted_motion.h"

#include <QtTest>
#include <cmath>
#include <cstring>
#include <vector>

using namespace chiron;
using core::Vec3;
using devices::SimulatedDevice;

class TestSimulatedDevice : public QObject {
    Q_OBJECT
private slots:
    void followsItsHand();
    void isSteppedByTickNotByClock();
    void reopeningStartsAfresh();
    void cuesReachTheMindInD();
    void measuredIsInW();
    void refusesBadConfigurations();
    void theJawFollowsTheFingers();
    void aJawChangesNothingElse();
};

namespace {

std::unique_ptr<mechanisms::HandStrategy> circling() {
    return std::make_unique<mechanisms::ScriptedMotion>(
        Vec3(0.0, 0.0, 0.03),
        std::vector<mechanisms::ScriptedMotion::Term>{{Vec3(0.02, 0.0, 0.0), 0.4, 0.0},
                                                      {Vec3(0.0, 0.02, 0.0), 0.4, 1.5707963267948966}});
}

std::unique_ptr<SimulatedDevice> make(std::unique_ptr<mechanisms::HandStrategy> mind,
                                      const SimulatedDevice::Configuration& configuration = {}) {
    auto device = SimulatedDevice::create(configuration, std::move(mind));
    return device ? std::move(*device) : nullptr;
}

class Listener final : public mechanisms::HandStrategy {
public:
    explicit Listener(mechanisms::HandPerception& heard) : m_heard(heard) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        m_heard = seen;
        mechanisms::HandIntention stay;
        stay.p_DDesired = Vec3(0.0, 0.0, 0.05);
        return stay;
    }

private:
    mechanisms::HandPerception& m_heard;
};

} // namespace

void TestSimulatedDevice::followsItsHand() {
    auto device = make(circling());
    QVERIFY(device && device->open());
    realtime::TickSource source;
    devices::ForceCommand command;
    command.enabled = true;
    double widest = 0.0;
    for (int i = 0; i < 6000; ++i) {
        const auto now = source.next(0);
        const auto sample = device->read(now);
        QCOMPARE(sample.packet, static_cast<std::uint32_t>(i));
        QCOMPARE(sample.deviceTime_us, static_cast<std::uint64_t>(i) * 1000);
        const Vec3 tip = device->kinematics().pose(sample).p_WT;
        QVERIFY((tip - device->plant().p_DT()).norm() < 60e-6); // the encoders' grid
        if (i > 2000)
            widest = std::max(widest, std::hypot(tip.x(), tip.y()));
        device->command(now, command);
    }
    QVERIFY2(widest > 0.016 && widest < 0.024, qPrintable(QString::number(widest)));
}

void TestSimulatedDevice::isSteppedByTickNotByClock() {
    auto a = make(circling()), b = make(circling());
    QVERIFY(a->open() && b->open());
    realtime::TickSource clockA, clockB;
    for (int i = 0; i < 3000; ++i) {
        const auto nowA = clockA.next(0);
        const auto nowB = clockB.next(static_cast<std::int64_t>(i) * 1'000'000 + (i % 7) * 333'333); // jitter
        auto sampleA = a->read(nowA), sampleB = b->read(nowB);
        sampleB.arrival_ns = sampleA.arrival_ns;
        QVERIFY(std::memcmp(sampleA.counts.data(), sampleB.counts.data(), sizeof(sampleA.counts)) == 0);
        QVERIFY(sampleA.measured == sampleB.measured && sampleA.packet == sampleB.packet);
        devices::ForceCommand command;
        command.enabled = true;
        command.wrench_D.force = Vec3(0.0, 0.0, 0.5 + 0.3 * std::sin(0.01 * i));
        a->command(nowA, command);
        b->command(nowB, command);
    }
}

void TestSimulatedDevice::reopeningStartsAfresh() {
    auto device = make(circling());
    realtime::TickSource source;
    QVERIFY(device->open());
    const auto first = device->read(source.next(0)).counts;
    devices::ForceCommand command;
    for (int i = 0; i < 500; ++i)
        device->command(source.next(0), command);
    QVERIFY(device->read(source.next(0)).counts != first);
    device->close();
    QVERIFY(device->open());
    QCOMPARE(device->read(source.next(0)).counts, first);
    device->close();
    const auto run = [&device] { // the hand trembles: two runs differ unless its tremor begins anew, too
        std::vector<Vec3> hand;
        realtime::TickSource ticks;
        for (int i = 0; i < 300; ++i) {
            device->command(ticks.next(0), {});
            hand.push_back(device->hand().p_D());
        }
        return hand;
    };
    QVERIFY(device->open());
    const std::vector<Vec3> once = run();
    device->close();
    QVERIFY(device->open());
    QVERIFY(run() == once);
}

void TestSimulatedDevice::cuesReachTheMindInD() {
    mechanisms::HandPerception heard;
    SimulatedDevice::Configuration configuration;
    configuration.mapping.origin_m = {0.1, 0.0, 0.0};
    configuration.mapping.scale = 2.0;
    configuration.mapping.leftHanded = true;
    auto device = make(std::make_unique<Listener>(heard), configuration);
    QVERIFY(device->open());
    realtime::TickSource source;
    core::VisibleCues cues;
    cues.p_WObject = Vec3(0.14, 0.02, 0.0);
    const auto now = source.next(0);
    device->show(now, cues);
    device->command(now, {});
    QVERIFY(heard.p_DObject.isZero()); // not shown: not there
    cues.objectShown = true;
    device->show(now, cues);
    device->command(now, {});
    QVERIFY((heard.p_DObject - Vec3(-0.02, 0.01, 0.0)).norm() < 1e-15);
}

void TestSimulatedDevice::measuredIsInW() {
    mechanisms::HandPerception heard;
    SimulatedDevice::Configuration configuration;
    configuration.mapping.leftHanded = true;
    auto device = make(std::make_unique<Listener>(heard), configuration);
    QVERIFY(device->open());
    realtime::TickSource source;
    devices::ForceCommand command;
    command.enabled = true;
    command.wrench_D.force = Vec3(0.5, 0.2, 0.0);
    for (int i = 0; i < 300; ++i) {
        const auto now = source.next(0);
        device->read(now);
        device->command(now, command);
    }
    const auto sample = device->read(source.next(0));
    QVERIFY((sample.status & core::sample_status::kMeasuredForce) != 0);
    QVERIFY(std::abs(sample.measured[0] + 0.5) < 0.02 && std::abs(sample.measured[1] - 0.2) < 0.02);
    // The hand feels it: at rest the arm's spring balances motor force (± 0.1 N of the drives' friction).
    QVERIFY((heard.f_T_D - Vec3(0.5, 0.2, 0.0)).norm() < 0.2);
}

void TestSimulatedDevice::refusesBadConfigurations() {
    QVERIFY(!SimulatedDevice::create({}, nullptr));
    SimulatedDevice::Configuration configuration;
    configuration.start_D = Vec3(0.0, 0.0, 0.2); // above the pivot
    QVERIFY(!SimulatedDevice::create(configuration, circling()));
    configuration.start_D = Vec3(0.3, 0.0, 0.0); // out of travel
    QVERIFY(!SimulatedDevice::create(configuration, circling()));
    // More compensation than the loop gives is refused, not stated and then withheld.
    for (const double share : {-0.01, 0.81, 1.0, std::nan("")}) {
        SimulatedDevice::Configuration compensated;
        compensated.frictionCompensation = share;
        const auto refused = SimulatedDevice::create(compensated, circling());
        QVERIFY2(!refused && refused.error().code == core::ErrorCode::badInput,
                 qPrintable(QString::number(share)));
    }
    SimulatedDevice::Configuration most;
    most.frictionCompensation = devices::kMostFrictionCompensation;
    const auto made = SimulatedDevice::create(most, circling());
    QVERIFY(made.has_value());
    QCOMPARE((*made)->descriptor().frictionCompensation, 0.8);
}

namespace {

/// Stays where it is and wants the jaw as told.
class Fingers final : public mechanisms::HandStrategy {
public:
    explicit Fingers(const double& wanted_rad) : m_wanted_rad(wanted_rad) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception&) noexcept override {
        mechanisms::HandIntention wish;
        wish.p_DDesired = Vec3(0.0, 0.0, 0.05);
        wish.jaw_rad = m_wanted_rad;
        return wish;
    }

private:
    const double& m_wanted_rad;
};

} // namespace

/// Reaction delay, then no faster than fingers are, then the lag's exponential; the counts are the truth on a
/// grid of 10 bits.
void TestSimulatedDevice::theJawFollowsTheFingers() {
    double wanted_rad = 1.2;
    SimulatedDevice::Configuration configuration;
    configuration.jaw = mechanisms::JawParameters{};
    const mechanisms::JawParameters& jaw = *configuration.jaw;
    auto device = make(std::make_unique<Fingers>(wanted_rad), configuration);
    QVERIFY(device && device->open());
    QCOMPARE(device->descriptor().jawResolution_rad, 1.6 / 1023.0);
    realtime::TickSource source;
    double before = 0.0;
    double reached_s = -1.0;
    for (int i = 0; i < 2000; ++i) {
        const auto now = source.next(0);
        const double truth = device->jaw_rad();
        const auto sample = device->read(now);
        const double seen = device->kinematics().pose(sample).jaw_rad;
        QVERIFY(std::abs(seen - truth) <= 0.5 * jaw.resolution_rad() + 1e-12);
        QVERIFY(std::abs(truth - before) <= jaw.fingerSpeed_rad_per_s * 1e-3 + 1e-12);
        QVERIFY(i > 180 || truth == 0.0); // 180 ms of reaction
        if (reached_s < 0.0 && truth > 1.1)
            reached_s = 1e-3 * i;
        before = truth;
        if (i == 1000)
            wanted_rad = 5.0; // wider than it opens
        device->command(now, {});
    }
    QVERIFY2(reached_s > 0.3 && reached_s < 0.5, qPrintable(QString::number(reached_s)));
    QCOMPARE(device->jaw_rad() > 1.5999 && device->jaw_rad() <= 1.6, true);
    QCOMPARE(device->read(source.next(0)).jawCounts, 1023);
    QVERIFY(device->open());
    QCOMPARE(device->read(source.next(0)).jawCounts, 0); // afresh: closed

    configuration.jaw->steps = 0;
    QVERIFY(!SimulatedDevice::create(configuration, circling()));
    configuration.jaw = mechanisms::JawParameters{.widest_rad = 4.0};
    QVERIFY(!SimulatedDevice::create(configuration, circling()));
}

/// The same hand on a probe and on a grasper moves alike to the last bit: P2's jaw has no motor and no mass
/// of its own.
void TestSimulatedDevice::aJawChangesNothingElse() {
    SimulatedDevice::Configuration withJaw;
    withJaw.jaw = mechanisms::JawParameters{};
    auto probe = make(circling());
    auto grasper = make(circling(), withJaw);
    QVERIFY(probe->open() && grasper->open());
    QCOMPARE(probe->descriptor().jawResolution_rad, 0.0);
    realtime::TickSource a, b;
    devices::ForceCommand command;
    command.enabled = true;
    for (int i = 0; i < 2000; ++i) {
        command.wrench_D.force = Vec3(0.1, 0.0, 0.4 * std::sin(0.01 * i));
        const auto first = a.next(0), second = b.next(0);
        QVERIFY(probe->read(first).counts == grasper->read(second).counts);
        QCOMPARE(probe->read(first).jawCounts, 0);
        probe->command(first, command);
        grasper->command(second, command);
    }
}

QTEST_APPLESS_MAIN(TestSimulatedDevice)
#include "test_simulated_device.moc"
