// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"

#include <span>
#include <string_view>

namespace chiron::devices {

/// Returns every driver of this build in the order of lists. Static data.
/// Thread: any.
std::span<const Driver* const> driverCatalogue() noexcept;

/// Returns the driver with this id, or nullptr.
const Driver* findDriver(std::string_view id) noexcept;

/// Returns the driver that has this name in stored plans, or nullptr.
const Driver* findDriverOfPlan(std::string_view planWord) noexcept;

/// Returns the first driver whose tools are moved in this way: the default if nobody chose. There is one for
/// each MovedBy.
const Driver& usualDriver(MovedBy movedBy) noexcept;

} // namespace chiron::devices
