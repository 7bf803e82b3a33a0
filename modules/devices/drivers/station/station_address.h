// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace chiron::devices {

/// Where a station is connected: tcp:HOST:PORT or serial:/dev/NAME.
struct StationAddress {
    enum class Kind { tcp, serial };
    Kind kind = Kind::tcp;
    std::string host; ///< tcp
    std::uint16_t port = 0;
    std::string path; ///< serial
};

/// Reads an address. An IPv6 address stands in brackets: tcp:[::1]:7000.
/// Errors: badInput saying what an address looks like.
core::Result<StationAddress> readStationAddress(std::string_view text);

} // namespace chiron::devices
