// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"

#include <span>
#include <string_view>

namespace chiron::devices {

/// One driver, as lists and help texts show it.
struct DriverEntry {
    std::string_view id;    ///< DeviceDescriptor::driver
    std::string_view title; ///< English; translated where it is shown
    std::string_view needs; ///< what must be there to use it
    DeviceClass deviceClass;
};

/// Every driver of this build, in the order lists show them. Static data; any thread.
std::span<const DriverEntry> driverCatalogue() noexcept;

/// The entry of an id, or nullptr.
const DriverEntry* findDriver(std::string_view id) noexcept;

} // namespace chiron::devices
