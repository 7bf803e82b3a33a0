// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/station/station_samples.h"

#include <QtTest>
#include <cmath>
#include <cstring>
#include <limits>

using namespace chiron;
using namespace chiron::test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Characters of one to four bytes, at most `size` of them in all.
QByteArray randomText(core::Random& random, int size) {
    QByteArray text;
    while (random.below(12) != 0) {
        const std::uint32_t most[] = {0x7E, 0x7FF, 0xD7FF, 0x10FFFF};
        const auto code = static_cast<char32_t>(0x20 + random.below(most[random.below(4)] - 0x20 + 1));
        if ((code >= 0x7F && code < 0xA0) || (code >= 0xD800 && code <= 0xDFFF))
            continue;
        const QByteArray character = QString::fromUcs4(&code, 1).toUtf8();
        if (text.size() + character.size() > size)
            break;
        text += character;
    }
    return text;
}

void put(char* at, const QByteArray& text) {
    std::memcpy(at, text.constData(), static_cast<std::size_t>(text.size()) + 1);
}

} // namespace

class TestStationFeatures : public QObject {
    Q_OBJECT
private slots:
    void requestsComeBack();
    void repliesHaveTheirBytes();
    void pagesComeBack();
    void axesAndParametersComeBack();
    void anotherPageIsRefused();
    void badIdentitiesAreRefused();
    void badAxesAreRefused();
    void badTextsAreRefused();
    void textsThatFillTheirRoomPass();
    void noBytesBreakADecoder();
    void theCalibrationsCrcIsThatOfItsPages();
};

void TestStationFeatures::requestsComeBack() {
    for (int page = 0; page < 256; ++page) {
        StationFrame frame{};
        QCOMPARE(station_encode_feature_request(static_cast<std::uint8_t>(page), frame.data()), STATION_OK);
        std::uint8_t back = 0;
        QCOMPARE(station_decode_feature_request(frame.data(), &back), STATION_OK);
        QCOMPARE(int(back), page);
        std::uint8_t status = 7;
        station_encode_no_page(static_cast<std::uint8_t>(page), frame.data());
        QCOMPARE(station_decode_feature_head(frame.data(), &back, &status), STATION_OK);
        QCOMPARE(int(back), page);
        QCOMPARE(int(status), int(STATION_NO_SUCH_PAGE));
    }
    StationFrame frame{};
    station_encode_no_page(9, frame.data());
    for (int status = 2; status < 256; ++status) {
        frame[2] = static_cast<std::uint8_t>(status);
        std::uint8_t page = 0, back = 0;
        QCOMPARE(station_decode_feature_head(sealed(frame).data(), &page, &back), STATION_BAD_VALUE);
    }
}

void TestStationFeatures::repliesHaveTheirBytes() {
    StationFrame frame{};
    const station_identity identity{
        1, 0, 5, STATION_RENDERS_FORCE | STATION_HAS_JAW, 1000, 3000, 4.5f, 0.25f, 24.0f, 0.5, 6};
    QCOMPARE(station_encode_identity(&identity, frame.data()), STATION_OK);
    QCOMPARE(hexOf(frame), hexOf(sealed(frameOfHex("04 00 00 00 01 00 05 09 e8 03 00 00 b8 0b 00 00"
                                                   "00 00 90 40 00 00 80 3e 00 00 c0 41 00 00 00 00"
                                                   "00 00 e0 3f 06 00 00 00 00 00 00 00 00 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"))));
    station_names names{"Alpha", "S-1"};
    QCOMPARE(station_encode_names(&names, frame.data()), STATION_OK);
    QCOMPARE(hexOf(frame), hexOf(sealed(frameOfHex("04 01 00 00 41 6c 70 68 61 00 00 00 00 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                                   "53 2d 31 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"))));
    station_kinematics kinematics{"cartesian", "f1"};
    QCOMPARE(station_encode_kinematics(&kinematics, frame.data()), STATION_OK);
    QCOMPARE(hexOf(frame), hexOf(sealed(frameOfHex("04 02 00 00 63 61 72 74 65 73 69 61 6e 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 66 31 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"))));
    station_calibration calibration{0x01020304, 0x0A0B0C0D, "E"};
    QCOMPARE(station_encode_calibration(&calibration, frame.data()), STATION_OK);
    QCOMPARE(hexOf(frame), hexOf(sealed(frameOfHex("04 03 00 00 04 03 02 01 0d 0c 0b 0a 45 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"))));
    const station_counters counters{1, 2, 3, 4, 5, 6, 7};
    QCOMPARE(station_encode_counters(&counters, frame.data()), STATION_OK);
    QCOMPARE(hexOf(frame), hexOf(sealed(frameOfHex("04 04 00 00 01 00 00 00 02 00 00 00 03 00 00 00"
                                                   "04 00 00 00 05 00 00 00 06 00 00 00 07 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"))));
    station_axis axis{0.5, -1.0, 2.0, 4.0f, 0.25f, 0.125f, STATION_RADIAN, "pitch"};
    QCOMPARE(station_encode_axis(7, &axis, frame.data()), STATION_OK);
    QCOMPARE(hexOf(frame), hexOf(sealed(frameOfHex("04 17 00 00 00 00 00 00 00 00 e0 3f 00 00 00 00"
                                                   "00 00 f0 bf 00 00 00 00 00 00 00 40 00 00 80 40"
                                                   "00 00 80 3e 00 00 00 3e 01 70 69 74 63 68 00 00"
                                                   "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"))));
    station_parameters parameters{{1.0, 2.0, -1.0, 0.5, 0.0, 4.0}};
    QCOMPARE(station_encode_parameters(7, &parameters, frame.data()), STATION_OK);
    QCOMPARE(hexOf(frame), hexOf(sealed(frameOfHex("04 27 00 00 00 00 00 00 00 00 f0 3f 00 00 00 00"
                                                   "00 00 00 40 00 00 00 00 00 00 f0 bf 00 00 00 00"
                                                   "00 00 e0 3f 00 00 00 00 00 00 00 00 00 00 00 00"
                                                   "00 00 10 40 00 00 00 00 00 00 00 00 00 00 00 00"))));
}

void TestStationFeatures::pagesComeBack() {
    core::Random random(21);
    for (int i = 0; i < 5000; ++i) {
        StationFrame frame{};
        station_identity identity{};
        identity.major = static_cast<std::uint8_t>(random.next());
        identity.minor = static_cast<std::uint8_t>(random.next());
        identity.axes = static_cast<std::uint8_t>(1 + random.below(8));
        identity.bits = static_cast<std::uint8_t>(random.below(128));
        identity.period_us = static_cast<std::uint32_t>(1 + random.below(0xFFFFFFFF));
        identity.oldest_sample_us = static_cast<std::uint32_t>(random.next());
        identity.max_force_N = static_cast<float>(random.uniform(0.0, 100.0));
        identity.max_torque_Nm = static_cast<float>(random.uniform());
        identity.max_damping_Ns_per_m = static_cast<float>(random.uniform(0.0, 1e9));
        identity.jaw_count_rad = random.uniform();
        identity.parameters = static_cast<std::uint8_t>(random.below(49));
        QCOMPARE(station_encode_identity(&identity, frame.data()), STATION_OK);
        station_identity id{};
        QCOMPARE(station_decode_identity(frame.data(), &id), STATION_OK);
        QVERIFY(id.major == identity.major && id.minor == identity.minor && id.axes == identity.axes &&
                id.bits == identity.bits && id.period_us == identity.period_us &&
                id.oldest_sample_us == identity.oldest_sample_us && id.max_force_N == identity.max_force_N &&
                id.max_torque_Nm == identity.max_torque_Nm &&
                id.max_damping_Ns_per_m == identity.max_damping_Ns_per_m &&
                id.jaw_count_rad == identity.jaw_count_rad && id.parameters == identity.parameters);

        station_names names{}, namesBack{};
        put(names.model, randomText(random, 28));
        put(names.serial_number, randomText(random, 28));
        QCOMPARE(station_encode_names(&names, frame.data()), STATION_OK);
        QCOMPARE(station_decode_names(frame.data(), &namesBack), STATION_OK);
        QCOMPARE(QByteArray(namesBack.model), QByteArray(names.model));
        QCOMPARE(QByteArray(namesBack.serial_number), QByteArray(names.serial_number));

        station_kinematics kinematics{}, kinematicsBack{};
        put(kinematics.id, randomText(random, 24));
        put(kinematics.firmware, randomText(random, 28));
        QCOMPARE(station_encode_kinematics(&kinematics, frame.data()), STATION_OK);
        QCOMPARE(station_decode_kinematics(frame.data(), &kinematicsBack), STATION_OK);
        QCOMPARE(QByteArray(kinematicsBack.id), QByteArray(kinematics.id));
        QCOMPARE(QByteArray(kinematicsBack.firmware), QByteArray(kinematics.firmware));

        station_calibration calibration{}, calibrationBack{};
        calibration.unix_time = static_cast<std::uint32_t>(random.next());
        calibration.crc32 = static_cast<std::uint32_t>(random.next());
        put(calibration.by_whom, randomText(random, 24));
        QCOMPARE(station_encode_calibration(&calibration, frame.data()), STATION_OK);
        QCOMPARE(station_decode_calibration(frame.data(), &calibrationBack), STATION_OK);
        QCOMPARE(calibrationBack.unix_time, calibration.unix_time);
        QCOMPARE(calibrationBack.crc32, calibration.crc32);
        QCOMPARE(QByteArray(calibrationBack.by_whom), QByteArray(calibration.by_whom));

        station_counters counters{}, countersBack{};
        fillRandomly(random, &counters, sizeof counters);
        QCOMPARE(station_encode_counters(&counters, frame.data()), STATION_OK);
        QCOMPARE(station_decode_counters(frame.data(), &countersBack), STATION_OK);
        QVERIFY(std::memcmp(&counters, &countersBack, sizeof counters) == 0);
    }
}

void TestStationFeatures::axesAndParametersComeBack() {
    core::Random random(22);
    for (int i = 0; i < 5000; ++i) {
        StationFrame frame{};
        const auto index = static_cast<std::uint8_t>(random.below(8));
        station_axis axis{}, axisBack{};
        axis.count_size = random.uniform(1e-9, 1.0);
        axis.minimum = random.uniform(-3.0, 0.0);
        axis.maximum = random.uniform(0.0, 3.0);
        axis.rating = static_cast<float>(random.uniform(0.0, 10.0));
        axis.coulomb = static_cast<float>(random.uniform());
        axis.viscous = static_cast<float>(random.uniform());
        axis.unit = static_cast<std::uint8_t>(random.below(2));
        put(axis.id, randomText(random, 13));
        QCOMPARE(station_encode_axis(index, &axis, frame.data()), STATION_OK);
        QCOMPARE(station_decode_axis(frame.data(), index, &axisBack), STATION_OK);
        QVERIFY(axisBack.count_size == axis.count_size && axisBack.minimum == axis.minimum &&
                axisBack.maximum == axis.maximum && axisBack.rating == axis.rating &&
                axisBack.coulomb == axis.coulomb && axisBack.viscous == axis.viscous &&
                axisBack.unit == axis.unit);
        QCOMPARE(QByteArray(axisBack.id), QByteArray(axis.id));

        station_parameters parameters{}, parametersBack{};
        for (double& each : parameters.values)
            each = random.normal() * std::pow(10.0, random.uniform(-300.0, 300.0));
        QCOMPARE(station_encode_parameters(index, &parameters, frame.data()), STATION_OK);
        QCOMPARE(station_decode_parameters(frame.data(), index, &parametersBack), STATION_OK);
        QVERIFY(std::memcmp(&parameters, &parametersBack, sizeof parameters) == 0);
    }
}

void TestStationFeatures::anotherPageIsRefused() {
    const station_device_config config = stationConfig();
    StationFrame frame{};
    station_axis axis{};
    QCOMPARE(station_encode_axis(2, &config.axes[2], frame.data()), STATION_OK);
    for (std::uint8_t index = 0; index < 12; ++index)
        QCOMPARE(station_decode_axis(frame.data(), index, &axis), index == 2 ? STATION_OK : STATION_BAD_TYPE);
    station_names names{};
    station_identity identity{};
    station_kinematics kinematics{};
    station_calibration calibration{};
    station_counters counters{};
    station_parameters parameters{};
    QCOMPARE(station_decode_names(frame.data(), &names), STATION_BAD_TYPE);
    QCOMPARE(station_decode_identity(frame.data(), &identity), STATION_BAD_TYPE);
    QCOMPARE(station_decode_kinematics(frame.data(), &kinematics), STATION_BAD_TYPE);
    QCOMPARE(station_decode_calibration(frame.data(), &calibration), STATION_BAD_TYPE);
    QCOMPARE(station_decode_counters(frame.data(), &counters), STATION_BAD_TYPE);
    QCOMPARE(station_decode_parameters(frame.data(), 2, &parameters), STATION_BAD_TYPE);
    station_encode_no_page(STATION_PAGE_AXIS + 2, frame.data());
    QCOMPARE(station_decode_axis(frame.data(), 2, &axis), STATION_BAD_TYPE);
    frame[20] ^= 1;
    QCOMPARE(station_decode_axis(frame.data(), 2, &axis), STATION_BAD_CRC);
    // Beyond what there may be.
    QCOMPARE(station_encode_axis(8, &config.axes[0], frame.data()), STATION_BAD_VALUE);
    QCOMPARE(station_encode_parameters(8, &config.parameters[0], frame.data()), STATION_BAD_VALUE);
}

void TestStationFeatures::badIdentitiesAreRefused() {
    const station_identity good = stationConfig().identity;
    StationFrame frame{};
    QCOMPARE(station_encode_identity(&good, frame.data()), STATION_OK);
    const auto refused = [&](auto change) {
        station_identity bad = good;
        change(bad);
        StationFrame written{};
        return station_encode_identity(&bad, written.data()) == STATION_BAD_VALUE &&
               written == StationFrame{};
    };
    QVERIFY(refused([](auto& i) { i.axes = 0; }));
    QVERIFY(refused([](auto& i) { i.axes = 9; }));
    QVERIFY(refused([](auto& i) { i.period_us = 0; }));
    QVERIFY(refused([](auto& i) { i.max_force_N = -1.0f; }));
    QVERIFY(refused([](auto& i) { i.max_force_N = static_cast<float>(kNan); }));
    QVERIFY(refused([](auto& i) { i.max_torque_Nm = static_cast<float>(kInfinity); }));
    QVERIFY(refused([](auto& i) { i.max_damping_Ns_per_m = -0.5f; }));
    QVERIFY(refused([](auto& i) { i.jaw_count_rad = kNan; }));
    QVERIFY(refused([](auto& i) { i.jaw_count_rad = -1e-3; }));
    QVERIFY(refused([](auto& i) { i.parameters = 49; }));
    // The decoder refuses the same bytes.
    const auto changed = [&](std::size_t at, std::uint8_t to) {
        StationFrame bad = frame;
        bad[at] = to;
        station_identity out{};
        return station_decode_identity(sealed(bad).data(), &out);
    };
    QCOMPARE(changed(6, 0), STATION_BAD_VALUE);
    QCOMPARE(changed(6, 9), STATION_BAD_VALUE);
    QCOMPARE(changed(19, 0xFF), STATION_BAD_VALUE);
    QCOMPARE(changed(36, 49), STATION_BAD_VALUE);
    QCOMPARE(changed(4, 2), STATION_OK);     // another major version is the host's business
    QCOMPARE(changed(7, 0xFF), STATION_OK);  // a bit of a later version
    QCOMPARE(changed(50, 0xFF), STATION_OK); // a value of a later version
}

void TestStationFeatures::badAxesAreRefused() {
    const station_axis good = stationConfig().axes[1];
    const auto refused = [&](auto change) {
        station_axis bad = good;
        change(bad);
        StationFrame written{};
        return station_encode_axis(1, &bad, written.data()) == STATION_BAD_VALUE && written == StationFrame{};
    };
    QVERIFY(!refused([](auto&) {}));
    QVERIFY(refused([](auto& a) { a.count_size = 0.0; }));
    QVERIFY(refused([](auto& a) { a.count_size = -1e-6; }));
    QVERIFY(refused([](auto& a) { a.count_size = kNan; }));
    QVERIFY(refused([](auto& a) { a.minimum = -kInfinity; }));
    QVERIFY(refused([](auto& a) { a.maximum = kNan; }));
    QVERIFY(refused([](auto& a) { a.minimum = a.maximum + 1.0; }));
    QVERIFY(refused([](auto& a) { a.rating = -1.0f; }));
    QVERIFY(refused([](auto& a) { a.coulomb = static_cast<float>(kNan); }));
    QVERIFY(refused([](auto& a) { a.viscous = static_cast<float>(kInfinity); }));
    QVERIFY(refused([](auto& a) { a.unit = 2; }));
    QVERIFY(refused([](auto& a) { std::strcpy(a.id, "x\n"); }));
    station_parameters parameters{{0.0, 0.0, 0.0, 0.0, 0.0, kNan}};
    StationFrame frame{};
    QCOMPARE(station_encode_parameters(0, &parameters, frame.data()), STATION_BAD_VALUE);
    parameters.values[5] = 0.0;
    QCOMPARE(station_encode_parameters(0, &parameters, frame.data()), STATION_OK);
    station_put_f64(frame.data() + 44, kInfinity);
    QCOMPARE(station_decode_parameters(sealed(frame).data(), 0, &parameters), STATION_BAD_VALUE);
}

void TestStationFeatures::badTextsAreRefused() {
    const char* const bad[] = {
        "\x80",             // nothing that begins here
        "a\xC3",            // cut
        "\xC3(",            // no second byte
        "\xC0\x80",         // a 0 in two bytes
        "\xC1\xBF",         // one byte in two
        "\xE0\x9F\xBF",     // two bytes in three
        "\xED\xA0\x80",     // half of a pair of UTF-16
        "\xF0\x8F\xBF\xBF", // three bytes in four
        "\xF4\x90\x80\x80", // beyond Unicode
        "\xF5\x80\x80\x80",
        "\xFF",
        "tab\t",
        "\x1B[2J",
        "\x7F",
        "\xC2\x9B",     // a control character of the second kind
        "\xC3\xC3\xB6", // ö after half of one
    };
    for (const char* text : bad) {
        station_names names{"m", "s"};
        std::strcpy(names.serial_number, text);
        StationFrame frame{};
        QVERIFY2(station_encode_names(&names, frame.data()) == STATION_BAD_VALUE, text);
        station_names good{"m", "s"}, read{};
        QCOMPARE(station_encode_names(&good, frame.data()), STATION_OK);
        std::memcpy(frame.data() + 32, text, std::strlen(text));
        QCOMPARE(station_decode_names(sealed(frame).data(), &read), STATION_BAD_VALUE);
        QVERIFY(station_encode_names(&good, frame.data()) == STATION_OK);
        std::memcpy(frame.data() + 4, text, std::strlen(text));
        QCOMPARE(station_decode_names(sealed(frame).data(), &read), STATION_BAD_VALUE);
    }
    station_names good{"model", "serial"}, read{};
    StationFrame frame{};
    QCOMPARE(station_encode_names(&good, frame.data()), STATION_OK);
    frame[4 + 20] = 'x'; // goes on after its 0
    QCOMPARE(station_decode_names(sealed(frame).data(), &read), STATION_BAD_VALUE);
    station_calibration calibration{};
    StationFrame person{};
    QCOMPARE(station_encode_calibration(&calibration, person.data()), STATION_OK);
    person[12] = 0x07;
    QCOMPARE(station_decode_calibration(sealed(person).data(), &calibration), STATION_BAD_VALUE);
    station_kinematics kinematics{};
    StationFrame version{};
    QCOMPARE(station_encode_kinematics(&kinematics, version.data()), STATION_OK);
    version[28] = 0x07;
    QCOMPARE(station_decode_kinematics(sealed(version).data(), &kinematics), STATION_BAD_VALUE);
}

void TestStationFeatures::textsThatFillTheirRoomPass() {
    station_names names{}, back{};
    std::memset(names.model, 'm', 28);
    std::memset(names.serial_number, '9', 28);
    StationFrame frame{};
    QCOMPARE(station_encode_names(&names, frame.data()), STATION_OK);
    QCOMPARE(station_decode_names(frame.data(), &back), STATION_OK);
    QCOMPARE(QByteArray(back.model), QByteArray(28, 'm'));
    QCOMPARE(QByteArray(back.serial_number), QByteArray(28, '9'));
    std::memset(names.model, 'm', 29); // no 0 at its end
    QCOMPARE(station_encode_names(&names, frame.data()), STATION_BAD_VALUE);
    std::memset(names.model, 0, 29);
    std::memset(names.model, 'm', 27);
    std::memcpy(names.model + 26, "\xE2\x82", 2); // the euro's third byte would be the next text's first
    QCOMPARE(station_encode_names(&names, frame.data()), STATION_BAD_VALUE);
}

void TestStationFeatures::noBytesBreakADecoder() {
    core::Random random(23);
    int good = 0;
    for (int i = 0; i < 200000; ++i) {
        StationFrame frame{};
        fillRandomly(random, frame.data(), frame.size());
        frame[0] = STATION_FEATURE_REPLY;
        const std::uint8_t pages[] = {0, 1, 2, 3, 4, 16, 17, 23, 32, 39};
        frame[1] = pages[random.below(10)];
        frame[2] = 0;
        for (std::size_t at = 4; at < 62; ++at)
            if (random.below(2) == 0)
                frame[at] = 0;
        frame = sealed(frame);
        station_identity identity{};
        station_names names{};
        station_kinematics kinematics{};
        station_calibration calibration{};
        station_counters counters{};
        station_axis axis{};
        station_parameters parameters{};
        StationFrame again{};
        const auto written = [&](station_result result) {
            good += result == STATION_OK ? 1 : 0;
            return result == STATION_OK;
        };
        const auto index = static_cast<std::uint8_t>(frame[1] & 7); // what is read can be written again
        if (written(station_decode_identity(frame.data(), &identity)))
            QCOMPARE(station_encode_identity(&identity, again.data()), STATION_OK);
        if (written(station_decode_names(frame.data(), &names)))
            QCOMPARE(station_encode_names(&names, again.data()), STATION_OK);
        if (written(station_decode_kinematics(frame.data(), &kinematics)))
            QCOMPARE(station_encode_kinematics(&kinematics, again.data()), STATION_OK);
        if (written(station_decode_calibration(frame.data(), &calibration)))
            QCOMPARE(station_encode_calibration(&calibration, again.data()), STATION_OK);
        if (written(station_decode_counters(frame.data(), &counters)))
            QCOMPARE(station_encode_counters(&counters, again.data()), STATION_OK);
        if (written(station_decode_axis(frame.data(), index, &axis)))
            QCOMPARE(station_encode_axis(index, &axis, again.data()), STATION_OK);
        if (written(station_decode_parameters(frame.data(), index, &parameters)))
            QCOMPARE(station_encode_parameters(index, &parameters, again.data()), STATION_OK);
    }
    QVERIFY(good > 10000);
}

void TestStationFeatures::theCalibrationsCrcIsThatOfItsPages() {
    const station_device_config config = stationConfig();
    QByteArray bytes;
    StationFrame frame{};
    for (std::uint8_t i = 0; i < 4; ++i) {
        QCOMPARE(station_encode_axis(i, &config.axes[i], frame.data()), STATION_OK);
        bytes += QByteArray(reinterpret_cast<char*>(frame.data()) + 4, 58);
    }
    for (std::uint8_t i = 0; i < 2; ++i) {
        QCOMPARE(station_encode_parameters(i, &config.parameters[i], frame.data()), STATION_OK);
        bytes += QByteArray(reinterpret_cast<char*>(frame.data()) + 4, 58);
    }
    const auto* const at = reinterpret_cast<const std::uint8_t*>(bytes.constData());
    QCOMPARE(config.calibration.crc32, station_crc32(0, at, static_cast<std::size_t>(bytes.size())));
    station_axis bad = config.axes[0];
    bad.count_size = 0.0;
    QCOMPARE(station_calibration_crc32(&bad, 1, config.parameters, 0), 0u);
}

QTEST_GUILESS_MAIN(TestStationFeatures)
#include "test_station_features.moc"
