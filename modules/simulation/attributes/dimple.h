// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::simulation {

/// Micro-height of a surface at one position. It is added to the depth: d' = d + h.
struct HeightSample {
    double height_m = 0.0;
    core::Vec2 gradient = core::Vec2::Zero(); ///< ∇h, m/m
};

/// One smooth dimple: h(x,y) = −D (1 − s²/w²)² for s < w, 0 beyond, where s is the horizontal distance from
/// its centre. h and ∇h are continuous; the steepest slope is 8/(3√3)·D/w ≈ 1.54 D/w, at s = w/√3. With U = ½
/// k (d + h)² the contact has a potential, like the other attributes. Pure. Source: models.md §2.2 (roughness
/// as a micro-height), §2.3 (decoy dimple); the profile is our choice: the simplest polynomial with a
/// continuous slope.
struct Dimple {
    double depth_m = 0.0;                     ///< D ≥ 0; 0 = none
    double halfWidth_m = 0.006;               ///< w > 0
    core::Vec2 centre_m = core::Vec2::Zero(); ///< x, y in W

    HeightSample sample(double x_m, double y_m) const noexcept {
        if (depth_m == 0.0)
            return {};
        const double dx = x_m - centre_m.x();
        const double dy = y_m - centre_m.y();
        const double inverse = 1.0 / (halfWidth_m * halfWidth_m);
        const double rest = 1.0 - (dx * dx + dy * dy) * inverse;
        if (rest <= 0.0)
            return {};
        const double slope = 4.0 * depth_m * rest * inverse;
        return {-depth_m * rest * rest, core::Vec2(slope * dx, slope * dy)};
    }
};

} // namespace chiron::simulation
