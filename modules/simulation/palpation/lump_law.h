// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::simulation {

/// The parts of a finger's contact on which the effect of the lumps below depends.
struct SunkContact {
    core::Vec3 q_W = core::Vec3::Zero(); ///< q = C − λ d n = (1 − λ) C + λ p: the surface, sunk by the share
                                         ///< λ of the depth
    core::Vec3 normal{0.0, 0.0, 1.0};
    core::Mat3 follows = core::Mat3::Zero(); ///< P = ∂C/∂p, symmetric; not read where the surface is flat
    double depth_m = 0.0;                    ///< d
    double sinkage = 0.0;                    ///< λ
    double spread2_m2 = 0.0;                 ///< (5/3) a²
    bool flat = true;
    double sinkageSlope_per_m = 0.0; ///< dλ/dd; not 0 where the sinkage is bounded
};

/// How much stiffer the tissue is because of the lumps and regions in it: U = ½ k d² (1 + gain).
struct StiffnessGain {
    double gain = 0.0;
    /// ½ d² ∂gain/∂p; the force is k (d (1 + gain) n − lateral_m2).
    core::Vec3 lateral_m2 = core::Vec3::Zero();
    /// Upper bound of the gain's second derivative in any direction; limits how fast the lateral force may
    /// change.
    double bent_per_m2 = 0.0;
};

/// (8/π) a R³ (m − 1)/(1 + 0.4 (m − 1)), m³·m: zero for a lump of the tissue's own stiffness.
constexpr double lumpStrength(double a_m, double R_m, double m) noexcept {
    constexpr double k8OverPi = 2.5464790894703255;
    return k8OverPi * a_m * R_m * R_m * R_m * (m - 1.0) / (1.0 + 0.4 * (m - 1.0));
}

/// Adds the effect of a lump that is felt through the tissue: χ = strength · H²/S³ with r = q − L, S = r² +
/// (5/3)a², H² = (r·n)² + (5/3)a². This is the law of models.md §3 (Boussinesq's stress at ν = ½ on Eshelby's
/// sphere; Johnson, Contact Mechanics; Eshelby 1957) without coordinates. On a flat surface r = (ρ, h − λd),
/// and the result is exactly that law. On a curved surface the stress is still that of a half-space: an
/// assumption, good while the surface bends little over the lump's depth. Valid for R ≤ 0.75 h, a ≤ h/2, λ d
/// ≤ (h − R)/2. The gradient is exact: ∂q/∂p = (1 − λ) P + λ, and d ∂n/∂p = P − (1 − n nᵀ) follows from p = C
/// − d n, so no curvature is needed. Pure.
inline void addLump(const SunkContact& at, const core::Vec3& centre_W, double strength_m4,
                    StiffnessGain& sum) noexcept {
    const core::Vec3 r = at.q_W - centre_W;
    const double along = r.dot(at.normal);
    const double H2 = along * along + at.spread2_m2;
    const double inverse = 1.0 / (r.squaredNorm() + at.spread2_m2); // 1/S
    const double base = strength_m4 * inverse * inverse * inverse;
    sum.gain += base * H2;
    sum.bent_per_m2 += 6.0 * strength_m4 / (H2 * H2 * H2); // χ'' directly above the lump, where it is largest
    const double d = at.depth_m;
    const double narrowing = 3.0 * H2 * inverse * d * d; // multiplies ½ ∇S
    const double tilting = along * d;                    // multiplies d ∇(r·n)
    // Where the sinkage is bounded, λ depends on the depth and ∂q/∂p has one more term, d λ' n nᵀ.
    if (at.sinkageSlope_per_m != 0.0)
        sum.lateral_m2 +=
            (d * d * d * at.sinkageSlope_per_m * base * along * (1.0 - 3.0 * H2 * inverse)) * at.normal;
    if (at.flat) {
        // ½ ∇S = r − (1 − λ)(r·n) n and d ∇(r·n) = λ d n, collected by r and n.
        const double byNormal = at.sinkage * d * tilting + narrowing * (1.0 - at.sinkage) * along;
        sum.lateral_m2 += base * (byNormal * at.normal - narrowing * r);
        return;
    }
    const core::Vec3 moved = at.follows * r;
    const core::Vec3 spreading = (1.0 - at.sinkage) * moved + at.sinkage * r;
    const core::Vec3 turning = (at.sinkage * d + along) * at.normal + moved - r;
    sum.lateral_m2 += base * (tilting * turning - narrowing * spreading);
}

/// P3's second surface: the lump's own ball, which the tool meets below the surface, pushes back along its
/// own normal.
struct BallContact {
    double depth_m = 0.0; ///< d_t = R − ‖p − L‖
    double force_N = 0.0; ///< along (p − L)/‖p − L‖, ≥ 0
    double energy_J = 0.0;
};

/// Outside a quarter of the radius this is P3's law, f = k_t d_t, U = ½ k_t d_t². Further inside, the ball's
/// normal loses its direction towards the centre; there the force fades to 0 with a smoothstep of ‖p −
/// L‖/(R/4), and U is its integral. The law is continuous through the whole ball and conservative.
/// `distance_m` = ‖p − L‖ < R. Pure.
inline BallContact ballContact(double distance_m, double radius_m, double stiffness_N_per_m) noexcept {
    BallContact out;
    out.depth_m = radius_m - distance_m;
    const double core_m = 0.25 * radius_m;
    if (distance_m >= core_m) {
        out.force_N = stiffness_N_per_m * out.depth_m;
        out.energy_J = 0.5 * out.force_N * out.depth_m;
        return out;
    }
    // With s = r/(R/4), f = k (R − (R/4) s)(3s² − 2s³): U(s) = U(1) + (R/4) ∫ₛ¹ f ds.
    const double s = distance_m / core_m;
    const double s3 = s * s * s;
    out.force_N = stiffness_N_per_m * out.depth_m * s * s * (3.0 - 2.0 * s);
    const double byRadius = 0.5 - (s3 - 0.5 * s3 * s);                // ∫ₛ¹ (3s² − 2s³)
    const double byPlace = 0.35 - (0.75 * s3 * s - 0.4 * s3 * s * s); // ∫ₛ¹ s (3s² − 2s³)
    out.energy_J = stiffness_N_per_m *
                   (0.28125 * radius_m * radius_m + core_m * (radius_m * byRadius - core_m * byPlace));
    return out;
}

} // namespace chiron::simulation
