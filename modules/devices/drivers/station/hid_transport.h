// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/station/station_transport.h"

namespace chiron::devices {

/// Opens the USB HID device of these numbers: unnumbered reports of 64 bytes on a vendor-defined usage page,
/// each a frame (docs/station-protocol.md). The kernel ends a transfer that the device does not take, after
/// at most five seconds, during which send() waits. Errors: device, saying whether none or several are
/// plugged in, or who may not open it.
core::Result<std::unique_ptr<IStationTransport>> openHid(const StationAddress& address);

} // namespace chiron::devices
