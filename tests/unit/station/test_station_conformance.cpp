// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/protocol/station_cobs.h"
#include "support/station_conformance.h"
#include "unit/station/station_samples.h"

#include <QtTest>
#include <deque>
#include <functional>

using namespace chiron;
using namespace chiron::test;

namespace {

/// The device in this program; each input that is asked for is a period.
class DeviceOnALine : public StationLine {
public:
    explicit DeviceOnALine(bool serial, std::uint8_t bits = STATION_RENDERS_FORCE | STATION_HOMES_BY_FLAG)
        : m_serial(serial), m_config(stationConfig(bits)) {
        good = station_device_begin(&device, &m_config, m_now);
        station_cobs_begin(&m_decoder);
    }
    bool send(const QList<Frame>& frames) override {
        for (const Frame& frame : frames) {
            if (!m_serial) {
                hear(frame);
                continue;
            }
            std::array<std::uint8_t, STATION_COBS_SIZE> line{};
            station_cobs_encode(frame.data(), line.data());
            sendBytes(QByteArray(reinterpret_cast<const char*>(line.data()), STATION_COBS_SIZE));
        }
        return true;
    }
    bool sendBytes(const QByteArray& bytes) override {
        if (!m_serial)
            return false;
        for (const char byte : bytes) {
            Frame frame{};
            const auto event = station_cobs_take(&m_decoder, static_cast<std::uint8_t>(byte), frame.data());
            if (event == STATION_COBS_FRAME)
                hear(frame);
            if (event == STATION_COBS_BROKEN && countsBroken)
                station_device_broken_block(&device);
        }
        return true;
    }
    bool next(Frame& frame) override {
        if (!m_replies.empty()) {
            frame = m_replies.front();
            m_replies.pop_front();
            return true;
        }
        m_now += hostIsSlow && ++m_inputs % 7 == 0 ? 25000 : 1000;
        const station_hardware hardware{};
        station_device_advance(&device, m_now, &hardware);
        const station_sample sample{};
        station_device_input(&device, &sample, frame.data());
        if (breakInput)
            breakInput(frame);
        return true;
    }

    station_device device{};
    bool good = false;
    bool hostIsSlow = false;
    bool countsBroken = true;
    std::function<void(Frame&)> breakInput; ///< of a station that says what is not
    std::function<bool(Frame&)>
        beforeItIsHeard; ///< of a station that hears what is not; false: it hears nothing

private:
    void hear(Frame frame) {
        if (beforeItIsHeard && !beforeItIsHeard(frame))
            return;
        Frame reply{};
        if (station_device_receive(&device, m_now, frame.data(), reply.data()) == STATION_TOOK_REQUEST)
            m_replies.push_back(reply);
    }

    bool m_serial;
    station_device_config m_config;
    station_cobs m_decoder{};
    std::deque<Frame> m_replies;
    std::uint32_t m_now = 0xFFFE0000u;
    int m_inputs = 0;
};

QString complaint(const std::function<void(DeviceOnALine&)>& spoil, bool serial = false) {
    DeviceOnALine line(serial);
    spoil(line);
    return StationConformance(line).all();
}

} // namespace

class TestStationConformance : public QObject {
    Q_OBJECT
private slots:
    void theDeviceKeepsWhatIsPromised();
    void aSlowHostIsNoComplaint();
    void aStationThatBreaksAPromiseIsFound();
};

void TestStationConformance::theDeviceKeepsWhatIsPromised() {
    for (const bool serial : {false, true}) {
        DeviceOnALine line(serial);
        QVERIFY(line.good);
        StationConformance conformance(line);
        QCOMPARE(conformance.all(), QString());
        QCOMPARE(conformance.axes().size(), 4);
    }
}

void TestStationConformance::aSlowHostIsNoComplaint() {
    DeviceOnALine line(true);
    line.hostIsSlow = true;
    QCOMPARE(StationConformance(line).all(), QString());
}

void TestStationConformance::aStationThatBreaksAPromiseIsFound() {
    const auto found = [](const QString& complaint, const char* where) {
        if (!complaint.startsWith(QLatin1String(where)))
            qWarning("%s", qPrintable(complaint));
        return complaint.startsWith(QLatin1String(where));
    };
    QVERIFY(
        found(complaint([](auto& line) { line.breakInput = [](auto& frame) { frame[0] = 7; }; }), "pages"));
    QVERIFY(
        found(complaint([](auto& line) { line.breakInput = [](auto& frame) { frame[63] ^= 1; }; }), "pages"));
    QVERIFY(found(complaint([](auto& line) {
                      line.breakInput = [](auto& frame) { // its time stands still
                          station_put_u32(frame.data() + 4, 5);
                          station_seal(frame.data());
                      };
                  }),
                  "inputs"));
    QVERIFY(found(complaint([](auto& line) {
                      line.breakInput = [](auto& frame) { // it skips a number
                          frame[2] &= 0xFE;
                          station_seal(frame.data());
                      };
                  }),
                  "inputs"));
    QVERIFY(found(complaint([](auto& line) {
                      line.beforeItIsHeard = [](auto& frame) { // it does not home
                          frame[1] &= static_cast<std::uint8_t>(
                              frame[0] == STATION_OUTPUT ? ~STATION_OUTPUT_HOME : 0xFF);
                          station_seal(frame.data());
                          return true;
                      };
                  }),
                  "homing"));
    QVERIFY(found(complaint([](auto& line) {
                      line.breakInput = [&line](auto&) {
                          line.device.may_arm = true;
                      }; // arms by enable alone
                  }),
                  "arming"));
    QVERIFY(found(complaint([](auto& line) {
                      line.breakInput = [&line](auto&) { // holds on as long as it likes
                          if (line.device.state == STATION_ARMED)
                              line.device.age_us = 0;
                      };
                  }),
                  "arming"));
    QVERIFY(found(complaint([](auto& line) {
                      line.breakInput = [&line](auto&) { // a millisecond longer
                          if (line.device.state == STATION_ARMED && line.device.hold_ms == 5)
                              line.device.hold_ms = 6;
                      };
                  }),
                  "hold time"));
    QVERIFY(found(complaint([](auto& line) {
                      line.beforeItIsHeard = [](auto& frame) { // checks no CRC
                          station_seal(frame.data());
                          return true;
                      };
                  }),
                  "bad frames"));
    QVERIFY(found(complaint([](auto& line) {
                      line.beforeItIsHeard = [&line](auto&) { // takes any number
                          line.device.has_sequence = false;
                          return true;
                      };
                  }),
                  "bad frames"));
    QVERIFY(found(complaint([](auto& line) {
                      line.breakInput = [&line](auto&) { line.device.counters.lost_outputs = 0; };
                  }),
                  "lost frames"));
    QVERIFY(found(complaint([](auto& line) {
                      line.breakInput = [](auto& frame) {
                          frame[59] &= static_cast<std::uint8_t>(~STATION_STATUS_AT_LIMIT);
                          station_seal(frame.data());
                      };
                  }),
                  "limits"));
    QVERIFY(found(complaint([](auto& line) { line.countsBroken = false; }, true), "serial line"));
}

QTEST_GUILESS_MAIN(TestStationConformance)
#include "test_station_conformance.moc"
