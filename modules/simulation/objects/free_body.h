// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/attributes/mass.h"

#include <cmath>

namespace chiron::simulation {

/// What else acts on a free body at a place, and whether that is something it lies on.
struct BodySupport {
    core::Vec3 force = core::Vec3::Zero(); ///< N, on the body, W
    bool touching = false;
};

/// A small loose object (10 g) as a point with a mass: it falls, lies, or is held. Turning is left out (it is drawn as it
/// was let go).
///   free:  m v' = m g + f(p, v) − b v,   p' = v       semi-implicit Euler: v first, then p with the new v
///   held:  it follows what holds it exactly
/// Stable on a bed of stiffness k with damping c for k < 4 m/h² and c < 2 m/h less some (10 g at h = 1 ms: 40 kN/m, 20 N·s/m
/// at k = 0). It falls ½ g t (t + h), h more than free fall has: below 1 mm in 0.2 s. Deterministic, allocation-free.
/// Thread: haptic. Source: P2 "Mass Model" (10 g); the integrator: semi-implicit Euler, models.md §4.
class FreeBody {
public:
    /// `mass_kg` > 0; `airDamping_Ns_per_m` = b ≥ 0, of the air (and the blood it lies in).
    explicit FreeBody(double mass_kg = 0.010, double airDamping_Ns_per_m = 0.0) noexcept
        : m_mass_kg(mass_kg), m_damping_Ns_per_m(airDamping_Ns_per_m) {}

    /// At rest there, nobody holding it.
    void place(const core::Vec3& p_W) noexcept {
        m_p = p_W;
        m_v.setZero();
        m_held = m_falling = m_touching = false;
        m_landing_m_per_s = 0.0;
    }
    /// A grasper has it: from now on follow() moves it.
    void hold() noexcept {
        m_held = true;
        m_falling = m_touching = false;
    }
    /// Held: exactly there, moving like that.
    void follow(const core::Vec3& p_W, const core::Vec3& v_W) noexcept {
        m_p = p_W;
        m_v = v_W;
    }
    /// Let go with the velocity it has; what it strikes next counts as its landing.
    void release() noexcept {
        m_held = false;
        m_falling = true;
        m_landing_m_per_s = 0.0;
    }

    /// One tick of a body that nobody holds. `support(p, v)` → BodySupport: what the bed does to it there; called once, with
    /// the state at the tick's start; noexcept. Returns true in the tick it lands after a release().
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
        m_v /= 1.0 + m_damping_Ns_per_m * dt_s / m_mass_kg; // implicit: damps, never turns the motion round
        m_p += m_v * dt_s;
        return landed;
    }

    const core::Vec3& p_W() const noexcept { return m_p; }
    const core::Vec3& v_W() const noexcept { return m_v; }
    bool held() const noexcept { return m_held; }
    bool falling() const noexcept { return m_falling; } ///< let go and not yet landed
    bool touching() const noexcept { return m_touching; }
    double mass_kg() const noexcept { return m_mass_kg; }
    double landingSpeed_m_per_s() const noexcept { return m_landing_m_per_s; } ///< of the last landing; the drop's speed
    double energy_J() const noexcept { return 0.5 * m_mass_kg * m_v.squaredNorm() + Mass::energy(m_mass_kg, m_p.z()); }

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
