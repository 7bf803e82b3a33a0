// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::operators {

/// One press, as the finger believes it felt it.
struct Press {
    core::Vec2 place_m = core::Vec2::Zero(); ///< x, y in W, position of the finger as it saw it
    double force_N = 0.0;                    ///< along the surface's normal
    double depth_m = 0.0;                    ///< distance since it touched
    double stiffness_N_per_m = 0.0;          ///< includes the noise of comparing it with remembered ones
    /// Along W's x and y: direction in which the tissue pushes the finger, away from a stiff place.
    core::Vec2 lean_rad = core::Vec2::Zero();
    bool touched = false; ///< it felt anything
    int pressure = 0;     ///< index of the pressure at its spot
};

} // namespace chiron::operators
