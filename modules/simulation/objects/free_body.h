// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/attributes/mass.h"

#include <cmath>

namespace chiron::simulation {

/// The other forces on a free body at its position, and whether it lies on something.
struct BodySupport {
    core::Vec3 force = core::Vec3::Zero(); ///< N, on the body, W
    bool touching = false;
};

/// A small loose object (10 g) as a point mass that falls, lies or is held. Rotation is left out (the object
/// is drawn as it was let go).
///   free:  m v' = m g + f(p, v) − b v,   p' = v       semi-implicit Euler: v first, then p with the new v
///   held:  it follows the holding tool exactly
/// It is stable on a bed of stiffness k with damping c for k < 4 m/h² and c < 2 m/h, less where both act
/// (10 g at h = 1 ms: 40 kN/m; 20 N·s/m at k = 0). It falls by ½ g t (t + h), which exceeds free fall by less
/// than 1 mm in 0.2 s. Deterministic. Source: P2 "Mass Model" (10 g); the integrator: semi-implicit Euler,
/// models.md §4.
/// Thread: haptic; allocates nothing.
class FreeBody {
public:
    /// `mass_kg` > 0; `airDamping_Ns_per_m` = b ≥ 0 is the damping by the air (and the blood that the object
    /// lies in).
    explicit FreeBody(double mass_kg = 0.010, double airDamping_Ns_per_m = 0.0) noexcept
        : m_mass_kg(mass_kg), m_damping_Ns_per_m(airDamping_Ns_per_m) {}

    /// Puts the body there, at rest and held by nobody.
    void place(const core::Vec3& p_W) noexcept {
        m_p = p_W;
        m_v.setZero();
        m_held = m_falling = m_touching = false;
        m_landing_m_per_s = 0.0;
    }
    /// A grasper takes it; from now on follow() moves it.
    void hold() noexcept {
        m_held = true;
        m_falling = m_touching = false;
    }
    /// Moves a held body exactly to this position, with this velocity.
    void follow(const core::Vec3& p_W, const core::Vec3& v_W) noexcept {
        m_p = p_W;
        m_v = v_W;
    }
    /// Lets the body go with its present velocity. The next thing that it strikes counts as its landing.
    void release() noexcept {
        m_held = false;
        m_falling = true;
        m_landing_m_per_s = 0.0;
    }

    /// Advances a body that nobody holds by one tick. `support(p, v)` → BodySupport returns the effect of the
    /// bed at that position; step() calls it once, with the state at the tick's start, and it must be
    /// noexcept. Returns true in the tick in which the body lands after a release().
    template <class Support> bool step(double dt_s, Support&& support) noexcept {
        if (m_held)
            return false;
        const BodySupport bed = support(m_p, m_v);
        const bool landed = m_falling && bed.touching;
        if (landed) {
            m_falling = false;
            m_landing_m_per_s = m_v.norm();
        }
        m_touching = bed.touching;
        m_v += (bed.force + Mass::weight(m_mass_kg)) * (dt_s / m_mass_kg);
        m_v /= 1.0 + m_damping_Ns_per_m * dt_s / m_mass_kg; // implicit: damps and never reverses the motion
        m_p += m_v * dt_s;
        return landed;
    }

    const core::Vec3& p_W() const noexcept { return m_p; }
    const core::Vec3& v_W() const noexcept { return m_v; }
    bool held() const noexcept { return m_held; }
    bool falling() const noexcept { return m_falling; } ///< has been let go and has not landed yet
    bool touching() const noexcept { return m_touching; }
    double mass_kg() const noexcept { return m_mass_kg; }
    double landingSpeed_m_per_s() const noexcept { return m_landing_m_per_s; } ///< speed at the last landing
    double energy_J() const noexcept {
        return 0.5 * m_mass_kg * m_v.squaredNorm() + Mass::energy(m_mass_kg, m_p.z());
    }

private:
    core::Vec3 m_p = core::Vec3::Zero();
    core::Vec3 m_v = core::Vec3::Zero();
    double m_mass_kg;
    double m_damping_Ns_per_m;
    double m_landing_m_per_s = 0.0;
    bool m_held = false;
    bool m_falling = false;
    bool m_touching = false;
};

} // namespace chiron::simulation
