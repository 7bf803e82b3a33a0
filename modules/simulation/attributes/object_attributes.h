// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/elasticity.h"

#include <cstdint>
#include <string>

namespace chiron::simulation {

/// The attributes that determine what an object of the abdomen feels like. They are P2's building blocks:
/// each has its law in a file of this folder, and an object combines them as data (models.md §2.2; an ovary =
/// mass + deformability + roughness + friction). A value of 0 leaves a block out. The catalogue fills this
/// struct from content/objects and checks the ranges. All units are SI.
struct ObjectAttributes {
    std::string id = "plain"; ///< of the object in the content, shown to people

    // elasticity: f = -k x, or with strain stiffening f = -(k/b)(e^{bx} - 1), small-strain slope k
    double stiffness_N_per_m = 500.0; ///< k
    double stiffening_per_m = 0.0;    ///< b

    double mass_kg = 0.0; ///< m g downward while lifted (P2)

    // deformation: the surface gives way under a lasting press and recovers with a time constant
    double recoveryTime_s = 0.0; ///< τ; 0: recovers at once
    double recoveryShare = 0.0;  ///< k₁/k ≥ 0: how much stiffer a quick press is than a slow one

    // roughness: micro-height, band-limited, fixed by its seed; U = ½ k (d + h)²
    double roughness_m = 0.0;             ///< rms of h
    double roughnessWavelength_m = 0.002; ///< shortest; ≥ 1 mm
    std::uint64_t roughnessSeed = 1;

    // friction: clipped bristle
    double friction = 0.0;                    ///< μ
    double bristleStiffness_N_per_m = 1000.0; ///< σ₀

    double viscosity_Ns_per_m = 0.0; ///< f = -b v inside the object
    double damping_Ns_per_m = 1.0;   ///< along the contact normal, weighted by min(1, d/0.5 mm)
};

/// The elasticity of an object: of its surface as a function of depth, or of a tube as a function of stretch.
inline ElasticLaw elasticOf(const ObjectAttributes& attributes) noexcept {
    return {attributes.stiffness_N_per_m, attributes.stiffening_per_m};
}

} // namespace chiron::simulation
