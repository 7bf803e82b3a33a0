// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/haptic_frame.h"

namespace chiron::session {

/// Converts recorded counts to the orientation of a tool. Pure: the same counts always give the same doubles.
class IOrientationOf {
public:
    IOrientationOf() = default;
    IOrientationOf(const IOrientationOf&) = delete;
    IOrientationOf& operator=(const IOrientationOf&) = delete;
    virtual ~IOrientationOf() = default;
    /// True if the tool's device can rotate it; otherwise the orientation has no meaning.
    virtual bool turns(int tool) const noexcept = 0;
    virtual core::Quat q_WT(int tool, const core::ToolFrame& frame) const noexcept = 0;
};

} // namespace chiron::session
