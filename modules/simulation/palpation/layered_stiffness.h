// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/palpation/tissue_parameters.h"

#include <cmath>
#include <span>

namespace chiron::simulation {

/// The share, 0..1, of a flat punch's response that comes from the material down to `depth_m`: the weight
/// I₀(ξ), ξ = depth/a, of Gao, Chiu & Lee 1992 (Int. J. Solids Struct. 29:2471, elastic contact versus
/// indentation modelling of multi-layered materials), I₀ = (2/π) atan ξ + [(1 − 2ν) ξ ln((1 + ξ²)/ξ²) − ξ/(1
/// + ξ²)]/(2π(1 − ν)). It rises steadily with depth. Pure.
inline double punchWeight(double depth_m, double a_m, double poisson) noexcept {
    constexpr double kPi = 3.14159265358979323846;
    const double xi = depth_m / a_m;
    if (!(xi > 0.0))
        return 0.0;
    const double logTerm = (1.0 - 2.0 * poisson) * xi * std::log1p(1.0 / (xi * xi));
    return 2.0 / kPi * std::atan(xi) + (logTerm - xi / (1.0 + xi * xi)) / (2.0 * kPi * (1.0 - poisson));
}

/// Young's modulus (Pa) of the homogeneous tissue that responds to a flat punch of radius a as these layers
/// do. The compliances add in series with the weight above: 1/E = Σ [I₀(bottom) − I₀(top)]/E_i. To first
/// order in the difference of the moduli this is Gao's perturbation; adding compliances instead of moduli (as
/// Xu & Pharr 2006 do) keeps it finite over a rigid base. The result lies between the softest and the
/// stiffest layer. It tends to the first layer's modulus as that layer grows thick, and to the next one's as
/// it grows thin. No finite-element result supports it beyond a factor of 2 between layers (Gao's own range).
/// Layers ≥ 1, moduli > 0.
inline double layeredModulus_Pa(std::span<const TissueLayer> layers, double a_m, double poisson) noexcept {
    double compliance = 0.0, top_m = 0.0, above = 0.0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        top_m += layers[i].thickness_m;
        const double down = i + 1 == layers.size() ? 1.0 : punchWeight(top_m, a_m, poisson);
        compliance += (down - above) / layers[i].modulus_Pa;
        above = down;
    }
    return 1.0 / compliance;
}

} // namespace chiron::simulation
