// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"

#include <span>
#include <string_view>

namespace chiron::devices {

/// Every driver of this build, in the order lists show them. Static data; any thread.
std::span<const Driver* const> driverCatalogue() noexcept;

/// The driver of an id, or nullptr.
const Driver* findDriver(std::string_view id) noexcept;

/// The driver that a stored plan names so, or nullptr.
const Driver* findDriverOfPlan(std::string_view planWord) noexcept;

/// The first driver whose tools are moved so: what is used where nobody chose. There is one for each MovedBy.
const Driver& usualDriver(MovedBy movedBy) noexcept;

} // namespace chiron::devices
