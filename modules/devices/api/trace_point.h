// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstdint>
#include <optional>

namespace chiron::devices {

/// One row of a recorded movement, in W, which equals the device's D: such a device has the identity as its
/// workspace mapping.
struct TracePoint {
    double t_s = 0.0;
    core::Vec3 p_WT_m = core::Vec3::Zero();
    std::optional<core::Quat> q_WT = std::nullopt; ///< either all rows have one, or none
    double jaw_rad = 0.0;
    std::uint32_t buttons = 0;
};

} // namespace chiron::devices
