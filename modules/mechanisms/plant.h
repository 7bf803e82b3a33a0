// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"

#include <array>
#include <cstdint>
#include <span>

namespace chiron::mechanisms {

/// Generalised efforts of a device's axes in their order, N or N·m; the rest is zero.
using AxisEfforts = std::array<double, core::kMaxCoordinates>;

/// Where a plant's tool truly is and how it moves, D, SI.
struct ToolMotion {
    core::Vec3 p_DT = core::Vec3::Zero();
    core::Quat q_DT = core::Quat::Identity(); ///< identity where the hand does not turn the tool
    core::Vec3 v_DT = core::Vec3::Zero();
    core::Vec3 w_DT = core::Vec3::Zero();
};

/// A mechanism's dynamics as a simulated device steps it: once a tick beginTick(), then `substeps()` times step(), then
/// endTick(). Haptic thread; nothing allocates.
class Plant {
public:
    /// Motors follow these efforts until the next tick; `enabled` false opens the amplifiers: no effort at all.
    virtual void beginTick(const AxisEfforts& render, bool enabled) noexcept = 0;
    /// One integration step under what the hand does to the tool: force at the tip and torque about it, D.
    virtual void step(double dt_s, const core::Wrench& onTool_D) noexcept = 0;
    virtual void endTick() noexcept = 0; ///< the encoders are read

    virtual ToolMotion motion() const noexcept = 0;
    virtual std::span<const std::int32_t> encoderCounts() const noexcept = 0; ///< as the host sees them, delayed
    /// On the tool in D: what the motors really gave over the last tick, without what carries the weight.
    virtual core::Wrench measured_D() const noexcept = 0;
    virtual bool saturated() const noexcept = 0; ///< a motor ran at its limit in the last tick
    virtual int substeps() const noexcept = 0;
    virtual bool turns() const noexcept = 0; ///< the hand turns the tool: a wrist holds it

protected:
    ~Plant() = default; ///< owned by their own type
};

} // namespace chiron::mechanisms
