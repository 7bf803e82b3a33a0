// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>

namespace chiron::simulation {

/// One cubic Bézier segment over t ∈ [0, 1]: Σ bᵢ(t) Pᵢ with b = (1−t)³, 3t(1−t)², 3t²(1−t), t³. Pure.
struct CubicBezier {
    std::array<core::Vec3, 4> control{core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero(),
                                      core::Vec3::Zero()};

    core::Vec3 at(double t) const noexcept {
        const double r = 1.0 - t;
        return r * r * r * control[0] + 3.0 * t * r * r * control[1] + 3.0 * t * t * r * control[2] +
               t * t * t * control[3];
    }
    core::Vec3 slope(double t) const noexcept { ///< d/dt
        const double r = 1.0 - t;
        return 3.0 * r * r * (control[1] - control[0]) + 6.0 * t * r * (control[2] - control[1]) +
               3.0 * t * t * (control[3] - control[2]);
    }
};

} // namespace chiron::simulation
