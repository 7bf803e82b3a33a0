// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_anatomy.h"

namespace chiron::simulation {

/// The wall's local values as continuous functions of arc length (models.md §1.1), and the functions of
/// §1.1/§1.2 that the drawn surface and the forces share. They are defined once, so that the user sees what
/// is felt. Pure.
/// Thread: haptic.
class UrethraWall {
public:
    UrethraWall(const UrethraAnatomy& anatomy, const Endoscope& endoscope) noexcept
        : m_anatomy(anatomy), m_scope(endoscope) {}

    double radius_m(double s_m) const noexcept;           ///< r_u(s) at rest
    double stiffness_N_per_m3(double s_m) const noexcept; ///< κ(s)
    double friction(double s_m) const noexcept;           ///< μ(s)
    double
    constrained(double s_m) const noexcept; ///< a(s): 0 free … 1 constrained, smoothstep over s_B ± blend
    /// W: ½(1+cos π·clamp((s−s_t)/ℓ, 0, 1)); 1 behind the tip. 0 from s_t + ℓ on, exactly.
    double opening(double s_m, double tip_s_m) const noexcept;
    double openingSlope(double s_m, double tip_s_m) const noexcept; ///< ∂W/∂s_t
    /// B: W ahead of the tip, ½(1+cos π·min(1,(s_t−s)/ℓ_b)) behind.
    double following(double s_m, double tip_s_m) const noexcept;
    double followingSlope(double s_m, double tip_s_m) const noexcept; ///< ∂B/∂s_t
    /// r(s) with the tip at s_t (models.md §1.1): max(r_u, r_e) behind, raised cosine ahead, r_u beyond (bit
    /// for bit).
    double openedRadius_m(double s_m, double tip_s_m) const noexcept;

    const UrethraAnatomy& anatomy() const noexcept { return m_anatomy; }
    const Endoscope& endoscope() const noexcept { return m_scope; }

private:
    UrethraAnatomy m_anatomy;
    Endoscope m_scope;
};

} // namespace chiron::simulation
