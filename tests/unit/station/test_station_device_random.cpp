// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/station/station_samples.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cstdlib>

using namespace chiron;
using namespace chiron::test;

namespace {

/// What the page says, written down a second time and slowly: 64-bit time, and the whole history where the
/// device keeps a flag.
class Oracle {
public:
    void passTo(std::uint64_t now) {
        m_now = now;
        if (armed && now - m_lastOutput >= 1000u * m_hold)
            leaveArmed();
    }
    void hear(const station_output& output) {
        m_lastOutput = m_now;
        m_hold = output.hold_ms;
        if (!(output.flags & STATION_OUTPUT_ENABLE)) {
            armed = false;
            m_disabledSeen = true;
        } else if (homed && !fault && held && m_disabledSeen) {
            armed = true;
        }
    }
    void leaveArmed() {
        armed = false;
        m_disabledSeen = false;
    }
    void letGoOfTheSwitch() {
        held = false;
        if (armed)
            leaveArmed();
    }

    bool armed = false, homed = false, fault = false, held = false;

private:
    std::uint64_t m_now = 0, m_lastOutput = 0;
    std::uint8_t m_hold = 0;
    bool m_disabledSeen = false;
};

bool anyEffort(const station_device& device) {
    std::int16_t force = 0, pitch = 0, roll = 0;
    bool any = station_device_display(&device, &force, &pitch, &roll) || force || pitch || roll;
    for (std::uint8_t axis = 0; axis < STATION_AXES; ++axis)
        any = any || station_device_effort(&device, axis) != 0;
    return any;
}

} // namespace

class TestStationDeviceRandom : public QObject {
    Q_OBJECT
private slots:
    void noEffortPassesUnlessArmed();
    void effortsStayWithinTheRatings();
};

/// 1,000,000 frames, good and bad, at any time: the device is armed exactly when an independent reading of
/// the rules says so, and otherwise gives nothing.
void TestStationDeviceRandom::noEffortPassesUnlessArmed() {
    core::Random random(41);
    const station_device_config config =
        stationConfig(STATION_RENDERS_FORCE | STATION_HOMES_BY_FLAG | STATION_HAS_DEAD_MAN);
    station_device device{};
    QVERIFY(station_device_begin(&device, &config, 0xFFFFF000u));
    std::uint64_t now = 0xFFFFF000u;
    Oracle oracle;
    station_hardware hardware{};
    std::uint16_t sequence = 0;
    std::uint64_t lastValid = 0;
    bool heardAny = false;
    int armedFrames = 0, armings = 0, badFrames = 0, wrong = 0;
    for (int i = 0; i < 1000000; ++i) {
        now += random.below(40) == 0 ? random.below(30000) : random.below(1500);
        if (random.below(2000) == 0)
            now += 600000;
        const auto clock = static_cast<std::uint32_t>(now);
        if (random.below(2) == 0) { // a period
            if (random.below(60) == 0)
                hardware.dead_man = random.below(6) != 0;
            hardware.at_reference = random.below(50) == 0;
            hardware.fault = static_cast<std::uint8_t>(random.below(300) == 0 ? 1 + random.below(8) : 0);
            station_device_advance(&device, clock, &hardware);
            oracle.passTo(now);
            if (hardware.dead_man)
                oracle.held = true;
            else
                oracle.letGoOfTheSwitch();
        }
        // An enabled output mostly; seldom one that disarms, clears or homes; sometimes a bad one.
        station_output output{};
        output.flags = static_cast<std::uint8_t>(
            random.below(12) == 0 ? random.below(16) : STATION_OUTPUT_ENABLE | (random.below(4) << 2));
        const std::uint64_t kind = random.below(20);
        output.sequence =
            static_cast<std::uint16_t>(kind == 0   ? random.next()
                                       : kind == 1 ? sequence
                                                   : sequence + 1 + (kind == 2 ? random.below(9) : 0));
        output.hold_ms = static_cast<std::uint8_t>(1 + random.below(20));
        for (std::int32_t& effort : output.effort)
            effort = static_cast<std::int32_t>(random.next());
        output.display_force_mN = static_cast<std::int16_t>(random.next());
        StationFrame frame{};
        QCOMPARE(station_encode_output(&output, frame.data()), STATION_OK);
        bool valid = true;
        switch (random.below(30)) {
        case 0:
            frame[random.below(64)] ^= static_cast<std::uint8_t>(1u << random.below(8));
            valid = false;
            break;
        case 1:
            frame[0] = static_cast<std::uint8_t>(random.below(2) == 0 ? STATION_FEATURE_REQUEST : 200);
            frame = sealed(frame);
            valid = false;
            break;
        case 2:
            frame[6] = static_cast<std::uint8_t>(random.below(2) == 0 ? 0 : 21 + random.below(235));
            frame = sealed(frame);
            valid = false;
            break;
        case 3:
            fillRandomly(random, frame.data(), frame.size());
            valid = false;
            break;
        default:
            break;
        }
        oracle.passTo(now);
        const bool newer =
            !heardAny || now - lastValid >= STATION_NEW_HOST_US ||
            (output.sequence != sequence && static_cast<std::uint16_t>(output.sequence - sequence) < 0x8000);
        StationFrame reply{};
        const station_received received = station_device_receive(&device, clock, frame.data(), reply.data());
        QCOMPARE(received == STATION_TOOK_OUTPUT, valid && newer);
        badFrames += received == STATION_TOOK_OUTPUT ? 0 : 1;
        // What the oracle does not model (homing, faults) it takes from the device, which other tests hold to
        // it.
        const bool before = oracle.armed;
        oracle.homed = device.referenced;
        oracle.fault = station_device_state(&device) == STATION_FAULT;
        if (oracle.fault && oracle.armed)
            oracle.leaveArmed();
        if (received == STATION_TOOK_OUTPUT) {
            sequence = output.sequence;
            lastValid = now;
            heardAny = true;
            oracle.hear(output);
        }
        armings += oracle.armed && !before ? 1 : 0;
        const bool armed = station_device_state(&device) == STATION_ARMED;
        armedFrames += armed ? 1 : 0;
        wrong += armed != oracle.armed ? 1 : 0;
        if (!armed && anyEffort(device))
            QFAIL(qPrintable(QStringLiteral("an effort in state %1").arg(station_device_state(&device))));
    }
    QCOMPARE(wrong, 0);
    QVERIFY2(armedFrames > 100000 && armings > 1000 && badFrames > 50000,
             qPrintable(QStringLiteral("%1 %2 %3").arg(armedFrames).arg(armings).arg(badFrames)));
}

void TestStationDeviceRandom::effortsStayWithinTheRatings() {
    core::Random random(42);
    const station_device_config config = stationConfig();
    station_device device{};
    QVERIFY(station_device_begin(&device, &config, 0));
    const std::array<std::int64_t, STATION_AXES> limits{4500000, 10000, 2000000000, 0, 0, 0, 0, 0};
    StationFrame reply{};
    for (std::uint16_t i = 0; i < 50000; ++i) {
        station_output output{};
        output.flags = i == 0 ? STATION_OUTPUT_HOME : STATION_OUTPUT_ENABLE;
        output.sequence = i;
        output.hold_ms = 20;
        for (std::int32_t& effort : output.effort)
            effort = static_cast<std::int32_t>(random.next()) >> random.below(32);
        StationFrame frame{};
        QCOMPARE(station_encode_output(&output, frame.data()), STATION_OK);
        QCOMPARE(station_device_receive(&device, i * 1000u, frame.data(), reply.data()), STATION_TOOK_OUTPUT);
        for (std::uint8_t axis = 0; axis < STATION_AXES; ++axis) {
            const std::int64_t limit = i == 0 ? 0 : limits[axis];
            QCOMPARE(std::int64_t(station_device_effort(&device, axis)),
                     std::clamp<std::int64_t>(output.effort[axis], -limit, limit));
        }
    }
}

QTEST_GUILESS_MAIN(TestStationDeviceRandom)
#include "test_station_device_random.moc"
