// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"

#include <cmath>

namespace chiron::simulation {

/// Stiffness at one position, with its gradient (horizontal, because the field varies over x and y only).
struct StiffnessSample {
    double value_N_per_m = 0.0;
    core::Vec2 gradient_N_per_m2 = core::Vec2::Zero();
};

/// Stiffness that varies over the surface: k(x,y) = k₀ (1 + a g(x,y)),
/// g = ½ [sin(2πx/λ + φ_x) + sin(2πy/λ + φ_y)], so |g| ≤ 1. Pure. Source: models.md §0 (U = ½ k(x,y) d² keeps
/// its lateral force −½ ∇k d²) and §2.3 ("varied stiffness"); the shape of g is our choice: smooth,
/// band-limited to one wavelength.
struct StiffnessField {
    double base_N_per_m = 500.0;               ///< k₀ > 0
    double variation = 0.0;                    ///< a, 0 ≤ a < 1; 0 = uniform
    double wavelength_m = 0.030;               ///< λ > 0
    core::Vec2 phase_rad = core::Vec2::Zero(); ///< φ

    StiffnessSample sample(double x_m, double y_m) const noexcept {
        if (variation == 0.0)
            return {base_N_per_m, core::Vec2::Zero()};
        const double wave = 2.0 * core::kPi / wavelength_m;
        const double ax = wave * x_m + phase_rad.x();
        const double ay = wave * y_m + phase_rad.y();
        const double half = 0.5 * variation * base_N_per_m;
        return {base_N_per_m + half * (std::sin(ax) + std::sin(ay)),
                core::Vec2(half * wave * std::cos(ax), half * wave * std::cos(ay))};
    }
};

} // namespace chiron::simulation
