// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/station/station_transport.h"

#include <string>
#include <vector>

namespace chiron::devices {

/// A station that is plugged in.
struct FoundStation {
    std::string model;        ///< as its USB descriptor says
    std::string serialNumber; ///< likewise; empty: none
    std::string address;      ///< hid:VVVV:PPPP[:SERIAL]
};

/// Lists the USB HID devices that say that they are stations, by serial number. Nothing is opened or asked.
/// Blocks for some milliseconds.
std::vector<FoundStation> findHidStations();

/// Opens the USB HID device of these numbers: unnumbered reports of 64 bytes,
/// each a frame (docs/station-protocol.md). The kernel ends a transfer that the device does not take, after
/// at most five seconds, during which send() waits. Errors: device, saying whether none or several are
/// plugged in, or who may not open it.
core::Result<std::unique_ptr<IStationTransport>> openHid(const StationAddress& address);

} // namespace chiron::devices
