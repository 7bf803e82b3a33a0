// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/objects/object_contact.h"

namespace chiron::simulation {

/// A soft body that lies loose on the bed: a ball of radius R whose middle moves, pushed by what touches it, and whose turning
/// is only drawn (it rolls without slip). W, SI.
///
/// Free motion, once a tick of T = 1 ms, semi-implicit (v' first, p' = p + T v'):
///   m dv/dt = F + m g + f_bed(d, v) - c w v_xy,   d = R - p_z on a plane,   w = min(1, f_n/m g)
/// f_bed is the bed's elasticity, damping and bristle friction (object_contact.h), c the rolling resistance (implicit,
/// in the share of m g that the bed carries), d_0 the depth at which it carries m g, where the body rests. Stable for (k_bed + k_tip + 2 σ₀) T² < 4 m; content is checked.
/// Source: P2 "Mass Model", models.md §2.2; c is an assumption. Thread: haptic.
class LooseBody {
public:
    /// Rolling resistance of something soft and wet (assumption): 1 N pushes it along at 0.25 m/s, as a hand is quick.
    static constexpr double kRolling_Ns_per_m = 4.0;

    /// At rest on a bed of height `height_m` there, where it carries the body.
    void lieDown(const core::Vec2& place_m, double height_m, double radius_m, double mass_kg, const ObjectContact& bed) noexcept;
    /// What the bed does to it where it is and as it moves (`place` of its ball): remembered for this tick.
    const ObjectContactResponse& pressBed(const ObjectContact& bed, const ContactPlace& place) noexcept;
    /// One tick of free motion under `load` (N, all but bed and weight), after pressBed().
    void moveFreely(const core::Vec3& load) noexcept;
    /// Held: bed with rolling resistance, and weight.
    core::Vec3 heldForce() const noexcept;
    /// It lies free: what energy and height are told from, from now on.
    void lieStill() noexcept;

    bool onBed() const noexcept { return m_onBed.inContact; }
    double bedDepth_m() const noexcept { return m_depth_m; } ///< at the last pressBed(); ≤ 0: it does not touch
    double restDepth_m() const noexcept { return m_restDepth_m; } ///< d_0
    double rolling_Ns_per_m() const noexcept; ///< that resists it across the bed now
    double bedStiffness_N_per_m() const noexcept { return m_onBed.stiffness_N_per_m; }
    double radius_m() const noexcept { return m_radius_m; }
    double mass_kg() const noexcept { return m_mass_kg; }
    double lifted_m() const noexcept { return p_W.z() - m_restHeight_m; } ///< above where it last lay still
    /// Energy above that of lying still there, J ≥ 0: U_bed + m g z less the same then; motion not counted. (A bed that is not
    /// flat may let it go lower, by millimetres: that counts as 0.)
    double storedEnergy_J() const noexcept;
    double motionEnergy_J() const noexcept { return 0.5 * m_mass_kg * v_W.squaredNorm(); }

    core::Vec3 p_W = core::Vec3::Zero(); ///< its middle, m
    core::Vec3 v_W = core::Vec3::Zero(); ///< m/s
    core::Quat q_W = core::Quat::Identity();

private:
    void roll(const core::Vec3& step_m) noexcept;

    double m_radius_m = 0.011;
    double m_mass_kg = 0.010;
    double m_restDepth_m = 0.0;
    double m_restHeight_m = 0.0; ///< z of its middle when it last lay still
    double m_restEnergy_J = 0.0;
    double m_depth_m = 0.0;
    ObjectContactState m_state;
    ObjectContactResponse m_onBed;
};

} // namespace chiron::simulation
