// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/replay/replay_device.h"
#include "devices/recorded_device.h"

#include "core/units.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace chiron;
using core::Quat;
using core::Vec3;
using devices::ReplayDevice;
using devices::TracePoint;

namespace {
std::vector<core::DeviceSample> play(ReplayDevice& device, std::size_t ticks) {
    realtime::TickSource source;
    std::vector<core::DeviceSample> samples;
    for (std::size_t n = 0; n < ticks; ++n)
        samples.push_back(device.read(source.next(static_cast<std::int64_t>(n) * 1'000'000)));
    return samples;
}
Quat about(const Vec3& axis, double angle) {
    return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}
} // namespace

class TestReplayDevice : public QObject {
    Q_OBJECT
private slots:
    void resamplesLinearlyOnOneMicrometre() {
        const auto device =
            ReplayDevice::create({{.t_s = 5.0, .p_WT_m = {0.0, 0.0, 0.010}, .jaw_rad = 0.0},
                                  {.t_s = 5.004, .p_WT_m = {0.004, -0.001, 0.010}, .jaw_rad = 0.2}});
        QVERIFY(device.has_value());
        QCOMPARE((*device)->ticks(), std::size_t{5});
        const auto samples = play(**device, 5);
        for (int n = 0; n < 5; ++n) {
            const auto& s = samples[static_cast<std::size_t>(n)];
            QCOMPARE(s.counts[0], 1000 * n);
            QCOMPARE(s.counts[1], -250 * n);
            QCOMPARE(s.counts[2], 10'000);
            QCOMPARE(s.jawCounts, 50'000 * n);
            QCOMPARE(s.packet, static_cast<std::uint32_t>(n + 1));
            QCOMPARE(s.deviceTime_us, static_cast<std::uint64_t>(1000 * n));
        }
    }

    void holdsTheLastPoseAndSaysThatItIsOver() {
        const auto device =
            ReplayDevice::create({{.t_s = 0.0}, {.t_s = 0.002, .p_WT_m = {0.002, 0.0, 0.0}, .buttons = 1}});
        realtime::TickSource ticks;
        for (int n = 0; n < 3; ++n) {
            (void)(*device)->read(ticks.next(0));
            QVERIFY(!(*device)->finished());
        }
        const core::DeviceSample after = (*device)->read(ticks.next(0));
        QVERIFY((*device)->finished());
        QCOMPARE(after.counts[0], 2000);
        QCOMPARE(after.buttons, 1u);
        QCOMPARE(after.packet, 4u);
        QVERIFY((*device)->open().has_value());
        QVERIFY(!(*device)->finished());
        QCOMPARE((*device)->read(ticks.next(0)).counts[0], 0);
    }

    void buttonsAreHeldAndAShortPressIsNotLost() {
        const auto device = ReplayDevice::create({{.t_s = 0.0},
                                                  {.t_s = 0.0021, .buttons = 1},
                                                  {.t_s = 0.0024, .buttons = 0},
                                                  {.t_s = 0.0045, .buttons = 2},
                                                  {.t_s = 0.0070, .buttons = 0}});
        const auto samples = play(**device, 8);
        const std::vector<std::uint32_t> expected{0, 0, 0, 1, 0, 2, 2, 2};
        for (std::size_t n = 0; n < 7; ++n)
            QCOMPARE(samples[n].buttons, expected[n]);
        QCOMPARE(samples[7].buttons, 0u); // beyond the last row
    }

    void aTraceWithRoundedTimesKeepsItsLastRow() {
        std::vector<TracePoint> trace;
        for (int n = 0; n <= 1000; ++n)
            trace.push_back({.t_s = 0.1 + 0.001 * n, .p_WT_m = {1e-6 * n, 0.0, 0.0}});
        const auto device = ReplayDevice::create(trace);
        QCOMPARE((*device)->ticks(), std::size_t{1001});
        const auto samples = play(**device, 1001);
        for (std::size_t n = 0; n <= 1000; ++n)
            QCOMPARE(samples[n].counts[0], static_cast<std::int32_t>(n));
    }

    void orientationIsSlerpedAndComesBackThroughTheKinematics() {
        const Quat start = about({1, 2, 3}, 0.4);
        const Quat end = about({-1, 0.5, 2}, 2.0);
        const auto device = ReplayDevice::create({{.t_s = 0.0, .q_WT = start}, {.t_s = 0.010, .q_WT = end}});
        const auto samples = play(**device, 11);
        for (std::size_t n = 0; n <= 10; ++n) {
            const Quat expected = start.slerp(static_cast<double>(n) / 10.0, end);
            const Quat got = (*device)->kinematics().pose(samples[n]).q_WT;
            QVERIFY(got.angularDistance(expected) < 3e-6); // half a count of 1 µrad on three axes
        }
    }

    /// Two full turns about a tilted axis: the rotation vector must go on without a jump at half a turn.
    void turningOnNeverJumps() {
        std::vector<TracePoint> trace;
        for (int n = 0; n <= 400; ++n)
            trace.push_back({.t_s = 0.001 * n, .q_WT = about({0.2, -0.3, 1.0}, 0.0314159 * n + 0.1)});
        const auto device = ReplayDevice::create(trace);
        QVERIFY(device.has_value());
        const auto samples = play(**device, 401);
        for (std::size_t n = 1; n <= 400; ++n) {
            for (std::size_t axis = 3; axis < 6; ++axis)
                QVERIFY(std::abs(samples[n].counts[axis] - samples[n - 1].counts[axis]) < 40'000);
            QVERIFY((*device)->kinematics().pose(samples[n]).q_WT.angularDistance(*trace[n].q_WT) < 3e-6);
        }
    }

    void badTracesAreRefusedByRow_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("place");
        QTest::newRow("time stands still") << 0 << "row 3";
        QTest::newRow("time goes back") << 1 << "row 3";
        QTest::newRow("time is nan") << 2 << "row 3";
        QTest::newRow("position is infinite") << 3 << "row 3";
        QTest::newRow("position is far") << 4 << "row 3";
        QTest::newRow("jaw is nan") << 5 << "row 3";
        QTest::newRow("orientation in one row") << 6 << "row 3";
        QTest::newRow("orientation of length 2") << 7 << "row 1";
        QTest::newRow("too long") << 8 << "row 3";
        QTest::newRow("time is infinite") << 9 << "row 3";
    }
    void badTracesAreRefusedByRow() {
        QFETCH(int, kind);
        QFETCH(QString, place);
        std::vector<TracePoint> trace{{.t_s = 0.0}, {.t_s = 0.1}, {.t_s = 0.2}};
        TracePoint& bad = trace[2];
        switch (kind) {
        case 0:
            bad.t_s = 0.1;
            break;
        case 1:
            bad.t_s = 0.05;
            break;
        case 2:
            bad.t_s = std::nan("");
            break;
        case 3:
            bad.p_WT_m.y() = std::numeric_limits<double>::infinity();
            break;
        case 4:
            bad.p_WT_m.z() = 10.5;
            break;
        case 5:
            bad.jaw_rad = std::nan("");
            break;
        case 6:
            bad.q_WT = Quat::Identity();
            break;
        case 7:
            for (auto& point : trace)
                point.q_WT = Quat(2.0, 0.0, 0.0, 0.0);
            break;
        case 8:
            bad.t_s = 1e9;
            break;
        case 9:
            bad.t_s = std::numeric_limits<double>::infinity();
            break;
        }
        const auto device = ReplayDevice::create(trace);
        QVERIFY(!device);
        QVERIFY2(device.error().message.find(place.toStdString()) != std::string::npos,
                 device.error().message.c_str());
        QVERIFY(device.error().code == core::ErrorCode::badInput);
    }

    void anEmptyTraceIsRefusedAndOneRowIsEnough() {
        QVERIFY(!ReplayDevice::create({}));
        const auto one = ReplayDevice::create({{.t_s = 3.0, .p_WT_m = {0.001, 0.0, 0.0}}});
        QVERIFY(one.has_value());
        const auto samples = play(**one, 2);
        QCOMPARE(samples[1].counts[0], 1000);
        QVERIFY((*one)->finished());
    }

    void aRecordedDeviceIsTheStoredDescriptorWithoutTheHardware() {
        const auto original = ReplayDevice::create({{.t_s = 0.0, .p_WT_m = {0.004, 0.0, 0.0}}});
        const auto recorded = devices::RecordedDevice::create((*original)->descriptor());
        QVERIFY(recorded.has_value());
        const auto samples = play(**original, 1);
        (*recorded)->setSample(samples[0]);
        realtime::TickSource ticks;
        const core::DeviceSample again = (*recorded)->read(ticks.next(0));
        QCOMPARE(again.counts, samples[0].counts);
        QVERIFY((*recorded)->kinematics().pose(again).p_WT ==
                (*original)->kinematics().pose(samples[0]).p_WT);
        devices::DeviceDescriptor unknown;
        unknown.kinematics = "none";
        QVERIFY(!devices::RecordedDevice::create(unknown));
    }
};

QTEST_APPLESS_MAIN(TestReplayDevice)
#include "test_replay_device.moc"
