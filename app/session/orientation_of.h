// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/haptic_frame.h"

namespace chiron::session {

/// From recorded counts to how a tool is turned. Pure: the same counts always give the same doubles.
class IOrientationOf {
public:
    IOrientationOf() = default;
    IOrientationOf(const IOrientationOf&) = delete;
    IOrientationOf& operator=(const IOrientationOf&) = delete;
    virtual ~IOrientationOf() = default;
    /// Whether the tool's device can turn it at all; where it cannot, orientation means nothing.
    virtual bool turns(int tool) const noexcept = 0;
    virtual core::Quat q_WT(int tool, const core::ToolFrame& frame) const noexcept = 0;
};

} // namespace chiron::session
