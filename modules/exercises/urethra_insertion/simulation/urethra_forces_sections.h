// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_forces_tables.h"

namespace chiron::simulation {

/// Sums over the springs of all sections for one position of the tip (models.md §1.2).
struct UrethraSectionSums {
    double energy_J = 0.0;                      ///< Σ k(½Δ² + ⅓βΔ³)
    double normal_N = 0.0;                      ///< N
    double friction_N = 0.0;                    ///< Σ μ_i N_i
    double opened_m = 0.0;                      ///< Σ W c Δs, c: weight of the wall's contact (kTouching_m)
    double slope_N = 0.0;                       ///< ∂/∂s_t of the energy at constant e
    core::Vec2 gradient_N = core::Vec2::Zero(); ///< ∂/∂e (along x̂, along n)
    /// Bound on ∂²/∂e²: its larger diagonal entry plus the coupling to the other one.
    double stiffness_N_per_m = 0.0;
    double axial_N_per_m = 0.0; ///< bound on ∂²/∂s_t² at constant e
    double cross_N_per_m = 0.0; ///< bound on ∂²/∂s_t∂e
    /// Σ 8 k a² B² (1 + 2βA) c: stiffness of whole rings across the axis, weighted by their contact, so that
    /// it sets in without a step.
    double yielding_N_per_m = 0.0;
};

/// Computes the sums. `tip_s_m` is s_t; `ex_m` and `en_m` are the tip's offset e in its section, m. Pure.
/// Thread: haptic.
UrethraSectionSums sumUrethraSections(const UrethraForces::Tables& tables, double tip_s_m, double ex_m,
                                      double en_m) noexcept;

} // namespace chiron::simulation
