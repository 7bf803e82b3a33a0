// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "station/protocol/station_cobs.h"
#include "unit/station/station_samples.h"

#include <QByteArray>
#include <QByteArrayList>
#include <QList>
#include <QString>
#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace chiron::test {

/// Lines of 16 bytes in hexadecimal, as the page has them.
inline QByteArray hexLines(const std::uint8_t* bytes, qsizetype count) {
    QByteArrayList lines;
    for (qsizetype at = 0; at < count; at += 16)
        lines << QByteArray(reinterpret_cast<const char*>(bytes) + at, std::min<qsizetype>(16, count - at))
                     .toHex(' ');
    return lines.join('\n');
}

/// The frames that docs/station-protocol.md describes in words under "Test vectors", block by block.
inline QList<std::pair<QString, QByteArray>> stationPageBlocks() {
    StationFrame frame{};
    const auto lines = [&frame] { return hexLines(frame.data(), STATION_FRAME_SIZE); };
    QList<std::pair<QString, QByteArray>> blocks;

    station_input input{};
    input.flags = STATION_INPUT_DEAD_MAN | STATION_INPUT_ARMED | STATION_INPUT_HOMED | 0x10;
    input.sequence = 0x1234;
    input.time_us = 0xDEADBEEF;
    for (int i = 0; i < 7; ++i)
        input.counts[i] = i % 2 == 0 ? i + 1 : -(i + 1);
    input.counts[7] = std::numeric_limits<std::int32_t>::min();
    input.jaw = -2;
    const std::int16_t wrench[] = {256, 513, 770, 1027, 1284, -1};
    std::memcpy(input.wrench, wrench, sizeof wrench);
    input.applied_sequence = 0xABCD;
    input.applied_age_ms = 7;
    input.state = STATION_ARMED;
    input.status = STATION_STATUS_WRENCH_VALID | STATION_STATUS_AT_LIMIT;
    input.supply_mV = 24000;
    (void)station_encode_input(&input, frame.data());
    blocks << std::pair{QStringLiteral("input"), lines()};

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
    (void)station_encode_output(&output, frame.data());
    blocks << std::pair{QStringLiteral("output"), lines()};
    std::array<std::uint8_t, STATION_COBS_SIZE> line{};
    station_cobs_encode(frame.data(), line.data());
    blocks << std::pair{QStringLiteral("line"), hexLines(line.data(), STATION_COBS_SIZE)};

    (void)station_encode_feature_request(17, frame.data());
    blocks << std::pair{QStringLiteral("request"), lines()};

    QByteArrayList replies;
    station_encode_no_page(5, frame.data());
    replies << lines();
    const station_identity identity{
        1, 0, 5, STATION_RENDERS_FORCE | STATION_HAS_JAW, 1000, 3000, 4.5f, 0.25f, 24.0f, 0.5, 6};
    (void)station_encode_identity(&identity, frame.data());
    replies << lines();
    const station_names names{"Alpha", "S-1"};
    (void)station_encode_names(&names, frame.data());
    replies << lines();
    const station_kinematics kinematics{"cartesian", "f1"};
    (void)station_encode_kinematics(&kinematics, frame.data());
    replies << lines();
    const station_calibration calibration{0x01020304, 0x0A0B0C0D, "Eva"};
    (void)station_encode_calibration(&calibration, frame.data());
    replies << lines();
    const station_counters counters{1, 2, 3, 4, 5, 6, 7};
    (void)station_encode_counters(&counters, frame.data());
    replies << lines();
    const station_axis axis{0.5, -1.0, 2.0, 4.0f, 0.25f, 0.125f, STATION_RADIAN, "pitch"};
    (void)station_encode_axis(1, &axis, frame.data());
    replies << lines();
    const station_parameters parameters{{1.0, 2.0, -1.0, 0.5, 0.0, 4.0}};
    (void)station_encode_parameters(0, &parameters, frame.data());
    replies << lines();
    blocks << std::pair{QStringLiteral("replies"), replies.join("\n\n")};
    return blocks;
}

} // namespace chiron::test
