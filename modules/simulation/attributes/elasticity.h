// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::simulation {

/// Elastic contact as a potential: U = ½ k d² (J), f = −∇U = −k d ∇d − ½ d² ∇k (N, on the tool, W).
/// `depth_m` ≥ 0; `depthGradient` = ∇d (−n for a smooth surface; −n + ∇h with a micro-height h); `stiffness_N_per_m` = k
/// and its gradient at the tool's place. The second term is the lateral force without which a press–slide–lift loop
/// over a stiff lump would make energy. Pure. Source: models.md §0, §2.2.
struct Elasticity {
    static double energy(double stiffness_N_per_m, double depth_m) noexcept {
        return 0.5 * stiffness_N_per_m * depth_m * depth_m;
    }
    static core::Vec3 force(double stiffness_N_per_m, const core::Vec2& stiffnessGradient_N_per_m2, double depth_m,
                            const core::Vec3& depthGradient) noexcept {
        core::Vec3 f = -stiffness_N_per_m * depth_m * depthGradient;
        const double lateral = 0.5 * depth_m * depth_m;
        f.x() -= lateral * stiffnessGradient_N_per_m2.x();
        f.y() -= lateral * stiffnessGradient_N_per_m2.y();
        return f;
    }
};

} // namespace chiron::simulation
