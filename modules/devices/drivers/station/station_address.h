// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace chiron::devices {

/// Where a station is connected: tcp:HOST:PORT, serial:/dev/NAME, or hid:VVVV:PPPP with or without :SERIAL.
struct StationAddress {
    enum class Kind { tcp, serial, hid };
    Kind kind = Kind::tcp;
    std::string host; ///< tcp
    std::uint16_t port = 0;
    std::string path;         ///< serial
    std::uint16_t vendor = 0; ///< hid: USB's numbers of maker and product
    std::uint16_t product = 0;
    std::string serialNumber; ///< hid; empty: whichever is plugged in, if it is one
};

/// Reads an address. An IPv6 address stands in brackets: tcp:[::1]:7000.
/// Errors: badInput saying what an address looks like.
core::Result<StationAddress> readStationAddress(std::string_view text);

} // namespace chiron::devices
