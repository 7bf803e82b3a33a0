// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/objects/object_contact.h"

namespace chiron::simulation {

/// A soft body that lies loose on the bed. It is a ball of radius R whose centre moves, pushed by its
/// contacts, and whose rotation is only drawn (it rolls without slip). Frame: W. Unit: SI.
///
/// It moves freely in semi-implicit steps, once per tick of T = 1 ms (v' first, p' = p + T v'):
///   m dv/dt = F + m g + f_bed(d, v) - c w v_xy,   d = R - p_z on a plane,   w = min(1, f_n/m g)
/// f_bed is the bed's elasticity, damping and bristle friction (object_contact.h). c is the rolling
/// resistance (implicit, weighted by the share of m g that the bed carries). d_0 is the depth at which the
/// bed carries m g and the body rests. The motion is stable for (k_bed + k_tip + 2 σ₀) T² < 4 m, which is
/// checked for content. Source: P2 "Mass Model", models.md §2.2; c is an assumption.
/// Thread: haptic.
class LooseBody {
public:
    /// Rolling resistance of something soft and wet (assumption): a force of 1 N moves it at 0.25 m/s, about
    /// as fast as a hand.
    static constexpr double kRolling_Ns_per_m = 4.0;

    /// Puts it at rest on a bed of height `height_m` there, at the depth at which the bed carries it.
    void lieDown(const core::Vec2& place_m, double height_m, double radius_m, double mass_kg,
                 const ObjectContact& bed) noexcept;
    /// Computes the force of the bed on it at its present position and velocity (`place` is that of its ball)
    /// and keeps it for this tick.
    const ObjectContactResponse& pressBed(const ObjectContact& bed, const ContactPlace& place) noexcept;
    /// Advances free motion by one tick under `load` (N, everything except bed and weight), after pressBed().
    void moveFreely(const core::Vec3& load) noexcept;
    /// Force on a held body: the bed with rolling resistance, and the weight.
    core::Vec3 heldForce() const noexcept;
    /// Takes the present position, where it lies free, as the reference for energy and height from now on.
    void lieStill() noexcept;

    bool onBed() const noexcept { return m_onBed.inContact; }
    /// Depth in the last pressBed(); ≤ 0: it does not touch.
    double bedDepth_m() const noexcept { return m_depth_m; }
    double restDepth_m() const noexcept { return m_restDepth_m; } ///< d_0
    double rolling_Ns_per_m() const noexcept; ///< present resistance to motion across the bed
    double bedStiffness_N_per_m() const noexcept { return m_onBed.stiffness_N_per_m; }
    double radius_m() const noexcept { return m_radius_m; }
    double mass_kg() const noexcept { return m_mass_kg; }
    /// Height above where it last lay still.
    double lifted_m() const noexcept { return p_W.z() - m_restHeight_m; }
    /// Energy in excess of that when it last lay still, J ≥ 0: U_bed + m g z minus the same at that time.
    /// Motion does not count. (A bed that is not flat may let it sink lower by millimetres: that counts as
    /// 0.)
    double storedEnergy_J() const noexcept;
    double motionEnergy_J() const noexcept { return 0.5 * m_mass_kg * v_W.squaredNorm(); }

    core::Vec3 p_W = core::Vec3::Zero(); ///< its centre, m
    core::Vec3 v_W = core::Vec3::Zero(); ///< m/s
    core::Quat q_W = core::Quat::Identity();

private:
    void roll(const core::Vec3& step_m) noexcept;

    double m_radius_m = 0.011;
    double m_mass_kg = 0.010;
    double m_restDepth_m = 0.0;
    double m_restHeight_m = 0.0; ///< z of its centre when it last lay still
    double m_restEnergy_J = 0.0;
    double m_depth_m = 0.0;
    ObjectContactState m_state;
    ObjectContactResponse m_onBed;
};

} // namespace chiron::simulation
