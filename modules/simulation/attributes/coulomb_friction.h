// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

/// Coulomb friction regularised by velocity: F = −μ N V / √(V² + V₀²). It serves laws that need friction as a
/// function of velocity (P1's F1 and T_z; `evaluate friction`). Contacts that must hold a still tool use
/// BristleFriction. Pure. Source: P1 eq. 1–3 as read in models.md §1.2; V₀ from models.md §0.
struct CoulombFriction {
    static constexpr double kMinimumV0_m_per_s = 0.001;
    static constexpr double kWindow_s = 0.015;               ///< window of the velocity estimator
    static constexpr double kMaximumDamping_Ns_per_m = 50.0; ///< b_max where the device's data give none

    /// Returns V₀ = max(1 mm/s, one count per 15 ms, μN/b_max). The last term keeps the slope μN/V₀ below the
    /// damping that a sampled loop with one tick of delay can carry; with 1 mm/s alone the force chatters at
    /// ±μN. `count_m` is the device's grid (m); 0 means none.
    static double regularisationVelocity(double mu, double normalForce_N, double count_m,
                                         double maximumDamping_Ns_per_m = kMaximumDamping_Ns_per_m) noexcept {
        return std::max(
            {kMinimumV0_m_per_s, count_m / kWindow_s, mu * normalForce_N / maximumDamping_Ns_per_m});
    }

    /// Returns the force (N) along the direction in which `velocity_m_per_s` is positive; `v0_m_per_s` > 0; N
    /// ≥ 0.
    static double force(double mu, double normalForce_N, double velocity_m_per_s,
                        double v0_m_per_s) noexcept {
        return -mu * normalForce_N * velocity_m_per_s /
               std::sqrt(velocity_m_per_s * velocity_m_per_s + v0_m_per_s * v0_m_per_s);
    }
};

} // namespace chiron::simulation
