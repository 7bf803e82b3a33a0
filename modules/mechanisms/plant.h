// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"

#include <array>
#include <cstdint>
#include <span>

namespace chiron::mechanisms {

/// Generalised efforts of a device's axes in their order, N or N·m; unused entries are zero.
using AxisEfforts = std::array<double, core::kMaxCoordinates>;

/// True pose and motion of a plant's tool.
/// Unit: SI.
/// Frame: D.
struct ToolMotion {
    core::Vec3 p_DT = core::Vec3::Zero();
    core::Quat q_DT = core::Quat::Identity(); ///< identity if the hand does not turn the tool
    core::Vec3 v_DT = core::Vec3::Zero();
    core::Vec3 w_DT = core::Vec3::Zero();
};

/// A mechanism's dynamics as a simulated device steps them: once per tick beginTick(), then `substeps()`
/// times step(), then endTick().
/// Thread: haptic; allocates nothing.
class Plant {
public:
    /// Sets the efforts that the motors follow until the next tick. With `enabled` false the amplifiers are
    /// open: no effort at all.
    virtual void beginTick(const AxisEfforts& render, bool enabled) noexcept = 0;
    /// Runs one integration step under the hand's wrench on the tool: force at the tip and torque about it,
    /// D.
    virtual void step(double dt_s, const core::Wrench& onTool_D) noexcept = 0;
    virtual void endTick() noexcept = 0; ///< reads the encoders

    virtual ToolMotion motion() const noexcept = 0;
    virtual std::span<const std::int32_t>
    encoderCounts() const noexcept = 0; ///< as the host sees them, delayed
    /// Wrench on the tool in D that the motors really gave over the last tick, without the part that carries
    /// the weight.
    virtual core::Wrench measured_D() const noexcept = 0;
    virtual bool saturated() const noexcept = 0; ///< a motor ran at its limit in the last tick
    virtual int substeps() const noexcept = 0;
    virtual bool turns() const noexcept = 0; ///< the hand turns the tool, so a wrist holds it

protected:
    ~Plant() = default; ///< instances are destroyed through their own type
};

} // namespace chiron::mechanisms
