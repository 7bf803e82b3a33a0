// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/station/station_samples.h"

#include <QtTest>
#include <cstring>
#include <limits>

using namespace chiron;
using namespace chiron::test;

/// The bytes of docs/station-protocol.md.
class TestStationFrame : public QObject {
    Q_OBJECT
private slots:
    void crcIsTheNamedOne();
    void sequenceNumbersWrap();
    void inputHasItsBytes();
    void outputHasItsBytes();
    void numbersKeepTheirBits();
    void inputsComeBack();
    void outputsComeBack();
    void everyFlippedBitIsNoticed();
    void aTypeThatIsNotMeantIsRefused();
    void holdIsOneToTwenty();
    void anInputThatContradictsItselfIsRefused();
    void reservedBytesAreIgnored();
    void aRefusedFrameChangesNothing();
};

void TestStationFrame::crcIsTheNamedOne() {
    const auto* const check = reinterpret_cast<const std::uint8_t*>("123456789");
    QCOMPARE(station_crc16(check, 9), std::uint16_t(0x29B1));
    QCOMPARE(station_crc16(check, 0), std::uint16_t(0xFFFF));
    QCOMPARE(station_crc32(0, check, 9), std::uint32_t(0xCBF43926));
    QCOMPARE(station_crc32(station_crc32(0, check, 4), check + 4, 5), std::uint32_t(0xCBF43926));
    core::Random random(1);
    for (int i = 0; i < 1000; ++i) { // against the definition, bit by bit
        std::uint8_t bytes[20];
        fillRandomly(random, bytes, sizeof bytes);
        const std::size_t count = random.below(sizeof bytes + 1);
        std::uint16_t crc = 0xFFFF;
        for (std::size_t at = 0; at < count; ++at)
            for (int bit = 7; bit >= 0; --bit) {
                const bool one = ((crc >> 15) ^ (bytes[at] >> bit)) & 1;
                crc = static_cast<std::uint16_t>((crc << 1) ^ (one ? 0x1021 : 0));
            }
        QCOMPARE(station_crc16(bytes, count), crc);
    }
}

void TestStationFrame::sequenceNumbersWrap() {
    for (const std::uint32_t from : {0u, 1u, 0x7FFFu, 0x8000u, 0xFFFEu, 0xFFFFu}) {
        const auto last = static_cast<std::uint16_t>(from);
        for (std::uint32_t ahead = 0; ahead < 0x10000u; ++ahead) {
            const auto next = static_cast<std::uint16_t>(from + ahead);
            QCOMPARE(station_newer(next, last), ahead >= 1 && ahead < 0x8000u);
            if (ahead > 0)
                QCOMPARE(station_gap(next, last), static_cast<std::uint16_t>(ahead - 1));
        }
    }
}

void TestStationFrame::inputHasItsBytes() {
    station_input input{};
    input.flags = STATION_INPUT_DEAD_MAN | STATION_INPUT_ARMED | STATION_INPUT_HOMED | 0x50;
    input.sequence = 0x1234;
    input.time_us = 0xDEADBEEF;
    for (int i = 0; i < 8; ++i)
        input.counts[i] = i % 2 == 0 ? i + 1 : -(i + 1);
    input.counts[7] = std::numeric_limits<std::int32_t>::min();
    input.jaw = -2;
    for (int i = 0; i < 6; ++i)
        input.wrench[i] = static_cast<std::int16_t>(256 * (i + 1) + i);
    input.wrench[5] = -1;
    input.applied_sequence = 0xABCD;
    input.applied_age_ms = 7;
    input.state = STATION_ARMED;
    input.fault = 0;
    input.status = STATION_STATUS_WRENCH_VALID | STATION_STATUS_AT_LIMIT;
    input.supply_mV = 24000;
    StationFrame frame{};
    QCOMPARE(station_encode_input(&input, frame.data()), STATION_OK);
    const StationFrame byHand = sealed(frameOfHex("01 5b 34 12 ef be ad de 01 00 00 00 fe ff ff ff"
                                                  "03 00 00 00 fc ff ff ff 05 00 00 00 fa ff ff ff"
                                                  "07 00 00 00 00 00 00 80 fe ff 00 01 01 02 02 03"
                                                  "03 04 04 05 ff ff cd ab 07 02 00 03 c0 5d 00 00"));
    QCOMPARE(hexOf(frame), hexOf(byHand));
    QCOMPARE(frame[62], std::uint8_t(station_crc16(frame.data(), 62) & 0xFF)); // the low byte first
}

void TestStationFrame::outputHasItsBytes() {
    station_output output{};
    output.flags = STATION_OUTPUT_ENABLE | STATION_OUTPUT_DISPLAY;
    output.sequence = 0xFFFF;
    output.answered_sequence = 0x0102;
    output.hold_ms = 20;
    output.effort[0] = 4500000;
    output.effort[1] = -1;
    output.effort[7] = std::numeric_limits<std::int32_t>::max();
    output.display_force_mN = 1000;
    output.display_pitch_1e4_rad = -5236;
    output.display_roll_1e4_rad = 3491;
    StationFrame frame{};
    frame.fill(0xEE); // reserved bytes are written, too
    QCOMPARE(station_encode_output(&output, frame.data()), STATION_OK);
    const StationFrame byHand = sealed(frameOfHex("02 05 ff ff 02 01 14 00 20 aa 44 00 ff ff ff ff"
                                                  "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                                  "00 00 00 00 ff ff ff 7f e8 03 8c eb a3 0d 00 00"
                                                  "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"));
    QCOMPARE(hexOf(frame), hexOf(byHand));
}

void TestStationFrame::numbersKeepTheirBits() {
    std::uint8_t at[8];
    station_put_f64(at, 1.0);
    QCOMPARE(QByteArray(reinterpret_cast<char*>(at), 8).toHex(), QByteArray("000000000000f03f"));
    station_put_f32(at, -2.5f);
    QCOMPARE(QByteArray(reinterpret_cast<char*>(at), 4).toHex(), QByteArray("000020c0"));
    core::Random random(2);
    for (int i = 0; i < 1000; ++i) {
        std::uint8_t bytes[8], back[8];
        fillRandomly(random, bytes, 8);
        station_put_f64(back, station_get_f64(bytes));
        if (std::isfinite(station_get_f64(bytes))) // what is no number may change its payload
            QVERIFY(std::memcmp(bytes, back, 8) == 0);
        station_put_f32(back, station_get_f32(bytes));
        if (std::isfinite(station_get_f32(bytes)))
            QVERIFY(std::memcmp(bytes, back, 4) == 0);
        station_put_u32(back, static_cast<std::uint32_t>(station_get_i32(bytes)));
        QVERIFY(std::memcmp(bytes, back, 4) == 0);
        station_put_u16(back, static_cast<std::uint16_t>(station_get_i16(bytes)));
        QVERIFY(std::memcmp(bytes, back, 2) == 0);
    }
}

void TestStationFrame::inputsComeBack() {
    core::Random random(3);
    for (int i = 0; i < 20000; ++i) {
        station_input input{};
        fillRandomly(random, &input, sizeof input); // padding, too: compared field by field
        input.state = static_cast<std::uint8_t>(random.below(4));
        input.status &= 0x07;
        input.flags &= static_cast<std::uint8_t>(~0x06u);
        input.flags |= input.state == STATION_ARMED ? STATION_INPUT_ARMED : 0;
        input.flags |= input.state == STATION_FAULT ? STATION_INPUT_FAULT : 0;
        if (input.state != STATION_FAULT)
            input.flags =
                static_cast<std::uint8_t>((input.flags & ~STATION_INPUT_HOMED) |
                                          (input.state != STATION_UNKNOWN ? STATION_INPUT_HOMED : 0));
        StationFrame frame{};
        QCOMPARE(station_encode_input(&input, frame.data()), STATION_OK);
        station_input back{};
        QCOMPARE(station_decode_input(frame.data(), &back), STATION_OK);
        QCOMPARE(back.flags, input.flags);
        QCOMPARE(back.sequence, input.sequence);
        QCOMPARE(back.time_us, input.time_us);
        QVERIFY(std::memcmp(back.counts, input.counts, sizeof back.counts) == 0);
        QCOMPARE(back.jaw, input.jaw);
        QVERIFY(std::memcmp(back.wrench, input.wrench, sizeof back.wrench) == 0);
        QCOMPARE(back.applied_sequence, input.applied_sequence);
        QCOMPARE(back.applied_age_ms, input.applied_age_ms);
        QCOMPARE(back.state, input.state);
        QCOMPARE(back.fault, input.fault);
        QCOMPARE(back.status, input.status);
        QCOMPARE(back.supply_mV, input.supply_mV);
        StationFrame again{};
        QCOMPARE(station_encode_input(&back, again.data()), STATION_OK);
        QCOMPARE(again, frame);
    }
}

void TestStationFrame::outputsComeBack() {
    core::Random random(4);
    for (int i = 0; i < 20000; ++i) {
        station_output output{};
        fillRandomly(random, output.effort, sizeof output.effort);
        output.flags = static_cast<std::uint8_t>(random.below(16));
        output.sequence = static_cast<std::uint16_t>(random.next());
        output.answered_sequence = static_cast<std::uint16_t>(random.next());
        output.hold_ms = static_cast<std::uint8_t>(1 + random.below(20));
        const bool display = (output.flags & STATION_OUTPUT_DISPLAY) != 0;
        output.display_force_mN = static_cast<std::int16_t>(random.next());
        output.display_pitch_1e4_rad = static_cast<std::int16_t>(random.next());
        output.display_roll_1e4_rad = static_cast<std::int16_t>(random.next());
        StationFrame frame{};
        QCOMPARE(station_encode_output(&output, frame.data()), STATION_OK);
        station_output back{};
        QCOMPARE(station_decode_output(frame.data(), &back), STATION_OK);
        QCOMPARE(back.flags, output.flags);
        QCOMPARE(back.sequence, output.sequence);
        QCOMPARE(back.answered_sequence, output.answered_sequence);
        QCOMPARE(back.hold_ms, output.hold_ms);
        QVERIFY(std::memcmp(back.effort, output.effort, sizeof back.effort) == 0);
        QCOMPARE(back.display_force_mN, display ? output.display_force_mN : std::int16_t(0));
        QCOMPARE(back.display_pitch_1e4_rad, display ? output.display_pitch_1e4_rad : std::int16_t(0));
        QCOMPARE(back.display_roll_1e4_rad, display ? output.display_roll_1e4_rad : std::int16_t(0));
    }
}

void TestStationFrame::everyFlippedBitIsNoticed() {
    const StationFrame frame = outputFrame(7, STATION_OUTPUT_ENABLE, 10, 1234567);
    for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
        StationFrame one = frame;
        one[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        QCOMPARE(station_check_crc(one.data()), STATION_BAD_CRC);
        for (std::size_t other = bit + 1; other < 8 * frame.size(); ++other) { // any two, too
            StationFrame two = one;
            two[other / 8] ^= static_cast<std::uint8_t>(1u << (other % 8));
            if (station_check_crc(two.data()) != STATION_BAD_CRC)
                QFAIL(qPrintable(QStringLiteral("bits %1 and %2").arg(bit).arg(other)));
        }
    }
    station_output output{};
    StationFrame one = frame;
    one[0] ^= 1; // the CRC is looked at first
    QCOMPARE(station_decode_output(one.data(), &output), STATION_BAD_CRC);
}

void TestStationFrame::aTypeThatIsNotMeantIsRefused() {
    for (int type = 0; type < 256; ++type) {
        StationFrame frame = outputFrame(1, 0);
        frame[0] = static_cast<std::uint8_t>(type);
        frame = sealed(frame);
        QCOMPARE(station_frame_type(frame.data()), static_cast<std::uint8_t>(type));
        station_output output{};
        QCOMPARE(station_decode_output(frame.data(), &output),
                 type == STATION_OUTPUT ? STATION_OK : STATION_BAD_TYPE);
        station_input input{};
        QCOMPARE(station_decode_input(frame.data(), &input),
                 type == STATION_INPUT ? STATION_OK : STATION_BAD_TYPE);
        std::uint8_t page = 0, status = 0;
        QCOMPARE(station_decode_feature_request(frame.data(), &page),
                 type == STATION_FEATURE_REQUEST ? STATION_OK : STATION_BAD_TYPE);
        QCOMPARE(station_decode_feature_head(frame.data(), &page, &status),
                 type == STATION_FEATURE_REPLY ? STATION_OK : STATION_BAD_TYPE);
    }
}

void TestStationFrame::holdIsOneToTwenty() {
    for (int hold = 0; hold < 256; ++hold) {
        const bool allowed = hold >= 1 && hold <= 20;
        station_output output{};
        const StationFrame frame = outputFrame(1, 0, static_cast<std::uint8_t>(hold));
        QCOMPARE(station_decode_output(frame.data(), &output), allowed ? STATION_OK : STATION_BAD_VALUE);
        output.hold_ms = static_cast<std::uint8_t>(hold);
        StationFrame written{};
        QCOMPARE(station_encode_output(&output, written.data()), allowed ? STATION_OK : STATION_BAD_VALUE);
        QCOMPARE(written == StationFrame{}, !allowed);
    }
}

void TestStationFrame::anInputThatContradictsItselfIsRefused() {
    for (int state = 0; state < 256; ++state)
        for (int flags = 0; flags < 16; ++flags) {
            const bool armed = flags & STATION_INPUT_ARMED, fault = flags & STATION_INPUT_FAULT,
                       homed = flags & STATION_INPUT_HOMED;
            const bool allowed = (state == STATION_UNKNOWN && !armed && !fault && !homed) ||
                                 (state == STATION_HOMED && !armed && !fault && homed) ||
                                 (state == STATION_ARMED && armed && !fault && homed) ||
                                 (state == STATION_FAULT && !armed && fault);
            StationFrame frame{};
            frame[0] = STATION_INPUT;
            frame[1] = static_cast<std::uint8_t>(flags | 0xA0);
            frame[57] = static_cast<std::uint8_t>(state);
            frame[58] = 200; // a code of a later version
            station_input input{};
            QCOMPARE(station_decode_input(sealed(frame).data(), &input),
                     allowed ? STATION_OK : STATION_BAD_VALUE);
            input.state = frame[57];
            input.flags = frame[1];
            QCOMPARE(station_encode_input(&input, frame.data()), allowed ? STATION_OK : STATION_BAD_VALUE);
        }
}

void TestStationFrame::reservedBytesAreIgnored() {
    StationFrame frame = outputFrame(9, STATION_OUTPUT_ENABLE, 5, 77);
    station_output plain{}, odd{};
    QCOMPARE(station_decode_output(frame.data(), &plain), STATION_OK);
    frame[1] |= 0xF0;
    frame[7] = 0xFF;
    for (std::size_t i = 40; i < 62; ++i)
        frame[i] = 0xFF; // the display without its flag, and what follows it
    QCOMPARE(station_decode_output(sealed(frame).data(), &odd), STATION_OK);
    QVERIFY(std::memcmp(&plain, &odd, sizeof plain) == 0);

    StationFrame input{};
    input[0] = STATION_INPUT;
    input[59] = 0xFF;
    station_input read{};
    QCOMPARE(station_decode_input(sealed(input).data(), &read), STATION_OK);
    QCOMPARE(read.status, std::uint8_t(0x07));

    StationFrame request{};
    request.fill(0xFF);
    request[0] = STATION_FEATURE_REQUEST;
    request[1] = 4;
    std::uint8_t page = 0;
    QCOMPARE(station_decode_feature_request(sealed(request).data(), &page), STATION_OK);
    QCOMPARE(page, std::uint8_t(4));
}

void TestStationFrame::aRefusedFrameChangesNothing() {
    station_output output{}, kept{};
    output.sequence = kept.sequence = 99;
    station_input input{}, keptInput{};
    input.sequence = keptInput.sequence = 98;
    StationFrame wrong = outputFrame(1, 0);
    wrong[62] ^= 1;
    QCOMPARE(station_decode_output(wrong.data(), &output), STATION_BAD_CRC);
    QCOMPARE(station_decode_output(outputFrame(1, 0, 0).data(), &output), STATION_BAD_VALUE);
    QCOMPARE(station_decode_input(outputFrame(1, 0).data(), &input), STATION_BAD_TYPE);
    StationFrame bad{};
    bad[0] = STATION_INPUT;
    bad[57] = 9;
    QCOMPARE(station_decode_input(sealed(bad).data(), &input), STATION_BAD_VALUE);
    QVERIFY(std::memcmp(&output, &kept, sizeof output) == 0);
    QVERIFY(std::memcmp(&input, &keptInput, sizeof input) == 0);
}

QTEST_GUILESS_MAIN(TestStationFrame)
#include "test_station_frame.moc"
