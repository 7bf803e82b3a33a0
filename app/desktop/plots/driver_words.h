// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"

#include <QString>
#include <string_view>

namespace chiron::desktop {

/// A marked text of a driver (devices::Driver::name) in the language of the screen.
QString driverWords(std::string_view marked);
/// What people call a device of the driver with these kinematics; empty: it goes by its model.
QString deviceName(const devices::Driver& driver, std::string_view kinematics);

} // namespace chiron::desktop
