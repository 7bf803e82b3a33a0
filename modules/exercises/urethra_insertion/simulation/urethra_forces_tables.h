// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_bladder.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"

#include <vector>

namespace chiron::simulation {

/// What respond() reads of one force section: constants of the place, and cos and sin of πs/ℓ and πs/ℓ_b, by which the moving
/// windows' cosines are two products a section.
struct UrethraForceSection {
    double s_m = 0.0;
    double step_m = 0.0;            ///< Δs
    double stiffness_N_per_m = 0.0; ///< k of one spring
    double squeeze_m = 0.0;         ///< r_e − r_u; negative: free play
    double friction = 0.0;          ///< μ
    double constrained = 0.0;       ///< a
    double dragged_m = 0.0;         ///< c Δs with the tip centred and past
    /// While no spring of an opened section (W = 1) is slack, its sums over the springs are, with e² = |e|²B²: energy ½ e² `follow`,
    /// normal force ½ e² `press`, lateral force |e|B² `follow`, each on top of what the centred tip causes.
    double follow_N_per_m = 0.0;    ///< 16 k a² (½ + β(r_e − r_u))
    double press_N_per_m2 = 0.0;    ///< 16 k a² β
    double cosAhead = 0.0, sinAhead = 0.0;
    double cosBehind = 0.0, sinBehind = 0.0;
};

/// Sums over sections that the tip, centred, has opened fully (W = 1).
struct UrethraForcePassed {
    double energy_J = 0.0;
    double normal_N = 0.0;
    double friction_N = 0.0; ///< Σ μN
    double length_m = 0.0;   ///< Σ c Δs
};

/// Drag sets in with contact: its weight c is the largest compression of a section's springs over this (models.md §0).
inline constexpr double kTouching_m = 0.0005;

inline double touchingWeight(double compression_m) noexcept {
    return compression_m >= kTouching_m ? 1.0 : compression_m > 0.0 ? compression_m / kTouching_m : 0.0;
}

/// k_φ(s): 0 up to s_B, a straight rise that ends at L with the full value, corners rounded by parabolas over ± `corner_m`
/// (the upper one lies at L − corner, so that k_φ(L) is the full value): C¹.
struct UrethraAngularStiffness {
    double slope_Nm_per_rad_m = 0.0;
    double from_m = 0.0;
    double to_m = 0.0;
    double corner_m = 0.0;

    double value_Nm_per_rad(double s_m) const noexcept;
    double slope(double s_m) const noexcept; ///< dk_φ/ds, N·m/(rad·m)
    double bend() const noexcept { return slope_Nm_per_rad_m / (2.0 * corner_m); } ///< the most of d²k_φ/ds²
};

/// The pelvic floor at s_P holds the rigid shaft over a span ℓ₀: a tip that is e aside with the floor where it was has turned the shaft by
/// c e, c = ℓ/(ℓ² + ℓ₀²), ℓ = s − s_P. A span of 0: nothing holds it, c = 0.
struct UrethraPivot {
    double from_m = 0.0; ///< s_P
    double span_m = 0.0; ///< ℓ₀

    struct Turn {
        double turn_per_m = 0.0, slope_per_m2 = 0.0, bend_per_m3 = 0.0; ///< c, c′, |c″|
    };
    Turn at(double s_m) const noexcept;
};

/// Everything of UrethraForces that depends on anatomy, endoscope and settings alone. Immutable.
struct UrethraForces::Tables {
    std::vector<UrethraForceSection> sections; ///< in the order of s
    std::vector<UrethraForcePassed> passed;    ///< passed[i]: of sections 0 … i − 1
    std::vector<int> bucket;                   ///< first section at or after bucket·bucketWidth
    double bucketsPerMetre = 0.0;
    int firstConstrained = 0; ///< first section with a > 0
    UrethraAngularStiffness angular;
    UrethraPivot pivot;
    UrethraBladder bladder;
    double stiffening_per_m = 0.0;     ///< β
    double viscosity_Ns_per_m2 = 0.0;  ///< b′
    double wallRetardation_s = 0.0;    ///< τ
    double freeHold_N_per_m = 0.0;
    double freeFrom_m = 0.0, freeBlend_m = 0.0; ///< s_B, and a(s) over ± this
    double freeRise_m = 0.0; ///< over this, from the first contact to s_B − the blend, the hold sets in; at least over the beak
    double ahead_m = 0.0;              ///< ℓ
    double behind_m = 0.0;             ///< ℓ_b
    double scopeRadius_m = 0.0;        ///< r_e
    double leastSpeed_m_per_s = 0.0;   ///< V₀ without friction: max(1 mm/s, count/15 ms)
    double maximumDamping_Ns_per_m = 0.0;

    Tables(const UrethraCentreline& centreline, const UrethraWall& wall, const UrethraForceSettings& settings);

    /// First section with s_i ≥ s; their number if there is none.
    int firstFrom(double s_m) const noexcept;
};

} // namespace chiron::simulation
