// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/geometry.h"
#include "core/tool_state.h"

#include <array>

namespace chiron::devices {

using AxisValues = std::array<double, core::kMaxCoordinates>;

/// Computes the tool's pose in D from the device's integers, and the effort of each device axis from a wrench
/// on the tool. Pure and stateless: a replay makes the same kinematics from the stored descriptor. D is the
/// device's base frame; the driver's transform from vendor axes to D is part of it.
class IToolKinematics {
public:
    virtual ~IToolKinematics() = default;
    /// Returns the pose of the tip from counts: p_DT (m), q_DT, jaw (rad). Velocities are left zero.
    virtual core::ToolState pose(const core::DeviceSample& sample) const noexcept = 0;
    /// Computes v_DT (m/s) and w_DT (rad/s) from the rates of the counts (counts/s), with the Jacobian at
    /// this sample.
    virtual void velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                          core::Vec3& w_DT) const noexcept = 0;
    /// Returns the generalised effort per axis (N or N·m) that realises wrench_D (on the tool, in D): τ = Jᵀf
    /// by default.
    virtual AxisValues efforts(const core::DeviceSample& sample,
                               const core::Wrench& wrench_D) const noexcept = 0;
};

} // namespace chiron::devices
