// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "devices/driver.h"

#include <memory>
#include <string_view>

namespace chiron::devices {

/// Makes the kinematics a descriptor names, so that a stored session can be computed again without its device.
/// Ids: those of the drivers in the catalogue. Fails (badInput) for an unknown id or for axes that do not fit; allocates, not in the tick.
core::Result<std::unique_ptr<IToolKinematics>> makeKinematics(const DeviceDescriptor& descriptor);

/// The catalogue's entry of an id, or nullptr.
const KinematicsEntry* findKinematics(std::string_view id) noexcept;

} // namespace chiron::devices
