// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/haptic_frame.h"

namespace chiron::recording {

/// Computes the tip's position from recorded counts, for path lengths. A higher layer implements it with the
/// device's kinematics and the workspace mapping. Pure: the same counts always give the same doubles.
/// Thread: writer.
class IPositionOf {
public:
    virtual ~IPositionOf() = default;
    virtual core::Vec3 p_WT_m(int tool, const core::ToolFrame& frame) const noexcept = 0;
};

} // namespace chiron::recording
