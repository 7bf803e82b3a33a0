// SPDX-License-Identifier: GPL-3.0-or-later
// Creation allocates error texts, so it is kept apart from the code that the tick calls.
#include "devices/drivers/cartesian/cartesian_kinematics.h"

#include <cmath>

namespace chiron::devices {

core::Result<CartesianKinematics> CartesianKinematics::create(const DeviceDescriptor& descriptor) {
    const std::size_t axes = descriptor.axes.size();
    if (axes != 3 && axes != 6)
        return core::fail(core::ErrorCode::badInput,
                          "cartesian kinematics: " + std::to_string(axes) +
                              " axes, expected 3 (x, y, z) or 6 (and the rotation vector)");
    CartesianKinematics kinematics;
    for (std::size_t i = 0; i < axes; ++i) {
        const AxisDescriptor& axis = descriptor.axes[i];
        if (axis.unit != (i < 3 ? AxisUnit::metre : AxisUnit::radian))
            return core::fail(core::ErrorCode::badInput, "cartesian kinematics: axis " + axis.id +
                                                             " must be in " + (i < 3 ? "metres" : "radians"));
        if (!(axis.resolution > 0.0) || !std::isfinite(axis.resolution))
            return core::fail(core::ErrorCode::badInput,
                              "cartesian kinematics: axis " + axis.id + " has resolution " +
                                  std::to_string(axis.resolution) + ", expected finite and > 0");
        kinematics.m_resolution[i] = axis.resolution;
    }
    kinematics.m_jawResolution_rad = descriptor.jawResolution_rad;
    kinematics.m_turns = axes == 6;
    return kinematics;
}

CartesianKinematics::~CartesianKinematics() = default;

} // namespace chiron::devices
