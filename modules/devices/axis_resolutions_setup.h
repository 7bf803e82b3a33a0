// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"

#include <array>
#include <cmath>
#include <string>

namespace chiron::devices {

/// The error for a descriptor that does not fit a kinematics.
inline auto kinematicsMisfit(const std::string& id, const std::string& what) {
    return core::fail(core::ErrorCode::badInput, "kinematics " + id + ": " + what);
}

/// Returns the resolutions of a descriptor's axes for the kinematics `id` with exactly `Axes` axes; `names`
/// lists them for people. Not for the tick.
/// Errors: badInput for another id, another number of axes, or a resolution that is not a finite number above
/// 0.
template <std::size_t Axes>
core::Result<std::array<double, Axes>> axisResolutions(const DeviceDescriptor& descriptor,
                                                       const std::string& id, const std::string& names) {
    if (descriptor.kinematics != id)
        return kinematicsMisfit(id, "descriptor says '" + descriptor.kinematics + "'");
    if (descriptor.axes.size() != Axes)
        return kinematicsMisfit(id, "axes: " + std::to_string(descriptor.axes.size()) + " found, " +
                                        std::to_string(Axes) + " expected (" + names + ")");
    std::array<double, Axes> resolution{};
    for (std::size_t axis = 0; axis < Axes; ++axis) {
        resolution[axis] = descriptor.axes[axis].resolution;
        if (!(resolution[axis] > 0.0) || !std::isfinite(resolution[axis]))
            return kinematicsMisfit(id, "axes[" + std::to_string(axis) +
                                            "].resolution: a finite number above 0 expected");
    }
    return resolution;
}

} // namespace chiron::devices
