// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "devices/api/kinematics.h"

namespace chiron::devices {

/// The motors of a mechanism that is computed inside the program, axis by axis. For a program that stands in
/// for a device (app/station): over a link, the host has already computed the efforts. Sessions never use it;
/// they go through IDevice::command().
/// Thread: haptic; allocates nothing.
class IDrivenAxes {
public:
    /// Takes the place of IDevice::command(): steps the mechanism by one tick with these efforts (N or N·m,
    /// in the order of the axes). With `enabled` false the motors are off.
    virtual void drive(const AxisValues& efforts, const core::DisplayPose& display_D,
                       bool enabled) noexcept = 0;

protected:
    ~IDrivenAxes() = default;
};

} // namespace chiron::devices
