// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"

namespace chiron::devices {

extern const Driver kStationDriver;

} // namespace chiron::devices
