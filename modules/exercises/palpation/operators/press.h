// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::operators {

/// What one finger believes that it felt in one press.
struct Press {
    core::Vec2 place_m = core::Vec2::Zero(); ///< x, y in W, as it saw its finger
    double force_N = 0.0;                    ///< along the surface's normal
    double depth_m = 0.0;                    ///< since it touched
    double stiffness_N_per_m = 0.0;          ///< as remembered
    core::Vec2 lean_rad = core::Vec2::Zero(); ///< along W's x and y: the way the tissue pushes the finger, away from what is stiff
    bool touched = false;                    ///< it felt anything at all
    int pressure = 0;                        ///< which of the pressures at its spot
};

} // namespace chiron::operators
