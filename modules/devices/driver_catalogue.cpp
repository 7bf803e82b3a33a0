// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/driver_catalogue.h"

#include <array>

namespace chiron::devices {

namespace {
constexpr std::array kDrivers{
    DriverEntry{"simulated", "Simulated mechanism with a scripted hand", "nothing", DeviceClass::felt},
    DriverEntry{"keyboard_mouse", "Mouse and keyboard: force is shown, not felt", "a pointer or a keyboard, and a screen",
                DeviceClass::shown},
    DriverEntry{"replay", "Recorded trace", "a trace file", DeviceClass::shown},
};
} // namespace

std::span<const DriverEntry> driverCatalogue() noexcept { return kDrivers; }

const DriverEntry* findDriver(std::string_view id) noexcept {
    for (const DriverEntry& entry : kDrivers)
        if (entry.id == id)
            return &entry;
    return nullptr;
}

} // namespace chiron::devices
