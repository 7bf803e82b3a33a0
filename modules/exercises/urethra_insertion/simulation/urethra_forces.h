// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/damping_budget.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <memory>

namespace chiron::simulation {

/// Which grid carries the springs.
enum class ForceSections {
    fine,    ///< own grid, 112 sections (maximumStep_m), n′ = 16: independent of what is drawn
    p1Basic, ///< the 26 drawn sections of P1, for comparison ("p1_basic")
};

struct UrethraForceSettings {
    ForceSections sections = ForceSections::fine;
    double maximumStep_m = 0.00125;   ///< of fine: Δs = L/⌈L/this⌉, this no more than the narrowest edge of a local change / 3.2
    int basicSections = 26;           ///< of p1Basic, equidistant along z; ≥ 2
    double count_m = 25e-6; ///< one count at the tip, V₀ ≥ count/15 ms (models.md §0): a session puts its device's here
    double maximumDamping_Ns_per_m = 50.0; ///< of friction's slope, V₀ ≥ μN/b_max: a session takes its device's where that is smaller
};

/// The endoscope in A. `axis_A`: unit, the way it looks (forward); `spin`: about that axis.
struct EndoscopeMotion {
    core::Vec3 p_A = core::Vec3::Zero();
    core::Vec3 axis_A = core::Vec3::UnitZ();
    core::Vec3 v_A = core::Vec3::Zero(); ///< m/s, of the tip
    core::Vec3 w_A = core::Vec3::Zero(); ///< rad/s
    double mostDamping_Ns_per_m = kUnboundedDamping; ///< the tool's budget: friction's slope and viscosity together keep to it, and so does the wall's damping across
};

/// Everything that P1's Info window shows, and more. On the tool, A, SI.
struct UrethraResponse {
    core::Wrench wrench_A;    ///< the whole: force at the tip, torque about it
    CentrelineFoot foot;      ///< s_t and e
    double phiX_rad = 0.0;    ///< ψ(s_t) − atan2(a_y, a_z)
    double phiY_rad = 0.0;    ///< asin a_x
    double normal_N = 0.0;    ///< N = Σ k Δ(1+βΔ)
    double friction_N = 0.0;  ///< F1, along the axis (signed)
    double viscous_N = 0.0;   ///< F2, along the axis (signed)
    double wallDamped_N = 0.0; ///< what the wall takes of a motion across the axis, against it; ≥ 0
    double elastic_N = 0.0;   ///< −F3: elastic force along t (signed; negative pushes out), without the bladder's wall
    core::Vec3 lateral_A = core::Vec3::Zero(); ///< −∂U/∂e, in the tip's section, plus the bladder's wall
    core::Vec3 bladder_A = core::Vec3::Zero(); ///< the bladder's wall alone
    double torqueX_Nm = 0.0;  ///< T_x = −k_φ (φ_x + c e_n), c: UrethraPivot
    double torqueY_Nm = 0.0;  ///< T_y = −k_φ (φ_y − c e_x)
    double torqueZ_Nm = 0.0;  ///< T_z, about the axis
    double energy_J = 0.0;    ///< U
    double stiffness_N_per_m = 0.0; ///< an upper bound of the stiffness of elastic forces now, across and along, for the passivity credit
    double damping_Ns_per_m = 0.0; ///< of the tool's budget: friction, at this speed, and viscosity along the axis, or the wall across it, whichever is more
    bool touching = false;    ///< the beak is in, or the bladder's wall is touched
};

/// P1's forces and torques (eq. 1–6) with every elastic term from one potential (models.md §1.2). Tables are made at
/// construction (set-up file); respond() is the tick's: no allocation, no branch on data that would make it unbounded.
/// Every component is a continuous function of pose; at rest friction and viscosity vanish; outside the body all is zero.
/// Deterministic; any thread (immutable after construction).
class UrethraForces {
public:
    UrethraForces(const UrethraAnatomy& anatomy, const Endoscope& endoscope, const UrethraForceSettings& settings = {});
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
