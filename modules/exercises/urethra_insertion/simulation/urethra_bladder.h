// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_centreline.h"

namespace chiron::simulation {

/// Effect of the bladder's wall on the tip, in A.
struct BladderResponse {
    core::Vec3 force_A = core::Vec3::Zero();
    double energy_J = 0.0;
    double stiffness_N_per_m = 0.0; ///< an upper bound of the present stiffness
};

/// The bladder: a sphere whose wall meets the centre-line at the neck C, with an opening there
/// (models.md §1.1). The tip is a ball of radius r_e and feels U = ½ k d² g(θ) q(ζ) h(z) with d = max(0,
/// |p − c| − (R − r_e)). g rises from 0 to 1 where the angle θ from the neck, seen from the centre c, passes
/// the opening's edge. q rises over the first 5 mm past the neck's plane, and h over the first 10 mm past the
/// entrance's plane (all are smoothsteps), so that the wall has no effect in the canal or outside. The force
/// is the complete gradient, −∇U. Pure.
/// Thread: haptic.
class UrethraBladder {
public:
    static constexpr double kNeckDepth_m = 0.005;
    static constexpr double kBodyDepth_m = 0.010;

    /// `neck` is C on the centre-line.
    UrethraBladder(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                   const CentrelinePoint& neck) noexcept;

    BladderResponse respond(const core::Vec3& p_A) const noexcept;
    const core::Vec3& centre_A() const noexcept { return m_centre_A; }

private:
    core::Vec3 m_neck_A;
    core::Vec3 m_out_A; ///< t(C): from the neck into the bladder
    core::Vec3 m_centre_A;
    double m_free_m; ///< R − r_e
    double m_stiffness_N_per_m;
    double m_opening_rad;
    double m_edge_rad;
    double m_cosFull; ///< cosine of the angle from which the wall has its full stiffness
};

} // namespace chiron::simulation
