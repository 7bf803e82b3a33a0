// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <algorithm>

namespace chiron::simulation {

/// Viscosity inside an object: f = −b w v (N, on the tool). The weight w = min(1, d/0.5 mm) avoids a step of
/// the force at first contact (models.md §0). `viscosity_Ns_per_m` = b ≥ 0, 0..50; `depth_m` = d is the
/// tool's depth inside the object; `v` is its velocity relative to the object, m/s. The law is not
/// conservative: it never does positive work (f·v ≤ 0). A sampled loop with one tick of delay carries up to
/// about 50 N·s/m (models.md §0). Pure. Source: P2 "viscosity forces opposes motion with a force proportional
/// to velocity"; models.md §2.2.
struct Viscosity {
    static constexpr double kFullDepth_m = 0.0005;

    static double weight(double depth_m) noexcept {
        return std::clamp(depth_m * (1.0 / kFullDepth_m), 0.0, 1.0);
    }
    static core::Vec3 force(double viscosity_Ns_per_m, double depth_m, const core::Vec3& v) noexcept {
        return -viscosity_Ns_per_m * weight(depth_m) * v;
    }
};

} // namespace chiron::simulation
