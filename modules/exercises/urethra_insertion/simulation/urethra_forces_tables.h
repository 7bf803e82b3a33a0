// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_bladder.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"

#include <vector>

namespace chiron::simulation {

/// The values of one force section that respond() reads: constants of its position, and cos and sin of πs/ℓ
/// and πs/ℓ_b. With the latter, the cosines of the moving windows take two products per section.
struct UrethraForceSection {
    double s_m = 0.0;
    double step_m = 0.0;            ///< Δs
    double stiffness_N_per_m = 0.0; ///< k of one spring
    double squeeze_m = 0.0;         ///< r_e − r_u; negative: the endoscope has clearance
    double friction = 0.0;          ///< μ
    double constrained = 0.0;       ///< a
    double dragged_m = 0.0;         ///< c Δs when the tip is centred and past the section
    /// While no spring of an opened section (W = 1) is slack, its sums over the springs are as follows, with
    /// e² = |e|²B²: energy ½ e² `follow`, normal force ½ e² `press`, lateral force |e|B² `follow`. Each adds
    /// to what the centred tip causes.
    double follow_N_per_m = 0.0; ///< 16 k a² (½ + β(r_e − r_u))
    double press_N_per_m2 = 0.0; ///< 16 k a² β
    double cosAhead = 0.0, sinAhead = 0.0;
    double cosBehind = 0.0, sinBehind = 0.0;
};

/// Sums over the sections that the centred tip has opened fully (W = 1).
struct UrethraForcePassed {
    double energy_J = 0.0;
    double normal_N = 0.0;
    double friction_N = 0.0; ///< Σ μN
    double length_m = 0.0;   ///< Σ c Δs
};

/// Drag sets in with contact: its weight c is the largest compression of a section's springs divided by this
/// (models.md §0).
inline constexpr double kTouching_m = 0.0005;

inline double touchingWeight(double compression_m) noexcept {
    return compression_m >= kTouching_m ? 1.0 : compression_m > 0.0 ? compression_m / kTouching_m : 0.0;
}

/// k_φ(s): 0 up to s_B, then a linear rise that reaches the full value at L. The corners are rounded by
/// parabolas over ± `corner_m` (the upper one lies at L − corner, so that k_φ(L) is the full value), so the
/// function is C¹.
struct UrethraAngularStiffness {
    double slope_Nm_per_rad_m = 0.0;
    double from_m = 0.0;
    double to_m = 0.0;
    double corner_m = 0.0;

    double value_Nm_per_rad(double s_m) const noexcept;
    double slope(double s_m) const noexcept; ///< dk_φ/ds, N·m/(rad·m)
    double bend() const noexcept { return slope_Nm_per_rad_m / (2.0 * corner_m); } ///< largest d²k_φ/ds²
};

/// The pelvic floor at s_P holds the rigid shaft over a span ℓ₀. A tip that is e aside, while the floor stays
/// in place, has turned the shaft by c e, c = ℓ/(ℓ² + ℓ₀²), ℓ = s − s_P. A span of 0 means that nothing holds
/// the shaft, c = 0.
struct UrethraPivot {
    double from_m = 0.0; ///< s_P
    double span_m = 0.0; ///< ℓ₀

    struct Turn {
        double turn_per_m = 0.0, slope_per_m2 = 0.0, bend_per_m3 = 0.0; ///< c, c′, |c″|
    };
    Turn at(double s_m) const noexcept;
};

/// The part of UrethraForces that depends only on anatomy, endoscope and settings. Immutable.
struct UrethraForces::Tables {
    std::vector<UrethraForceSection> sections; ///< in the order of s
    std::vector<UrethraForcePassed> passed;    ///< passed[i]: sums of sections 0 … i − 1
    std::vector<int> bucket;                   ///< first section at or after bucket·bucketWidth
    double bucketsPerMetre = 0.0;
    int firstConstrained = 0; ///< first section with a > 0
    UrethraAngularStiffness angular;
    UrethraPivot pivot;
    UrethraBladder bladder;
    double stiffening_per_m = 0.0;    ///< β
    double viscosity_Ns_per_m2 = 0.0; ///< b′
    double wallRetardation_s = 0.0;   ///< τ
    double freeHold_N_per_m = 0.0;
    double freeFrom_m = 0.0, freeBlend_m = 0.0; ///< s_B, and half the range over which a(s) rises
    /// Distance, from the first contact to s_B − the blend, over which the hold sets in; at least the beak's
    /// length.
    double freeRise_m = 0.0;
    double ahead_m = 0.0;            ///< ℓ
    double behind_m = 0.0;           ///< ℓ_b
    double scopeRadius_m = 0.0;      ///< r_e
    double leastSpeed_m_per_s = 0.0; ///< V₀ without friction: max(1 mm/s, count/15 ms)
    double maximumDamping_Ns_per_m = 0.0;

    Tables(const UrethraCentreline& centreline, const UrethraWall& wall,
           const UrethraForceSettings& settings);

    /// Index of the first section with s_i ≥ s; the number of sections if there is none.
    int firstFrom(double s_m) const noexcept;
};

} // namespace chiron::simulation
