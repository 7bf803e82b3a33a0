// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/station/station_samples.h"

#include <QtTest>
#include <cstring>
#include <memory>

using namespace chiron;
using namespace chiron::test;

namespace {

constexpr std::uint8_t kEnable = STATION_OUTPUT_ENABLE;
constexpr std::uint8_t kClear = STATION_OUTPUT_CLEAR_FAULT;
constexpr std::uint8_t kHome = STATION_OUTPUT_HOME;

/// A device on a bench: the test is its clock, its hand and its host.
class Bench {
public:
    explicit Bench(const station_device_config& config = stationConfig(), std::uint32_t start_us = 0)
        : m_config(std::make_unique<station_device_config>(config)), m_now(start_us) {
        begun = station_device_begin(&device, m_config.get(), start_us);
    }
    void pass(std::uint32_t us) {
        m_now += us;
        station_device_advance(&device, m_now, &hardware);
    }
    station_received take(const StationFrame& frame) {
        return station_device_receive(&device, m_now, frame.data(), reply.data());
    }
    station_received send(std::uint8_t flags, std::uint8_t hold_ms = 20, std::int32_t effort = 5000) {
        return take(outputFrame(++sequence, flags, hold_ms, effort));
    }
    void home() {
        send(0);
        send(kHome);
    }
    void arm(std::uint8_t hold_ms = 20) {
        if (state() == STATION_UNKNOWN)
            home();
        send(0);
        send(kEnable, hold_ms);
    }
    int state() const { return station_device_state(&device); }
    std::int32_t effort(std::uint8_t axis = 0) const { return station_device_effort(&device, axis); }
    station_input input() {
        StationFrame frame{};
        station_device_input(&device, &sample, frame.data());
        station_input read{};
        if (station_decode_input(frame.data(), &read) != STATION_OK)
            read.state = 99;
        return read;
    }
    std::uint32_t now() const { return m_now; }

    station_device device{};
    station_hardware hardware{};
    station_sample sample{};
    StationFrame reply{};
    std::uint16_t sequence = 0;
    bool begun = false;

private:
    std::unique_ptr<station_device_config> m_config;
    std::uint32_t m_now;
};

} // namespace

class TestStationDevice : public QObject {
    Q_OBJECT
private slots:
    void beginsUnknownAndSilent();
    void aBadDescriptionIsRefused();
    void theHomeFlagHomes();
    void aReferenceHomes();
    void armsOnlyAfterAnOutputWithoutEnable();
    void armsOnlyWhenHomed();
    void armsOnlyWithTheDeadManHeld();
    void enableGoneDisarms();
    void theDeadManReleasedDisarms();
    void holdIsKeptToTheMillisecond();
    void aLateFrameFindsTheDeviceLetGo();
    void armsAgainAfterLettingGo();
    void onlyValidNewerFramesRenewTheHold();
    void aLostLinkLetsGo();
    void everyFaultStopsAndIsCleared();
    void anEncoderFaultLosesTheReference();
    void theFirstFaultIsTold();
    void badFramesAreCountedAndChangeNothing();
    void lostOutputsAreCounted();
    void aNewHostMayBeginAnywhere();
    void effortsAreClampedAndFlagged();
    void theDisplayIsShownOnlyWhileArmed();
    void timeWraps();
    void uptimeIsCounted();
    void inputsSayWhatIs();
    void everyPageIsAnswered();
};

void TestStationDevice::beginsUnknownAndSilent() {
    Bench bench;
    QVERIFY(bench.begun);
    bench.pass(1000);
    const station_input input = bench.input();
    QCOMPARE(int(input.state), int(STATION_UNKNOWN));
    QCOMPARE(int(input.flags), 0);
    QCOMPARE(int(input.status), 0);
    QCOMPARE(int(input.sequence), 0);
    QCOMPARE(int(input.applied_sequence), 0);
    QCOMPARE(int(input.applied_age_ms), 255);
    QCOMPARE(input.time_us, 1000u);
    for (std::uint8_t axis = 0; axis < 9; ++axis)
        QCOMPARE(bench.effort(axis), 0);
}

void TestStationDevice::aBadDescriptionIsRefused() {
    const auto refused = [](auto change) {
        station_device_config config = stationConfig();
        change(config);
        return !Bench(config).begun;
    };
    QVERIFY(!refused([](auto&) {}));
    QVERIFY(!refused([](auto& c) { c.identity.parameters = 0; }));
    QVERIFY(refused([](auto& c) { c.identity.axes = 0; }));
    QVERIFY(refused([](auto& c) { c.identity.axes = 5; })); // its fifth axis is not described
    QVERIFY(refused([](auto& c) { c.identity.axes = 200; }));
    QVERIFY(refused([](auto& c) { c.identity.parameters = 49; }));
    QVERIFY(refused([](auto& c) { c.axes[3].count_size = 0.0; }));
    QVERIFY(refused([](auto& c) { std::strcpy(c.names.model, "\x01"); }));
    QVERIFY(refused([](auto& c) { c.parameters[1].values[0] = 1.0 / 0.0; }));
    QVERIFY(!refused([](auto& c) { c.axes[4].count_size = -1.0; })); // is not there
}

void TestStationDevice::theHomeFlagHomes() {
    Bench bench;
    bench.send(0);
    QCOMPARE(bench.state(), int(STATION_UNKNOWN));
    bench.send(kHome | kEnable); // not while it asks for force
    QCOMPARE(bench.state(), int(STATION_UNKNOWN));
    QVERIFY(!station_device_take_reference(&bench.device));
    bench.send(kHome);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    QVERIFY(station_device_take_reference(&bench.device));
    QVERIFY(!station_device_take_reference(&bench.device)); // once
    bench.send(kHome);                                      // at home already
    QVERIFY(!station_device_take_reference(&bench.device));
    QCOMPARE(int(bench.input().flags), int(STATION_INPUT_HOMED));

    Bench other(stationConfig(STATION_RENDERS_FORCE)); // without STATION_HOMES_BY_FLAG
    other.send(0);
    other.send(kHome);
    QCOMPARE(other.state(), int(STATION_UNKNOWN));
}

void TestStationDevice::aReferenceHomes() {
    Bench bench(stationConfig(STATION_RENDERS_FORCE));
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_UNKNOWN));
    bench.hardware.at_reference = true;
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    bench.hardware.at_reference = false; // an index pulse is short
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    QVERIFY(!station_device_take_reference(&bench.device));
}

void TestStationDevice::armsOnlyAfterAnOutputWithoutEnable() {
    Bench bench;
    bench.hardware.at_reference = true;
    bench.pass(1000);
    for (int i = 0; i < 100; ++i) {
        bench.send(kEnable);
        QCOMPARE(bench.state(), int(STATION_HOMED));
        QCOMPARE(bench.effort(), 0);
        bench.pass(1000);
    }
    StationFrame wrong = outputFrame(++bench.sequence, 0); // one that does not count
    wrong[62] ^= 1;
    bench.take(wrong);
    bench.take(outputFrame(1, 0)); // nor does one that comes late
    bench.take(outputFrame(++bench.sequence, 0, 0));
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    bench.send(0);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    QCOMPARE(bench.effort(), 5000); // that frame's
    QCOMPARE(int(bench.input().flags), int(STATION_INPUT_ARMED | STATION_INPUT_HOMED));
}

void TestStationDevice::armsOnlyWhenHomed() {
    Bench bench;
    bench.send(0);
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_UNKNOWN));
    QCOMPARE(bench.effort(), 0);
    bench.hardware.at_reference = true;
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_HOMED)); // time alone does not arm
    bench.send(kEnable);                         // an output without enable has come before
    QCOMPARE(bench.state(), int(STATION_ARMED));
}

void TestStationDevice::armsOnlyWithTheDeadManHeld() {
    Bench bench(stationConfig(STATION_RENDERS_FORCE | STATION_HAS_DEAD_MAN));
    bench.hardware.at_reference = true;
    bench.pass(1000);
    bench.send(0);
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    bench.hardware.dead_man = true;
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    QCOMPARE(int(bench.input().flags), int(STATION_INPUT_HOMED | STATION_INPUT_DEAD_MAN));
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_ARMED));

    Bench without; // a switch that the device does not have
    without.hardware.dead_man = true;
    without.pass(1000);
    QCOMPARE(int(without.input().flags), 0);
}

void TestStationDevice::enableGoneDisarms() {
    Bench bench;
    bench.arm();
    QCOMPARE(bench.state(), int(STATION_ARMED));
    bench.send(0);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    QCOMPARE(bench.effort(), 0);
    QCOMPARE(int(bench.input().status), 0); // nobody let go
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    QCOMPARE(bench.device.counters.watchdog_trips, 0u);
}

void TestStationDevice::theDeadManReleasedDisarms() {
    Bench bench(stationConfig(STATION_RENDERS_FORCE | STATION_HAS_DEAD_MAN));
    bench.hardware = {.dead_man = true, .at_reference = true, .motor_at_limit = false, .fault = 0};
    bench.pass(1000);
    bench.send(0);
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    bench.hardware.dead_man = false;
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    QCOMPARE(bench.effort(), 0);
    bench.hardware.dead_man = true; // held again: a host that has not noticed gets no force
    bench.pass(1000);
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    bench.send(0);
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    QCOMPARE(int(bench.input().status), 0);
}

void TestStationDevice::holdIsKeptToTheMillisecond() {
    for (std::uint8_t hold = 1; hold <= STATION_MOST_HOLD_MS; ++hold) {
        Bench bench;
        bench.arm(hold);
        bench.pass(1000u * hold - 1); // one microsecond before
        QCOMPARE(bench.state(), int(STATION_ARMED));
        QCOMPARE(bench.effort(), 5000);
        bench.pass(1);
        QCOMPARE(bench.state(), int(STATION_HOMED));
        for (std::uint8_t axis = 0; axis < STATION_AXES; ++axis)
            QCOMPARE(bench.effort(axis), 0);
        const station_input input = bench.input();
        QCOMPARE(int(input.status), int(STATION_STATUS_LET_GO));
        QCOMPARE(int(input.applied_age_ms), int(hold));
        QCOMPARE(bench.device.counters.watchdog_trips, 1u);
        bench.pass(1000000);
        QCOMPARE(bench.device.counters.watchdog_trips, 1u); // once
    }
    Bench bench; // the newest frame's, whether longer or shorter
    bench.arm(20);
    bench.send(kEnable, 2);
    bench.pass(2000);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    bench.arm(2);
    bench.send(kEnable, 20);
    bench.pass(19999);
    QCOMPARE(bench.state(), int(STATION_ARMED));
}

void TestStationDevice::aLateFrameFindsTheDeviceLetGo() {
    Bench bench;
    bench.arm(5);
    const std::uint32_t late = bench.now() + 5000; // no period in between
    const StationFrame frame = outputFrame(++bench.sequence, kEnable, 5, 5000);
    QCOMPARE(station_device_receive(&bench.device, late, frame.data(), bench.reply.data()),
             STATION_TOOK_OUTPUT);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    QCOMPARE(bench.effort(), 0);
    QCOMPARE(bench.device.counters.watchdog_trips, 1u);
}

void TestStationDevice::armsAgainAfterLettingGo() {
    Bench bench;
    bench.arm(3);
    bench.pass(3000);
    for (int i = 0; i < 50; ++i) {
        bench.send(kEnable);
        QCOMPARE(bench.state(), int(STATION_HOMED));
        QCOMPARE(int(bench.input().status), int(STATION_STATUS_LET_GO));
        bench.pass(1000);
    }
    bench.send(0);
    QCOMPARE(int(bench.input().status), int(STATION_STATUS_LET_GO)); // until it is armed
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    QCOMPARE(int(bench.input().status), 0);
}

void TestStationDevice::onlyValidNewerFramesRenewTheHold() {
    Bench bench;
    bench.arm(10);
    const StationFrame last = outputFrame(bench.sequence, kEnable, 10, 5000);
    for (int i = 0; i < 9; ++i) {
        bench.pass(1000);
        QCOMPARE(bench.take(last), STATION_IGNORED_STALE); // doubled
        StationFrame bad = outputFrame(static_cast<std::uint16_t>(bench.sequence + 1), kEnable, 10, 5000);
        bad[30] ^= 4;
        QCOMPARE(bench.take(bad), STATION_IGNORED_CRC);
        QCOMPARE(bench.take(outputFrame(static_cast<std::uint16_t>(bench.sequence + 1), kEnable, 21)),
                 STATION_IGNORED_FRAME);
        StationFrame request{};
        station_encode_feature_request(0, request.data());
        QCOMPARE(bench.take(request), STATION_TOOK_REQUEST);
        QCOMPARE(bench.state(), int(STATION_ARMED));
    }
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_HOMED));
}

void TestStationDevice::aLostLinkLetsGo() {
    Bench bench;
    bench.sequence = 40000;
    bench.arm();
    station_device_link_lost(&bench.device, bench.now());
    QCOMPARE(bench.state(), int(STATION_HOMED));
    QCOMPARE(bench.effort(), 0);
    QCOMPARE(int(bench.input().status), int(STATION_STATUS_LET_GO));
    QCOMPARE(bench.device.counters.watchdog_trips, 1u);
    bench.sequence = 0; // the next host begins where it likes
    QCOMPARE(bench.send(kEnable), STATION_TOOK_OUTPUT);
    QCOMPARE(bench.state(), int(STATION_HOMED));
    bench.send(0);
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    QCOMPARE(bench.device.counters.lost_outputs, 0u);
    bench.send(0);
    station_device_link_lost(&bench.device, bench.now()); // at rest there is nothing to let go
    QCOMPARE(bench.device.counters.watchdog_trips, 1u);
}

void TestStationDevice::everyFaultStopsAndIsCleared() {
    for (std::uint8_t code = 1; code <= 8; ++code)
        for (const int from : {int(STATION_UNKNOWN), int(STATION_HOMED), int(STATION_ARMED)}) {
            Bench bench;
            if (from != STATION_UNKNOWN)
                bench.home();
            if (from == STATION_ARMED)
                bench.arm();
            QCOMPARE(bench.state(), from);
            bench.hardware.fault = code;
            bench.pass(1000);
            QCOMPARE(bench.state(), int(STATION_FAULT));
            QCOMPARE(bench.effort(), 0);
            const station_input input = bench.input();
            QCOMPARE(int(input.fault), int(code));
            QVERIFY(input.flags & STATION_INPUT_FAULT);
            QVERIFY(!(input.flags & STATION_INPUT_ARMED));
            bench.send(0); // nothing of this clears it
            bench.send(kEnable);
            bench.send(kHome);
            bench.send(kClear | kEnable);
            bench.send(kClear); // while its cause lasts
            QCOMPARE(bench.state(), int(STATION_FAULT));
            bench.hardware.fault = 0;
            bench.pass(1000);
            QCOMPARE(bench.state(), int(STATION_FAULT)); // it does not go by itself
            bench.send(kClear | kEnable);
            QCOMPARE(bench.state(), int(STATION_FAULT));
            bench.send(kClear);
            const bool homed = from != STATION_UNKNOWN && code != STATION_ENCODER_FAULT;
            QCOMPARE(bench.state(), int(homed ? STATION_HOMED : STATION_UNKNOWN));
            QCOMPARE(int(bench.input().fault), 0);
            QCOMPARE(bench.effort(), 0);
            if (homed) {
                bench.send(kEnable); // the clearing output had none
                QCOMPARE(bench.state(), int(STATION_ARMED));
            }
            QCOMPARE(bench.device.counters.faults, 1u);
        }
    Bench bench; // one that the control loop does not see
    bench.arm();
    station_device_raise_fault(&bench.device, STATION_NO_FAULT);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    station_device_raise_fault(&bench.device, STATION_INTERNAL_FAULT);
    QCOMPARE(bench.state(), int(STATION_FAULT));
    QCOMPARE(bench.effort(), 0);
    bench.send(kClear);
    QCOMPARE(bench.state(), int(STATION_HOMED));
}

void TestStationDevice::anEncoderFaultLosesTheReference() {
    Bench bench(stationConfig(STATION_RENDERS_FORCE));
    bench.hardware.at_reference = true;
    bench.pass(1000);
    bench.hardware.fault = STATION_ENCODER_FAULT; // at the reference all the while
    bench.pass(1000);
    QCOMPARE(int(bench.input().flags), int(STATION_INPUT_FAULT)); // not homed
    bench.hardware = {};
    bench.pass(1000);
    bench.send(kClear);
    QCOMPARE(bench.state(), int(STATION_UNKNOWN));
    bench.send(0);
    bench.send(kEnable);
    QCOMPARE(bench.state(), int(STATION_UNKNOWN));
    bench.hardware.at_reference = true;
    bench.pass(1000);
    QCOMPARE(bench.state(), int(STATION_HOMED));
}

void TestStationDevice::theFirstFaultIsTold() {
    Bench bench;
    bench.hardware.fault = STATION_OVERSPEED;
    bench.pass(1000);
    bench.hardware.fault = STATION_EMERGENCY_STOP;
    bench.pass(1000);
    QCOMPARE(int(bench.input().fault), int(STATION_OVERSPEED));
    QCOMPARE(bench.device.counters.faults, 1u);
    bench.hardware.fault = STATION_ENCODER_FAULT; // the reference is lost all the same
    bench.pass(1000);
    QVERIFY(!(bench.input().flags & STATION_INPUT_HOMED));
}

void TestStationDevice::badFramesAreCountedAndChangeNothing() {
    Bench bench;
    bench.arm();
    const station_counters before = bench.device.counters;
    StationFrame frame = outputFrame(static_cast<std::uint16_t>(bench.sequence + 1), 0, 20, -9);
    StationFrame bad = frame;
    bad[10] ^= 0x20;
    QCOMPARE(bench.take(bad), STATION_IGNORED_CRC);
    for (int type = 0; type < 256; ++type) {
        if (type == STATION_OUTPUT || type == STATION_FEATURE_REQUEST)
            continue;
        bad = frame;
        bad[0] = static_cast<std::uint8_t>(type);
        QCOMPARE(bench.take(sealed(bad)), STATION_IGNORED_FRAME);
    }
    for (int hold = 0; hold < 256; ++hold) {
        if (hold >= 1 && hold <= 20)
            continue;
        bad = frame;
        bad[6] = static_cast<std::uint8_t>(hold);
        QCOMPARE(bench.take(sealed(bad)), STATION_IGNORED_FRAME);
    }
    for (const int back : {0, 1, 2, 1000, 0x7FFF, 0x8000})
        QCOMPARE(bench.take(outputFrame(static_cast<std::uint16_t>(bench.sequence - back), 0)),
                 STATION_IGNORED_STALE);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    QCOMPARE(bench.effort(), 5000);
    QCOMPARE(int(bench.input().applied_sequence), int(bench.sequence));
    station_device_broken_block(&bench.device);
    const station_counters& after = bench.device.counters;
    QCOMPARE(after.bad_crc, before.bad_crc + 2);
    QCOMPARE(after.bad_frames, before.bad_frames + 254 + 236);
    QCOMPARE(after.stale_outputs, before.stale_outputs + 6);
    QCOMPARE(after.lost_outputs, before.lost_outputs);
    QCOMPARE(bench.take(frame), STATION_TOOK_OUTPUT);
    QCOMPARE(bench.state(), int(STATION_HOMED));
}

void TestStationDevice::lostOutputsAreCounted() {
    Bench bench;
    bench.take(outputFrame(65000, 0)); // the first one counts nothing
    QCOMPARE(bench.device.counters.lost_outputs, 0u);
    bench.take(outputFrame(65001, 0));
    bench.take(outputFrame(65003, 0));
    QCOMPARE(bench.device.counters.lost_outputs, 1u);
    bench.take(outputFrame(1, 0)); // over the end of the circle: 65004..65535 and 0
    QCOMPARE(bench.device.counters.lost_outputs, 1u + 533u);
    bench.take(outputFrame(0x8000, 0));
    QCOMPARE(bench.device.counters.lost_outputs, 534u + 0x7FFEu);
}

void TestStationDevice::aNewHostMayBeginAnywhere() {
    Bench bench;
    bench.arm();
    bench.sequence = 30000;
    bench.send(kEnable);
    const std::uint32_t lost = bench.device.counters.lost_outputs;
    bench.pass(STATION_NEW_HOST_US - 1);
    QCOMPARE(bench.take(outputFrame(5, 0)), STATION_IGNORED_STALE);
    bench.pass(1);
    QCOMPARE(bench.take(outputFrame(5, kEnable, 20, 5000)), STATION_TOOK_OUTPUT);
    QCOMPARE(bench.state(), int(STATION_HOMED)); // it has let go, and asks for an output without enable
    QCOMPARE(bench.effort(), 0);
    QCOMPARE(bench.device.counters.lost_outputs, lost);
    QCOMPARE(bench.take(outputFrame(5, 0)), STATION_IGNORED_STALE); // from here on they count
    QCOMPARE(bench.take(outputFrame(6, 0)), STATION_TOOK_OUTPUT);
}

void TestStationDevice::effortsAreClampedAndFlagged() {
    QCOMPARE(station_effort_limit(4.5f), 4500000);
    QCOMPARE(station_effort_limit(0.01f), 10000); // which a float does not quite hold
    QCOMPARE(station_effort_limit(0.0f), 0);
    QCOMPARE(station_effort_limit(-1.0f), 0);
    QCOMPARE(station_effort_limit(std::numeric_limits<float>::quiet_NaN()), 0);
    QCOMPARE(station_effort_limit(5000.0f), std::numeric_limits<std::int32_t>::max());
    QCOMPARE(station_effort_limit(std::numeric_limits<float>::infinity()),
             std::numeric_limits<std::int32_t>::max());
    Bench bench; // ratings 4.5, 0.01, 2000 and none
    bench.arm();
    const auto limited = [&](std::int32_t axis, std::int32_t wanted) {
        station_output output{};
        output.flags = kEnable;
        output.sequence = ++bench.sequence;
        output.hold_ms = 20;
        output.effort[axis] = wanted;
        StationFrame frame{};
        (void)station_encode_output(&output, frame.data());
        bench.take(frame);
        const bool flagged = bench.input().status & STATION_STATUS_AT_LIMIT;
        return std::pair{bench.effort(static_cast<std::uint8_t>(axis)), flagged};
    };
    constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
    QCOMPARE(limited(0, 4500000), std::pair(4500000, false));
    QCOMPARE(limited(0, 4500001), std::pair(4500000, true));
    QCOMPARE(limited(0, -4500000), std::pair(-4500000, false));
    QCOMPARE(limited(0, -4500001), std::pair(-4500000, true));
    QCOMPARE(limited(0, least), std::pair(-4500000, true));
    QCOMPARE(limited(1, 10001), std::pair(10000, true));
    QCOMPARE(limited(2, -1999999999), std::pair(-1999999999, false));
    QCOMPARE(limited(3, 1), std::pair(0, true));   // no motor
    QCOMPARE(limited(4, 99), std::pair(0, false)); // no axis
    QCOMPARE(limited(7, least), std::pair(0, false));
    QCOMPARE(limited(0, 0), std::pair(0, false)); // the flag is of the output that is applied
    (void)limited(0, least);
    bench.send(0);
    QCOMPARE(int(bench.input().status), 0);
    bench.hardware.motor_at_limit = true;
    bench.pass(1000);
    QCOMPARE(int(bench.input().status), int(STATION_STATUS_AT_LIMIT));
}

void TestStationDevice::theDisplayIsShownOnlyWhileArmed() {
    Bench bench; // 4.5 N at most
    std::int16_t force = 1, pitch = 1, roll = 1;
    const auto send = [&](std::uint8_t flags, std::int16_t force_mN) {
        station_output output{};
        output.flags = flags;
        output.sequence = ++bench.sequence;
        output.hold_ms = 5;
        output.display_force_mN = force_mN;
        output.display_pitch_1e4_rad = -300;
        output.display_roll_1e4_rad = 200;
        StationFrame frame{};
        (void)station_encode_output(&output, frame.data());
        bench.take(frame);
        return station_device_display(&bench.device, &force, &pitch, &roll);
    };
    bench.home();
    QVERIFY(!send(STATION_OUTPUT_DISPLAY, 1000));
    QCOMPARE(int(force), 0);
    QVERIFY(send(STATION_OUTPUT_DISPLAY | kEnable, 1000));
    QCOMPARE(int(force), 1000);
    QCOMPARE(int(pitch), -300);
    QCOMPARE(int(roll), 200);
    QVERIFY(send(STATION_OUTPUT_DISPLAY | kEnable, 32767));
    QCOMPARE(int(force), 4500);
    QVERIFY(bench.input().status & STATION_STATUS_AT_LIMIT);
    QVERIFY(send(STATION_OUTPUT_DISPLAY | kEnable, -32768));
    QCOMPARE(int(force), -4500);
    QVERIFY(!send(kEnable, 1000));
    QCOMPARE(int(force), 0);
    QVERIFY(send(STATION_OUTPUT_DISPLAY | kEnable, 1000));
    bench.pass(5000);
    QVERIFY(!station_device_display(&bench.device, &force, &pitch, &roll));
    QVERIFY(force == 0 && pitch == 0 && roll == 0);
}

void TestStationDevice::timeWraps() {
    for (std::uint32_t before = 0; before <= 12000;
         before += 500) { // the wrap falls on each place of the hold
        Bench bench(stationConfig(), 0u - before);
        bench.arm(10);
        for (int ms = 1; ms < 10; ++ms) {
            bench.pass(1000);
            QCOMPARE(bench.state(), int(STATION_ARMED));
        }
        bench.pass(999);
        QCOMPARE(bench.state(), int(STATION_ARMED));
        bench.pass(1);
        QCOMPARE(bench.state(), int(STATION_HOMED));
        QCOMPARE(bench.input().time_us, 10000u - before);
    }
    Bench bench; // an age beyond the clock's circle does not begin anew
    bench.arm(20);
    bench.pass(20000);
    for (int i = 0; i < 3 * 4295; ++i) {
        bench.pass(1000000);
        if (bench.input().applied_age_ms != 255)
            QFAIL("the age came round");
    }
    bench.arm(20);
    QCOMPARE(bench.state(), int(STATION_ARMED));
    bench.pass(0xFFFFFFF0u); // a clock that goes back lets go at once
    QCOMPARE(bench.state(), int(STATION_HOMED));
}

void TestStationDevice::uptimeIsCounted() {
    Bench bench(stationConfig(), 0xFFFF0000u);
    core::Random random(31);
    std::uint64_t passed = 0;
    for (int i = 0; i < 10000; ++i) {
        const auto step = static_cast<std::uint32_t>(random.below(3000000));
        bench.pass(step);
        passed += step;
        QCOMPARE(std::uint64_t(bench.device.counters.uptime_s), passed / 1000000);
    }
}

void TestStationDevice::inputsSayWhatIs() {
    Bench bench(stationConfig(STATION_RENDERS_FORCE | STATION_HOMES_BY_FLAG | STATION_HAS_JAW |
                              STATION_MEASURES_FORCE));
    for (int i = 0; i < 8; ++i)
        bench.sample.counts[i] = 100 * (i + 1);
    bench.sample.jaw = -7;
    for (int i = 0; i < 6; ++i)
        bench.sample.wrench[i] = static_cast<std::int16_t>(i - 3);
    bench.sample.wrench_valid = true;
    bench.sample.buttons = 0xFA; // four of them
    bench.sample.supply_mV = 23456;
    bench.sequence = 0xFFF0;
    bench.home();
    bench.pass(3999);
    const station_input input = bench.input();
    QCOMPARE(input.counts[3], 400);
    QCOMPARE(input.counts[4], 0); // there are four
    QCOMPARE(int(input.jaw), -7);
    QCOMPARE(int(input.wrench[0]), -3);
    QCOMPARE(int(input.status), int(STATION_STATUS_WRENCH_VALID));
    QCOMPARE(int(input.flags), 0xA0 | STATION_INPUT_HOMED);
    QCOMPARE(int(input.supply_mV), 23456);
    QCOMPARE(int(input.applied_sequence), 0xFFF2);
    QCOMPARE(int(input.applied_age_ms), 3);
    bench.sample.wrench_valid = false;
    QCOMPARE(int(bench.input().wrench[0]), 0);
    for (int i = 2; i < 70000; ++i)
        QCOMPARE(bench.input().sequence, static_cast<std::uint16_t>(i));
    for (const std::uint32_t age_ms : {253u, 254u, 255u, 256u, 100000u}) {
        Bench other;
        other.home();
        other.pass(1000 * age_ms + 999);
        QCOMPARE(std::uint32_t(other.input().applied_age_ms), std::min(age_ms, 255u));
    }
    Bench plain; // neither jaw nor force sensor
    plain.sample = bench.sample;
    plain.sample.wrench_valid = true;
    QCOMPARE(int(plain.input().jaw), 0);
    QCOMPARE(int(plain.input().status), 0);
}

void TestStationDevice::everyPageIsAnswered() {
    station_device_config config = stationConfig();
    config.identity.major = 77; // the code's own is told
    Bench bench(config);
    for (int page = 0; page < 256; ++page) {
        StationFrame request{};
        station_encode_feature_request(static_cast<std::uint8_t>(page), request.data());
        QCOMPARE(bench.take(request), STATION_TOOK_REQUEST);
        std::uint8_t back = 0, status = 9;
        QCOMPARE(station_decode_feature_head(bench.reply.data(), &back, &status), STATION_OK);
        QCOMPARE(int(back), page);
        const bool there = page <= 4 || (page >= 16 && page < 20) || page == 32 || page == 33;
        QCOMPARE(int(status), int(there ? STATION_PAGE_OK : STATION_NO_SUCH_PAGE));
        station_identity identity{};
        if (page == 0) {
            QCOMPARE(station_decode_identity(bench.reply.data(), &identity), STATION_OK);
            QCOMPARE(int(identity.major), STATION_MAJOR);
            QCOMPARE(int(identity.minor), STATION_MINOR);
            QCOMPARE(int(identity.axes), 4);
        }
        station_axis axis{};
        if (page == 18) {
            QCOMPARE(station_decode_axis(bench.reply.data(), 2, &axis), STATION_OK);
            QCOMPARE(axis.maximum, config.axes[2].maximum);
        }
    }
    QCOMPARE(bench.state(), int(STATION_UNKNOWN));
    QCOMPARE(int(bench.input().applied_age_ms), 255); // a request is no output
}

QTEST_GUILESS_MAIN(TestStationDevice)
#include "test_station_device.moc"
