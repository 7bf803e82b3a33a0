// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "station/protocol/station_device.h"

#include <QByteArray>
#include <array>
#include <cstdint>
#include <cstring>

namespace chiron::test {

using StationFrame = std::array<std::uint8_t, STATION_FRAME_SIZE>;

/// Spaces may stand anywhere between the digits.
inline StationFrame frameOfHex(const char* hex) {
    const QByteArray bytes = QByteArray::fromHex(hex);
    StationFrame frame{};
    if (bytes.size() == STATION_FRAME_SIZE)
        std::memcpy(frame.data(), bytes.constData(), frame.size());
    return frame;
}

inline QByteArray hexOf(const StationFrame& frame) {
    return QByteArray(reinterpret_cast<const char*>(frame.data()), STATION_FRAME_SIZE).toHex(' ');
}

/// As given, but with a right CRC.
inline StationFrame sealed(StationFrame frame) {
    station_seal(frame.data());
    return frame;
}

inline StationFrame outputFrame(std::uint16_t sequence, std::uint8_t flags, std::uint8_t hold_ms = 20,
                                std::int32_t effort = 0) {
    station_output output{};
    output.flags = flags;
    output.sequence = sequence;
    output.hold_ms = hold_ms == 0 || hold_ms > STATION_MOST_HOLD_MS ? 1 : hold_ms;
    for (int axis = 0; axis < 3; ++axis) // the fourth of stationConfig() has no motor
        output.effort[axis] = effort;
    StationFrame frame{};
    (void)station_encode_output(&output, frame.data());
    frame[6] = hold_ms; // bad ones, too
    return sealed(frame);
}

/// Three axes with a motor, one without; homes by the flag.
inline station_device_config stationConfig(std::uint8_t bits = STATION_RENDERS_FORCE |
                                                               STATION_HOMES_BY_FLAG) {
    station_device_config config{};
    config.identity.axes = 4;
    config.identity.bits = bits;
    config.identity.period_us = 1000;
    config.identity.oldest_sample_us = 1000;
    config.identity.max_force_N = 4.5f;
    config.identity.max_torque_Nm = 0.15f;
    config.identity.max_damping_Ns_per_m = 24.0f;
    config.identity.parameters = 7;
    std::strcpy(config.names.model, "Test bench, größer");
    std::strcpy(config.names.serial_number, "TB-0001");
    std::strcpy(config.kinematics.id, "cartesian");
    std::strcpy(config.kinematics.firmware, "chiron-test 1");
    std::strcpy(config.calibration.by_whom, "E. Engineer");
    const float ratings[] = {4.5f, 0.01f, 2000.0f, 0.0f};
    const char* const ids[] = {"x", "yaw", "z", "thirteen_long"};
    for (std::size_t i = 0; i < 4; ++i) {
        config.axes[i].count_size = 1e-6 * (1.0 + static_cast<double>(i));
        config.axes[i].minimum = -0.1;
        config.axes[i].maximum = 0.1 + 0.01 * static_cast<double>(i);
        config.axes[i].rating = ratings[i];
        config.axes[i].coulomb = 0.125f;
        config.axes[i].viscous = 0.5f;
        config.axes[i].unit = i == 1 ? STATION_RADIAN : STATION_METRE;
        std::strcpy(config.axes[i].id, ids[i]);
    }
    for (std::size_t i = 0; i < 7; ++i)
        config.parameters[i / 6].values[i % 6] = 0.25 * static_cast<double>(i + 1);
    config.calibration.unix_time = 1700000000;
    config.calibration.crc32 = station_calibration_crc32(config.axes, 4, config.parameters, 2);
    return config;
}

inline void fillRandomly(core::Random& random, void* bytes, std::size_t count) {
    auto* const at = static_cast<std::uint8_t*>(bytes);
    for (std::size_t i = 0; i < count; ++i)
        at[i] = static_cast<std::uint8_t>(random.below(256));
}

} // namespace chiron::test
