// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::devices {

/// How a station's link does. All counts are since open(). Trivially copyable.
struct StationHealth {
    bool connected = false;
    std::uint64_t received = 0;      ///< input frames that counted
    std::uint64_t lost = 0;          ///< input numbers that never came
    std::uint64_t stale = 0;         ///< input frames that came twice or too late
    std::uint64_t badCrc = 0;        ///< frames with a wrong CRC, and broken blocks of a serial line
    std::uint64_t badFrames = 0;     ///< frames with a wrong type or an impossible value
    std::uint64_t overtaken = 0;     ///< input frames that a newer one overtook before anything looked
    std::uint64_t sent = 0;          ///< output frames
    std::uint64_t notTaken = 0;      ///< output frames dropped because the station took none
    std::uint64_t letGo = 0;         ///< times that the station's hold time ran out while it was armed
    std::uint64_t faults = 0;        ///< times that it went into a fault
    std::uint64_t interruptions = 0; ///< times that the link was gone
    std::uint8_t lastFault = 0;      ///< code of the protocol (faultWords())
    /// From a command to the first input frame that tells of it.
    std::uint32_t roundTrip50_us = 0;
    std::uint32_t roundTrip99_us = 0;
    std::uint32_t roundTripMost_us = 0;
};

} // namespace chiron::devices
