// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/firmware/firmware.h"
#include "station/firmware/lm3s6965/axes_emulated.h"
#include "support/station_conformance.h"

#include <QtTest>
#include <array>
#include <cstdlib>

using namespace chiron::test;

namespace {

/// The board of this test: computed axes, and what else a board knows.
struct Board {
    std::array<emulated_axis, 3> axes{};
    int offTicks = 0;
    int mostDuty = 0;
    int locks = 0;
    int wrongLocks = 0;
    std::uint16_t supply_mV = 24000;
    std::uint8_t fault = 0;
    std::int32_t stuckCurrent_mA = 0; ///< of a broken sensor; 0: the axis' own
};
Board board;

} // namespace

extern "C" {
void board_tick() {
    for (emulated_axis& axis : board.axes)
        emulated_axis_step(&axis);
}
std::int32_t board_counts(std::uint8_t axis) {
    return axis < 3 ? emulated_axis_counts(&board.axes[axis]) : 0;
}
std::int32_t board_current_mA(std::uint8_t axis) {
    if (board.stuckCurrent_mA != 0)
        return board.stuckCurrent_mA;
    return axis < 3 ? board.axes[axis].current_mA : 0;
}
void board_drive(std::uint8_t axis, std::int32_t duty_permille) {
    board.offTicks = 0;
    board.mostDuty = std::max(board.mostDuty, std::abs(duty_permille));
    board.axes[axis].duty_permille = duty_permille;
}
void board_motors_off() {
    ++board.offTicks;
    for (emulated_axis& axis : board.axes)
        axis.duty_permille = axis.current_mA = 0;
}
bool board_dead_man() {
    return false;
}
std::uint8_t board_buttons() {
    return 5;
}
std::uint16_t board_supply_mV() {
    return board.supply_mV;
}
std::uint8_t board_fault() {
    return board.fault;
}
void board_lock() {
    board.wrongLocks += board.locks++ != 0 ? 1 : 0;
}
void board_unlock() {
    board.wrongLocks += --board.locks != 0 ? 1 : 0;
}
}

namespace {

/// A host on the firmware's serial line: each input that it waits for is a period.
class FirmwareLine : public StationLine {
public:
    FirmwareLine() {
        board = {};
        begun = firmware_begin(&firmware, &the_description);
        station_cobs_begin(&m_decoder);
    }
    bool send(const QList<Frame>& frames) override {
        for (const Frame& frame : frames) {
            std::array<std::uint8_t, STATION_COBS_SIZE> line{};
            station_cobs_encode(frame.data(), line.data());
            if (!byte_ring_put(&firmware.received, line.data(), line.size()))
                return false;
        }
        return true;
    }
    bool sendBytes(const QByteArray& bytes) override {
        return byte_ring_put(&firmware.received, reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                             static_cast<std::size_t>(bytes.size()));
    }
    bool next(Frame& frame) override {
        for (int ticks = 0; ticks < 100; ++ticks) {
            std::uint8_t byte = 0;
            while (byte_ring_take(&firmware.to_send, &byte)) {
                const auto event = station_cobs_take(&m_decoder, byte, frame.data());
                broken += event == STATION_COBS_BROKEN ? 1 : 0;
                if (event == STATION_COBS_FRAME)
                    return true;
            }
            if (polls)
                firmware_poll(&firmware);
            firmware_tick(&firmware);
        }
        return false;
    }
    QByteArrayList service() {
        QByteArray text;
        std::uint8_t byte = 0;
        while (byte_ring_take(&firmware.service, &byte))
            text += static_cast<char>(byte);
        QByteArrayList lines = text.split('\n');
        lines.removeLast();
        return lines;
    }

    ::firmware firmware{};
    bool begun = false;
    bool polls = true; ///< the program runs; false: it hangs, and the tick goes on
    int broken = 0;

private:
    station_cobs m_decoder{};
};

struct Host {
    Host() : conformance(line) {
        ready = line.begun && conformance.pagesDescribeIt().isEmpty() &&
                conformance.becomesHomed().isEmpty() && conformance.arm(input).isEmpty();
    }
    /// Commands an effort for some periods.
    void push(std::int32_t effort, int periods) {
        for (int i = 0; i < periods; ++i)
            QVERIFY(conformance.exchange(STATION_OUTPUT_ENABLE, input, 20, effort));
    }
    FirmwareLine line;
    StationConformance conformance;
    station_input input{};
    bool ready = false;
};

} // namespace

class TestStationFirmware : public QObject {
    Q_OBJECT
private slots:
    void cleanup();
    void itKeepsWhatTheProtocolPromises();
    void itLetsGoWhileItsProgramHangs();
    void theCurrentFollowsTheEffort();
    void theDutyStaysWithinTheBridge();
    void aTooFastAxisIsAFault();
    void tooMuchCurrentIsAFault();
    void aLowSupplyIsAFault();
    void whatTheBoardFindsIsAFault();
    void theHomeFlagMakesZero();
    void aLineThatNobodyReadsLosesWholeFrames();
    void theServiceLineTellsEachChange();
    void ringsLoseNothing();
};

void TestStationFirmware::cleanup() {
    QCOMPARE(board.wrongLocks, 0);
    QCOMPARE(board.locks, 0);
}

void TestStationFirmware::itKeepsWhatTheProtocolPromises() {
    FirmwareLine line;
    QVERIFY(line.begun);
    StationConformance conformance(line);
    QCOMPARE(conformance.all(), QString());
    QCOMPARE(line.broken, 0);
    QVERIFY(board.offTicks > 0);
}

void TestStationFirmware::itLetsGoWhileItsProgramHangs() {
    Host host;
    QVERIFY(host.ready);
    host.push(1000000, 5);
    QVERIFY(board.axes[0].current_mA > 0);
    host.line.polls = false;
    const std::uint32_t from = host.line.firmware.now_us;
    for (int ticks = 0; ticks < 1000 && board.offTicks == 0; ++ticks) {
        QVERIFY(host.line.send({host.conformance.output(STATION_OUTPUT_ENABLE)}) ||
                ticks > 20); // until its ring is full
        firmware_tick(&host.line.firmware);
    }
    QVERIFY(host.line.firmware.now_us - from <= 20000);
    QCOMPARE(int(station_device_state(&host.line.firmware.device)), int(STATION_HOMED));
    QVERIFY(host.line.firmware.device.let_go);
    QCOMPARE(board.axes[0].duty_permille, 0);
}

void TestStationFirmware::theCurrentFollowsTheEffort() {
    Host host;
    QVERIFY(host.ready);
    for (const std::int32_t effort : {100000, -100000, 1500000, -4000000, 0}) { // 1 N for each ampere
        host.push(effort, 6);
        QVERIFY2(std::abs(board.axes[1].current_mA - effort / 1000) <= 12 + std::abs(effort) / 20000,
                 qPrintable(QString::number(board.axes[1].current_mA)));
        for (int i = 0; i < 40; ++i) // back to rest
            host.push(board.axes[1].speed_um_per_s > 0 ? -20000 : 20000, 1);
    }
    host.push(2147483647, 3); // clamped to 4.5 N
    QVERIFY(board.axes[0].current_mA < 4600);
    QVERIFY(host.input.status & STATION_STATUS_AT_LIMIT);
}

void TestStationFirmware::theDutyStaysWithinTheBridge() {
    motor_description motor = the_description.motors[0];
    current_control control{};
    QCOMPARE(current_control_step(&control, &motor, 2147483647, -1000000), 1000);
    QVERIFY(control.at_limit);
    for (int i = 0; i < 100000; ++i)
        QCOMPARE(current_control_step(&control, &motor, 2147483647, -1000000), 1000);
    int ticks = 0; // the integral has not run away: the sign turns soon
    while (current_control_step(&control, &motor, 0, 5000) > 0)
        QVERIFY(++ticks < 20);
    current_control_reset(&control);
    QCOMPARE(current_control_step(&control, &motor, 0, 0), 0);
    QVERIFY(!control.at_limit);
    motor.effort_per_A = 0; // no motor
    QCOMPARE(current_control_step(&control, &motor, 1000000, 0), 0);
}

void TestStationFirmware::aTooFastAxisIsAFault() {
    Host host;
    QVERIFY(host.ready);
    for (int i = 0; i < 200 && host.input.state == STATION_ARMED; ++i)
        host.push(4500000, 1);
    QCOMPARE(int(host.input.state), int(STATION_FAULT));
    QCOMPARE(int(host.input.fault), int(STATION_OVERSPEED));
    QVERIFY(board.offTicks > 0);
    QVERIFY(board.axes[0].speed_um_per_s > 500000);
    station_input input{};
    QVERIFY(host.conformance.exchange(STATION_OUTPUT_CLEAR_FAULT, input)); // as long as it is too fast: no
    for (int i = 0; i < 200 && input.state == STATION_FAULT; ++i)
        QVERIFY(host.conformance.exchange(STATION_OUTPUT_CLEAR_FAULT, input));
    QCOMPARE(int(input.state), int(STATION_HOMED));
    QVERIFY(board.axes[0].speed_um_per_s <= 1000000);
}

void TestStationFirmware::tooMuchCurrentIsAFault() {
    Host host;
    QVERIFY(host.ready);
    board.stuckCurrent_mA = -8000;
    for (int ticks = 1; ticks <= 5; ++ticks) {
        QCOMPARE(int(station_device_state(&host.line.firmware.device)), int(STATION_ARMED));
        firmware_tick(&host.line.firmware);
    }
    QCOMPARE(int(station_device_state(&host.line.firmware.device)), int(STATION_FAULT));
    QCOMPARE(int(host.line.firmware.device.fault), int(STATION_OVER_CURRENT));
    QVERIFY(board.offTicks > 0);
}

void TestStationFirmware::aLowSupplyIsAFault() {
    Host host;
    QVERIFY(host.ready);
    station_input input{};
    board.supply_mV = 17999;
    host.push(0, 3);
    board.supply_mV = 18000; // a dip
    host.push(0, 5);
    QCOMPARE(int(host.input.state), int(STATION_ARMED));
    board.supply_mV = 5000;
    host.push(0, 8);
    QCOMPARE(int(host.input.state), int(STATION_FAULT));
    QCOMPARE(int(host.input.fault), int(STATION_SUPPLY_FAULT));
    QCOMPARE(int(host.input.supply_mV), 5000);
    QVERIFY(host.conformance.exchange(STATION_OUTPUT_CLEAR_FAULT, input));
    QCOMPARE(int(input.state), int(STATION_FAULT));
    board.supply_mV = 24000;
    QVERIFY(host.conformance.exchange(0, input));
    QVERIFY(host.conformance.exchange(STATION_OUTPUT_CLEAR_FAULT, input));
    QCOMPARE(int(input.state), int(STATION_HOMED));
}

void TestStationFirmware::whatTheBoardFindsIsAFault() {
    for (const std::uint8_t code :
         {STATION_EMERGENCY_STOP, STATION_ENCODER_FAULT, STATION_OVER_TEMPERATURE}) {
        Host host;
        QVERIFY(host.ready);
        host.push(1000000, 5);
        QCOMPARE(int(host.input.flags >> 4), 5); // its buttons
        board.fault = code;
        firmware_tick(&host.line.firmware); // one tick, no host, no program
        QCOMPARE(int(host.line.firmware.device.fault), int(code));
        QVERIFY(board.offTicks > 0);
        QCOMPARE(board.axes[2].current_mA, 0);
    }
}

void TestStationFirmware::theHomeFlagMakesZero() {
    FirmwareLine line;
    StationConformance conformance(line);
    for (emulated_axis& axis : board.axes)
        axis.place_pm100 = 10000LL * 12345;
    station_input input{};
    QVERIFY(conformance.exchange(0, input));
    QCOMPARE(input.counts[1], 12345);
    QVERIFY(conformance.exchange(STATION_OUTPUT_HOME, input));
    QVERIFY(conformance.input(input));
    QCOMPARE(int(input.state), int(STATION_HOMED));
    QCOMPARE(input.counts[1], 0);
    board.axes[1].place_pm100 += 10000LL * 7;
    QVERIFY(conformance.input(input));
    QCOMPARE(input.counts[1], 7);

    static description elsewhere = the_description; // homed at a place that is not zero
    elsewhere.reference_counts[1] = -500;
    QVERIFY(firmware_begin(&line.firmware, &elsewhere));
    QVERIFY(conformance.exchange(STATION_OUTPUT_HOME, input));
    QVERIFY(conformance.input(input));
    QCOMPARE(input.counts[1], -500);
    QCOMPARE(input.counts[0], 0);
    elsewhere.device.axes[1].count_size = -1.0; // no description at all
    QVERIFY(!firmware_begin(&line.firmware, &elsewhere));
}

void TestStationFirmware::aLineThatNobodyReadsLosesWholeFrames() {
    FirmwareLine line;
    for (int ticks = 0; ticks < 20000; ++ticks)
        firmware_tick(&line.firmware);
    StationConformance conformance(line);
    station_input first{}, input{};
    QVERIFY(conformance.input(first));
    QCOMPARE(int(first.sequence), 0);
    int frames = 1;
    do {
        QVERIFY(conformance.input(input));
        ++frames;
    } while (input.sequence < 2000); // what found room, and then what is new
    QVERIFY(frames > 20 && frames < 40);
    QCOMPARE(line.broken, 0);
}

void TestStationFirmware::theServiceLineTellsEachChange() {
    Host host;
    QVERIFY(host.ready);
    for (int ticks = 0; ticks < 300; ++ticks)
        firmware_tick(&host.line.firmware);
    const QByteArrayList lines = host.line.service();
    QCOMPARE(lines.size(), 4);
    QVERIFY(lines[0].startsWith("100 us unknown fault 0 "));
    QVERIFY(lines[1].contains(" us homed fault 0 "));
    QVERIFY(lines[2].contains(" us armed fault 0 "));
    QVERIFY(lines[3].contains(" us homed let-go fault 0 age 20000 hold 20\r"));
}

void TestStationFirmware::ringsLoseNothing() {
    static byte_ring ring;
    ring.put = 0xFFFFFC00u; // over the end of the counters
    ring.taken = 0xFFFFFC00u;
    std::array<std::uint8_t, BYTE_RING_SIZE + 1> bytes{};
    QVERIFY(!byte_ring_put(&ring, bytes.data(), bytes.size()));
    QVERIFY(byte_ring_is_empty(&ring));
    std::uint8_t next = 0, expected = 0, byte = 0;
    for (int round = 0; round < 5000; ++round) {
        const std::size_t count = static_cast<std::size_t>(round * 37 % 300);
        for (std::size_t i = 0; i < count; ++i)
            bytes[i] = static_cast<std::uint8_t>(next + i);
        if (byte_ring_put(&ring, bytes.data(), count))
            next = static_cast<std::uint8_t>(next + count);
        for (int i = 0; i < round * 53 % 310 && byte_ring_take(&ring, &byte); ++i)
            QCOMPARE(byte, expected++);
    }
    while (byte_ring_take(&ring, &byte))
        QCOMPARE(byte, expected++);
    QCOMPARE(expected, next);
}

QTEST_GUILESS_MAIN(TestStationFirmware)
#include "test_station_firmware.moc"
