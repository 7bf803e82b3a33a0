// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "devices/driver.h"

#include <memory>
#include <string_view>
#include <vector>

namespace chiron::devices {

/// Makes the kinematics that a descriptor names, so that a stored session can be recomputed without its
/// device. The ids are those of the drivers in the catalogue. Allocates; not for the tick.
/// Errors: badInput for an unknown id or for axes that do not fit.
core::Result<std::unique_ptr<IToolKinematics>> makeKinematics(const DeviceDescriptor& descriptor);

/// The catalogue's entry of an id, or nullptr.
const KinematicsEntry* findKinematics(std::string_view id) noexcept;

/// The ids of all force maps that any kinematics of the catalogue has, each once; kExactForceMap comes first.
std::vector<std::string_view> forceMapIds();

} // namespace chiron::devices
