// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/driver_catalogue.h"

#include "devices/drivers/keyboard_mouse/keyboard_mouse_driver.h"
#include "devices/drivers/replay/replay_driver.h"
#include "devices/drivers/simulated/simulated_driver.h"
#include "devices/drivers/station/station_driver.h"

#include <array>

namespace chiron::devices {

namespace {
constexpr std::array kDrivers{
    &kSimulatedDriver,
    &kKeyboardMouseDriver,
    &kReplayDriver,
    &kStationDriver,
};

template <class Fits> const Driver* firstThat(Fits fits) noexcept {
    for (const Driver* driver : kDrivers)
        if (fits(*driver))
            return driver;
    return nullptr;
}
} // namespace

std::span<const Driver* const> driverCatalogue() noexcept {
    return kDrivers;
}

const Driver* findDriver(std::string_view id) noexcept {
    return firstThat([id](const Driver& driver) { return driver.id == id; });
}

const Driver* findDriverOfPlan(std::string_view planWord) noexcept {
    return firstThat([planWord](const Driver& driver) { return driver.planWord == planWord; });
}

const Driver& usualDriver(MovedBy movedBy) noexcept {
    const Driver* found = firstThat([movedBy](const Driver& driver) { return driver.movedBy == movedBy; });
    return found ? *found : *kDrivers.front();
}

} // namespace chiron::devices
