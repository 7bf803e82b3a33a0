// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"

#include <array>
#include <cmath>
#include <string>

namespace chiron::devices {

/// The failure of a kinematics that a descriptor does not fit.
inline auto kinematicsMisfit(const std::string& id, const std::string& what) {
    return core::fail(core::ErrorCode::badInput, "kinematics " + id + ": " + what);
}

/// The resolutions of a descriptor's axes for a kinematics of `id` with exactly `Axes` of them, `names` for people. Fails
/// (badInput) for another id, another number of axes, or a resolution that is not a finite number above 0. Not in the tick.
template <std::size_t Axes>
core::Result<std::array<double, Axes>> axisResolutions(const DeviceDescriptor& descriptor, const std::string& id,
                                                       const std::string& names) {
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
