// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/workspace_map.h"
#include "recording/position_of.h"
#include "session/orientation_of.h"
#include "session/session_setup.h"

#include <memory>
#include <vector>

namespace chiron::session {

/// Converts stored counts to the tip in W by the session's own kinematics and mapping. Summaries, scores,
/// export and playback all use it. Immutable after construction.
/// Thread: any.
class ToolPositions final : public recording::IPositionOf, public IOrientationOf {
public:
    static core::Result<std::unique_ptr<ToolPositions>> create(const SessionSetup& setup);
    core::Vec3 p_WT_m(int tool, const core::ToolFrame& frame) const noexcept override {
        return pose(tool, frame).p_WT;
    }
    core::Quat q_WT(int tool, const core::ToolFrame& frame) const noexcept override {
        return pose(tool, frame).q_WT;
    }
    /// True if the device has a rotary axis.
    bool turns(int tool) const noexcept override { return m_tools[static_cast<std::size_t>(tool)].turns; }
    /// Pose and jaw in W; velocities are zero.
    core::ToolState pose(int tool, const core::ToolFrame& frame) const noexcept;
    int tools() const noexcept { return static_cast<int>(m_tools.size()); }

private:
    struct Tool {
        std::unique_ptr<devices::IToolKinematics> kinematics;
        devices::WorkspaceMap map;
        bool turns = false;
    };
    std::vector<Tool> m_tools;
};

/// The device packet that a frame holds.
core::DeviceSample sampleOf(const core::ToolFrame& frame) noexcept;

} // namespace chiron::session
