// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace chiron::session {

/// How hard a tool loaded the tissue: magnitudes of the tissue's force and torque on it.
struct YieldLoad {
    double force_N = 0.0;
    double torque_Nm = 0.0;
};

/// The load under which tissue gave way: the larger one of the tick in which it did and of the tick before,
/// because the force may already have begun to fall.
class YieldLoads {
public:
    /// Call it for each tool of each frame of a recording, in order. Does not allocate.
    YieldLoad at(int tool, const core::ToolFrame& frame) noexcept {
        const core::Array6& f = frame.tissue;
        const YieldLoad now{std::hypot(f[0], f[1], f[2]), std::hypot(f[3], f[4], f[5])};
        YieldLoad& before = m_before[static_cast<std::size_t>(tool)];
        const YieldLoad larger{std::max(before.force_N, now.force_N),
                               std::max(before.torque_Nm, now.torque_Nm)};
        before = now;
        return larger;
    }

private:
    std::array<YieldLoad, core::kMaxTools> m_before{}; ///< of the previous tick
};

} // namespace chiron::session
