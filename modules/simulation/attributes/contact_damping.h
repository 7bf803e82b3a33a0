// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace chiron::simulation {

/// Damps a contact along its normal. A weight lets the damping fade in, so that the force has no step at
/// first contact, and the force never pulls:
///   f_n = max(0, f_e − b · min(1, d / 0.5 mm) · v_n)
/// `elastic_N` = f_e is the elastic force's component along the outward normal, `v_n` the tool's velocity
/// along that normal (m/s, positive when leaving), `damping_Ns_per_m` = b ≥ 0 and `depth_m` = d ≥ 0. Returns
/// the whole normal force f_n (N, ≥ 0). With f_e ≥ 0 the damper's own share never does positive work. Pure.
/// Source: models.md §0.
struct ContactDamping {
    static constexpr double kFullDepth_m = 0.0005;

    static double normalForce(double elastic_N, double damping_Ns_per_m, double depth_m,
                              double v_n) noexcept {
        const double weight = std::min(1.0, depth_m * (1.0 / kFullDepth_m));
        return std::max(0.0, elastic_N - damping_Ns_per_m * weight * v_n);
    }
};

} // namespace chiron::simulation
