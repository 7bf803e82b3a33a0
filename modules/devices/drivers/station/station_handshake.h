// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"
#include "devices/drivers/station/station_transport.h"
#include "station/protocol/station_features.h"

#include <string>

namespace chiron::devices {

/// What a station says about itself on its feature pages.
struct StationIdentity {
    DeviceDescriptor descriptor; ///< without the measured delay
    std::string firmware;
    bool lockstep = false;    ///< it steps once for each output frame, instead of by a clock of its own
    bool deadMan = false;     ///< it arms only while a person holds its switch
    bool homesByFlag = false; ///< the home flag takes its present position as the reference
    bool platform = false;    ///< it shows force to a fingertip
};

/// Asks for all feature pages and makes a descriptor of them. `where` names the station in messages.
/// Errors: device for a station that is silent, speaks something else or another version, or states what
///   cannot be.
core::Result<StationIdentity> identifyStation(IStationTransport& transport, const std::string& where);

/// Whether this is the same station with the same properties, firmware aside.
bool isSameStation(const StationIdentity& a, const StationIdentity& b);

/// What open() leaves to the link.
struct StationStart {
    station_input newest{};
    std::int64_t arrival_ns = 0;
    std::uint16_t sequence = 0;       ///< of the last output that was sent
    std::uint32_t roundTrip99_us = 0; ///< 0: not measured
};

inline constexpr std::size_t kRoundTrips = 200;

/// Brings a station to where the first tick may find it: homed, without a fault, motors off. Sends outputs
/// that enable nothing. Measures the 99th percentile of kRoundTrips round trips (fewer on a line that loses
/// some), unless the station is stepped. Errors: device, saying what is missing: no input frames, a fault
/// that stays, not homed.
core::Result<StationStart> startStation(IStationTransport& transport, const StationIdentity& identity,
                                        const std::string& where);

/// An output that enables nothing.
station::FrameBytes idleOutput(std::uint16_t sequence, std::uint16_t answered, std::uint8_t flags = 0);

/// A fault's name for people, English.
const char* faultWords(std::uint8_t code) noexcept;

/// How long the motors of a station may go on after the last command, ms: as long as the supervisor lets
/// force last after the last good sample.
inline constexpr std::uint8_t kStationHold_ms = 15;

} // namespace chiron::devices
