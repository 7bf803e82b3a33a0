// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_centreline.h"

namespace chiron::simulation {

/// What the bladder's wall does to the tip, in A.
struct BladderResponse {
    core::Vec3 force_A = core::Vec3::Zero();
    double energy_J = 0.0;
    double stiffness_N_per_m = 0.0; ///< an upper bound of the stiffness now
};

/// The bladder: a sphere whose wall meets the centre-line at the neck C, with an opening there (models.md §1.1). The tip, a
/// ball of radius r_e, feels U = ½ k d² g(θ) q(ζ) h(z) with d = max(0, |p − c| − (R − r_e)); g rises from 0 to 1 where the
/// angle θ at the centre c from the neck passes the opening's edge, q over the first 5 mm past the neck's plane, h over the
/// first 10 mm past the entrance's plane (all smoothsteps), so that neither the canal nor the outside knows of the wall.
/// Force = −∇U in full. Pure; haptic thread.
class UrethraBladder {
public:
    static constexpr double kNeckDepth_m = 0.005;
    static constexpr double kBodyDepth_m = 0.010;

    /// `neck`: C on the centre-line.
    UrethraBladder(const UrethraAnatomy& anatomy, const Endoscope& endoscope, const CentrelinePoint& neck) noexcept;

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
    double m_cosFull; ///< cosine of the angle from which the wall is whole
};

} // namespace chiron::simulation
