// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/objects/object_contact.h"

namespace chiron::simulation {

/// What a body lies on. The ball of a body (11 mm) spans many peaks of a rough bed and rests on their mean, so roughness and
/// recovery of the bed's surface are left out of what it does to a body; a tool's tip feels them (the world's own contact).
struct BodyBed {
    BodyBed() = default;
    explicit BodyBed(ObjectAttributes bed) noexcept
        : contact((bed.roughness_m = 0.0, bed.recoveryShare = 0.0, bed)) {}
    ObjectContact contact;
};

/// A soft body that lies loose on the bed: a ball of radius R whose middle moves, pushed by what touches it, and whose turning
/// is only drawn (it rolls without slip). W, SI.
///
/// Free motion, once a tick of T = 1 ms, semi-implicit (v' first, p' = p + T v'):
///   m dv/dt = F + m g + f_bed(d, v) - c w v_xy,   d = R - p_z,   w = min(1, d/d_0)
/// f_bed is the bed's elasticity, damping and bristle friction (object_contact.h), c the rolling resistance (implicit), d_0 the
/// depth at which the bed carries m g, where it rests. Stable for (k_bed + k_tip + 2 σ₀) T² < 4 m; content is checked.
/// Source: P2 "Mass Model", models.md §2.2; c is an assumption. Thread: haptic.
class LooseBody {
public:
    /// Rolling resistance of something soft and wet (assumption): 1 N pushes it along at 0.25 m/s, as a hand is quick.
    static constexpr double kRolling_Ns_per_m = 4.0;

    void lieDown(const core::Vec2& place_m, double radius_m, double mass_kg, const BodyBed& bed) noexcept;
    /// What the bed does to it where it is and as it moves: remembered for this tick by bedForce() and its like.
    void pressBed(const BodyBed& bed) noexcept;
    /// One tick of free motion under `load` (N, all but bed and weight), after pressBed().
    void moveFreely(const core::Vec3& load) noexcept;
    /// Held: it moves with `v` and its bed drags at it; adds rolling resistance and weight to the bed's force.
    core::Vec3 heldForce() const noexcept;

    double bedDepth_m() const noexcept { return m_radius_m - p_W.z(); } ///< ≤ 0: it does not touch
    double restDepth_m() const noexcept { return m_restDepth_m; }       ///< d_0
    double bedStiffness_N_per_m() const noexcept { return m_onBed.stiffness_N_per_m; }
    double radius_m() const noexcept { return m_radius_m; }
    double mass_kg() const noexcept { return m_mass_kg; }
    /// How high it is above where it rests, m.
    double lifted_m() const noexcept { return p_W.z() - (m_radius_m - m_restDepth_m); }
    /// Energy above that of lying at rest, J ≥ 0: U_bed(d) + m g z less the same at d_0; motion not counted.
    double storedEnergy_J(const BodyBed& bed) const noexcept;
    double motionEnergy_J() const noexcept { return 0.5 * m_mass_kg * v_W.squaredNorm(); }

    core::Vec3 p_W = core::Vec3::Zero(); ///< its middle, m
    core::Vec3 v_W = core::Vec3::Zero(); ///< m/s
    core::Quat q_W = core::Quat::Identity();

private:
    double rolling_Ns_per_m() const noexcept;
    void roll(const core::Vec3& step_m) noexcept;

    double m_radius_m = 0.011;
    double m_mass_kg = 0.010;
    double m_restDepth_m = 0.0;
    ObjectContactState m_state;
    ObjectContactResponse m_onBed;
};

} // namespace chiron::simulation
