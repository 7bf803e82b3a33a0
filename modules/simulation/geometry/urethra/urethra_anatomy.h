// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstddef>

namespace chiron::simulation {

/// A part of the canal where the urethra differs from its base values, e.g. a stricture (a narrow, stiff
/// ring). Its weight rises and falls by smoothsteps of width `edge_m` centred at the half-height points:
/// w = S((s − c + L/2)/edge + ½)·S((c + L/2 − s)/edge + ½).
struct UrethraLocalChange {
    double centre_m = 0.0;        ///< arc length
    double length_m = 0.012;      ///< between the two half-height points, ≥ 0.010 (models.md §1.1)
    double edge_m = 0.004;        ///< 0 < edge ≤ length
    double radius_m = 0.0015;     ///< at full weight
    double stiffnessFactor = 1.0; ///< of κ at full weight
    double frictionFactor = 1.0;  ///< of μ at full weight
};

/// The male urethra of P1 in A. Its centre-line lies in the plane of symmetry y–z (models.md §1.1 and §8):
/// straight from the entrance A to B, and y = c (z − z_B)² from there to the bladder neck C. The struct also
/// holds the base values and local changes of the wall, and the bladder behind it. It is plain data with
/// fixed storage, because the tick copies it. The sources and units of all defaults are in models.md §1 (P1;
/// assumptions are named there).
/// Unit: m for lengths.
/// Frame: A.
struct UrethraAnatomy {
    static constexpr std::size_t kMaxChanges = 8;

    double curvature_per_m = 13.0; ///< c of y = c (z − z_B)²; P1's 0.13 in cm
    /// z_B: the straight part up to the parabola's vertex at B; 0: the vertex is at A.
    double straight_m = 0.0;
    double zEnd_m = 0.0877;                ///< z of the bladder neck C; the entrance A is at 0
    double radius_m = 0.0025;              ///< r_u at rest
    double wallStiffness_N_per_m3 = 3.0e6; ///< κ: radial pressure per radial displacement
    double wallStiffening_per_m = 300.0;   ///< β
    double friction = 0.1;                 ///< μ
    double viscosity_Ns_per_m2 = 36.0;     ///< b′, per metre of canal
    /// τ = η/E of the wall as a Kelvin–Voigt solid, across the canal; 0: the wall does not damp.
    double wallRetardation_s = 0.0;
    double freeLength_m = 0.040; ///< s_B: the canal before this point is free to follow the shaft
    double freeBlend_m = 0.010;  ///< a(s) rises over s_B ± this
    /// Stiffness that holds the free part to the body, beyond kCanalReach_m; 0: nothing holds it.
    double freeHold_N_per_m = 0.0;
    double angularStiffness_Nm_per_rad = 0.2; ///< k_φ at L
    double angularCorner_m = 0.005;           ///< corners of k_φ(s) are rounded over ± this
    /// ℓ₀: span over which the pelvic floor, at s_B, holds the shaft; 0: tilt and offset are independent.
    double pivotSpan_m = 0.0;
    std::array<UrethraLocalChange, kMaxChanges> changes{};
    std::size_t changeCount = 0;

    double bladderRadius_m = 0.035;          ///< a sphere whose wall meets the centre-line at C
    double bladderStiffness_N_per_m = 400.0; ///< assumption: soft wall, between P3's 227 and 650 N/m
    /// 14°, half-angle of the neck seen from the bladder's centre: no wall there.
    double bladderOpening_rad = 0.24434609527920614;
    double bladderOpeningEdge_rad = 0.12217304763960307; ///< 7°: the wall grows to full over this angle
};

/// The rigid instrument (models.md §1.1).
struct Endoscope {
    double radius_m = 22.0e-3 / 6.0;             ///< r_e: 22 Fr, 1 Fr = ⅓ mm of diameter
    double beak_m = 0.010;                       ///< ℓ: the canal opens this far ahead of the tip
    double behind_m = 0.040;                     ///< ℓ_b: sections behind the tip that move with its offset
    double fieldOfView_rad = 1.2217304763960306; ///< full angle, 70°: usual for cystoscopes (assumption)
};

} // namespace chiron::simulation
