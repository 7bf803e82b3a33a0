// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstddef>

namespace chiron::simulation {

/// A stretch where the urethra differs from its base values, e.g. a stricture (narrow, stiff ring). Its weight rises by a
/// smoothstep of width `edge_m` centred at each half-height point: w = S((s − c + L/2)/edge + ½)·S((c + L/2 − s)/edge + ½).
struct UrethraLocalChange {
    double centre_m = 0.0;        ///< arc length
    double length_m = 0.012;      ///< between the two half-height points, ≥ 0.010 (models.md §1.1)
    double edge_m = 0.004;        ///< 0 < edge ≤ length
    double radius_m = 0.0015;     ///< at full weight
    double stiffnessFactor = 1.0; ///< of κ at full weight
    double frictionFactor = 1.0;  ///< of μ at full weight
};

/// The male urethra of P1 in A: centre-line in the plane of symmetry y–z (models.md §1.1 and §8), straight from the entrance A to B,
/// y = c (z − z_B)² from there to the bladder neck C; base values and local changes of its wall, and the bladder behind it. Lengths m. Plain data with fixed storage: the tick copies it.
/// Sources and units of every default: models.md §1 (P1; assumptions are named there).
struct UrethraAnatomy {
    static constexpr std::size_t kMaxChanges = 8;

    double curvature_per_m = 13.0; ///< c of y = c (z − z_B)²; P1's 0.13 in cm
    double straight_m = 0.0;       ///< z_B: the straight part up to the parabola's vertex at B; 0: the vertex is at A
    double zEnd_m = 0.0877;        ///< z of the bladder neck C; the entrance A is at 0
    double radius_m = 0.0025;      ///< r_u at rest
    double wallStiffness_N_per_m3 = 3.0e6; ///< κ: radial pressure per radial displacement
    double wallStiffening_per_m = 300.0;   ///< β
    double friction = 0.1;                 ///< μ
    double viscosity_Ns_per_m2 = 36.0;     ///< b′, per metre of canal
    double wallRetardation_s = 0.0;        ///< τ = η/E of the wall as a Kelvin–Voigt solid, across the canal; 0: it does not damp
    double freeLength_m = 0.040;           ///< s_B: the canal before it is free to follow the shaft
    double freeBlend_m = 0.010;            ///< a(s) rises over s_B ± this
    double freeHold_N_per_m = 0.0;         ///< what holds the free part to the body, beyond core::kCanalReach_m; 0: nothing
    double angularStiffness_Nm_per_rad = 0.2; ///< k_φ at L
    double angularCorner_m = 0.005;           ///< corners of k_φ(s) are rounded over ± this
    double pivotSpan_m = 0.0;                 ///< ℓ₀: the pelvic floor, at s_B, holds the shaft over so much; 0: tilt and offset are free of each other
    std::array<UrethraLocalChange, kMaxChanges> changes{};
    std::size_t changeCount = 0;

    double bladderRadius_m = 0.035;               ///< a sphere whose wall meets the centre-line at C
    double bladderStiffness_N_per_m = 400.0;      ///< assumption: soft wall, between P3's 227 and 650 N/m
    double bladderOpening_rad = 0.24434609527920614; ///< 14°, half-angle of the neck seen from the bladder's centre: no wall there
    double bladderOpeningEdge_rad = 0.12217304763960307; ///< 7°: the wall grows to full over this angle
};

/// The rigid instrument (models.md §1.1).
struct Endoscope {
    double radius_m = 22.0e-3 / 6.0; ///< r_e: 22 Fr, 1 Fr = ⅓ mm of diameter
    double beak_m = 0.010;           ///< ℓ: the canal opens this far ahead of the tip
    double behind_m = 0.040;         ///< ℓ_b: sections behind the tip that move with its offset
    double fieldOfView_rad = 1.2217304763960306; ///< full angle, 70°: usual for cystoscopes (assumption)
};

} // namespace chiron::simulation
