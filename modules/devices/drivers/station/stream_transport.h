// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/station/station_transport.h"

namespace chiron::devices {

/// Connects by TCP without delay (TCP_NODELAY).
/// Errors: device.
core::Result<std::unique_ptr<IStationTransport>> connectTcp(const std::string& host, std::uint16_t port);

/// Opens a serial line raw at 1 Mbit/s, eight bits, no parity, for this program alone.
/// Errors: device.
core::Result<std::unique_ptr<IStationTransport>> openSerial(const std::string& path);

/// A transport over a stream that is already open.
std::unique_ptr<IStationTransport> makeStreamTransport(station::FrameStream stream);

} // namespace chiron::devices
