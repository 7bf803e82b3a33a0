// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_forces_tables.h"

namespace chiron::simulation {

/// Sums over the springs of all sections for one pose of the tip (models.md §1.2).
struct UrethraSectionSums {
    double energy_J = 0.0;     ///< Σ k(½Δ² + ⅓βΔ³)
    double normal_N = 0.0;     ///< N
    double friction_N = 0.0;   ///< Σ μ_i N_i
    double opened_m = 0.0;     ///< Σ W c Δs, c: how far the wall touches (kTouching_m)
    double slope_N = 0.0;      ///< ∂/∂s_t of the energy at constant e
    core::Vec2 gradient_N = core::Vec2::Zero(); ///< ∂/∂e (along x̂, along n)
    double stiffness_N_per_m = 0.0; ///< bounds ∂²/∂e²: its greater diagonal entry plus the other one's coupling
    double axial_N_per_m = 0.0;     ///< bounds ∂²/∂s_t² at constant e
    double cross_N_per_m = 0.0;     ///< bounds ∂²/∂s_t∂e
    double yielding_N_per_m = 0.0;  ///< Σ 8 k a² B² (1 + 2βA) c: the stiffness across, of whole rings, as far as they touch; sets in without a step
};

/// `tip_s_m`: s_t; e of the tip in its section, m. Pure; haptic thread.
UrethraSectionSums sumUrethraSections(const UrethraForces::Tables& tables, double tip_s_m, double ex_m, double en_m) noexcept;

} // namespace chiron::simulation
