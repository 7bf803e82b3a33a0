// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/damping_budget.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <memory>

namespace chiron::simulation {

/// Selects the grid that carries the springs.
enum class ForceSections {
    /// Its own grid, 112 sections by default (maximumStep_m), n′ = 16: independent of the drawn sections.
    fine,
    p1Basic, ///< the 26 drawn sections of P1, for comparison ("p1_basic")
};

struct UrethraForceSettings {
    ForceSections sections = ForceSections::fine;
    /// For ForceSections::fine: Δs = L/⌈L/step⌉, where step is this value or, if less, the narrowest edge of
    /// a local change / 3.2.
    double maximumStep_m = 0.00125;
    int basicSections = 26; ///< of p1Basic: number of sections, equidistant along z; ≥ 2
    /// One count at the tip, V₀ ≥ count/15 ms (models.md §0); a session sets its device's value here.
    double count_m = 25e-6;
    /// Bound on friction's slope, V₀ ≥ μN/b_max; a session sets its device's value where that is smaller.
    double maximumDamping_Ns_per_m = 50.0;
};

/// Motion of the endoscope in A. `axis_A` is the unit vector along which it looks (forward).
struct EndoscopeMotion {
    core::Vec3 p_A = core::Vec3::Zero();
    core::Vec3 axis_A = core::Vec3::UnitZ();
    core::Vec3 v_A = core::Vec3::Zero(); ///< m/s, of the tip
    core::Vec3 w_A = core::Vec3::Zero(); ///< rad/s
    /// The tool's budget; friction's slope and viscosity together stay within it, and so does the wall's
    /// damping across the axis.
    double mostDamping_Ns_per_m = kUnboundedDamping;
};

/// All values that P1's Info window shows, and more. They act on the tool.
/// Unit: SI.
/// Frame: A.
struct UrethraResponse {
    core::Wrench wrench_A;     ///< the total: force at the tip, torque about it
    CentrelineFoot foot;       ///< s_t and e
    double phiX_rad = 0.0;     ///< ψ(s_t) − atan2(a_y, a_z)
    double phiY_rad = 0.0;     ///< asin a_x
    double normal_N = 0.0;     ///< N = Σ k Δ(1+βΔ)
    double friction_N = 0.0;   ///< F1, along the axis (signed)
    double viscous_N = 0.0;    ///< F2, along the axis (signed)
    double wallDamped_N = 0.0; ///< the wall's damping force against a motion across the axis; ≥ 0
    /// −F3: elastic force along t (signed; negative pushes out), without the bladder's wall.
    double elastic_N = 0.0;
    core::Vec3 lateral_A = core::Vec3::Zero(); ///< −∂U/∂e, in the tip's section, plus the bladder's wall
    core::Vec3 bladder_A = core::Vec3::Zero(); ///< the part due to the bladder's wall
    double torqueX_Nm = 0.0;                   ///< T_x = −k_φ (φ_x + c e_n), c: UrethraPivot
    double torqueY_Nm = 0.0;                   ///< T_y = −k_φ (φ_y − c e_x)
    double torqueZ_Nm = 0.0;                   ///< T_z, about the axis
    double energy_J = 0.0;                     ///< U
    /// Upper bound of the present stiffness of the elastic forces, across and along, for the passivity
    /// credit.
    double stiffness_N_per_m = 0.0;
    /// Used part of the tool's budget: friction at this speed plus viscosity along the axis, or the wall
    /// across it, whichever is larger.
    double damping_Ns_per_m = 0.0;
    bool touching = false; ///< the beak is inside, or the bladder's wall is touched
};

/// Computes P1's forces and torques (eq. 1–6) with every elastic term from one potential (models.md §1.2).
/// Every component is a continuous function of pose; at rest friction and viscosity vanish; outside the body
/// everything is zero. The tables are made at construction (set-up file). respond() is for the tick: it
/// allocates nothing and has no data-dependent branch that would make it unbounded. Deterministic.
/// Thread: any (immutable after construction).
class UrethraForces {
public:
    UrethraForces(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                  const UrethraForceSettings& settings = {});
    ~UrethraForces();
    UrethraForces(const UrethraForces&) = delete;
    UrethraForces& operator=(const UrethraForces&) = delete;

    UrethraResponse respond(const EndoscopeMotion& motion) const noexcept;

    const UrethraCentreline& centreline() const noexcept { return m_centreline; }
    const UrethraWall& wall() const noexcept { return m_wall; }

    struct Tables; ///< urethra_forces_tables.h

private:
    UrethraCentreline m_centreline;
    UrethraWall m_wall;
    UrethraForceSettings m_settings;
    std::unique_ptr<const Tables> m_tables;
};

} // namespace chiron::simulation
