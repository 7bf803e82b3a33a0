// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/attributes/elasticity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace chiron::simulation {

/// Geometry of a grasper's two jaws, both hinged in one joint.
struct JawGeometry {
    double length_m = 0.020; ///< L, from the joint to the tip, > 0

    /// Distance between the tips at the opening angle: 2 L sin(angle/2), 0 at angle ≤ 0. `angle_rad` ≤ π.
    double opening_m(double angle_rad) const noexcept {
        return angle_rad > 0.0 ? 2.0 * length_m * std::sin(0.5 * angle_rad) : 0.0;
    }
    /// Angle at which the tips are that far apart, 0 ≤ opening ≤ 2 L.
    double angle_rad(double opening_m) const noexcept {
        return 2.0 * std::asin(std::clamp(opening_m / (2.0 * length_m), 0.0, 1.0));
    }
};

enum class GraspChange : std::uint8_t { none, grasped, released };

/// Decides with hysteresis when a jaw takes hold and lets go. `jaw` is its opening angle or opening, in any
/// unit that the thresholds share:
///
/// - open → held: the jaw, which has opened beyond `releaseAbove` since it was last closed, comes to
///   `graspBelow` or less while the object is within reach
/// - held → open: the jaw opens beyond `releaseAbove`
///
/// A jaw that was closed away from the object has to open first, so a closed instrument cannot spear the
/// object. graspBelow < releaseAbove. Deterministic. Use one instance per tool. Source: P2 "Analogue
/// Clamping" (a potentiometer measures the jaw, which has no motor); the thresholds are content.
/// Thread: haptic; allocates nothing.
class GraspLatch {
public:
    GraspChange update(double jaw, double graspBelow, double releaseAbove, bool withinReach) noexcept {
        if (jaw > releaseAbove) {
            m_ready = true;
            if (!m_held)
                return GraspChange::none;
            m_held = false;
            return GraspChange::released;
        }
        if (m_held || !m_ready || jaw > graspBelow)
            return GraspChange::none;
        m_ready = false;
        m_held = withinReach;
        return m_held ? GraspChange::grasped : GraspChange::none;
    }
    /// The object got away (it slipped or was taken): the jaw has to open before it can hold again.
    void lose() noexcept {
        m_held = false;
        m_ready = false;
    }
    void reset() noexcept { *this = GraspLatch(); }
    bool held() const noexcept { return m_held; }
    bool ready() const noexcept { return m_ready; } ///< opened wide enough to take hold

private:
    bool m_held = false;
    bool m_ready = false;
};

/// An object squeezed between two jaws. It is flattened by c = max(0, thickness − opening), half of it at
/// each jaw, and each half is a press of depth c/2 on the object's surface. The jaws push with N = F(c/2),
/// and the object stores 2 U(c/2).
struct Squeeze {
    double compression_m = 0.0; ///< c
    /// N, of each jaw; shown and recorded but not felt, because the jaw has no motor.
    double force_N = 0.0;
    double energy_J = 0.0;

    static Squeeze of(const ElasticLaw& law, double thickness_m, double opening_m) noexcept {
        Squeeze out;
        out.compression_m = std::max(0.0, thickness_m - opening_m);
        out.force_N = law.tension(0.5 * out.compression_m);
        out.energy_J = 2.0 * law.energy(0.5 * out.compression_m);
        return out;
    }
};

/// The load that a squeeze of N (≥ 0) can hold by friction μ at two faces: 2 μ N.
constexpr double gripLimit_N(double mu, double squeeze_N) noexcept {
    return 2.0 * mu * squeeze_N;
}

/// The part of a quasi-static load (of a massless object, a tube's pull) that the grip transmits: at most
/// `limit_N`, in the direction of the load.
struct GripLoad {
    core::Vec3 held = core::Vec3::Zero(); ///< N
    bool slips = false;                   ///< the load exceeds the limit, and the object moves along it

    static GripLoad of(const core::Vec3& load, double limit_N) noexcept {
        const double size = load.norm();
        if (!(size > limit_N))
            return {load, false};
        return {load * (limit_N / size), true};
    }
};

/// An object with mass in a grip that may slip, described by its offset s from where it was taken and its
/// speed u in the jaws:
///   m u' = load − f,  ‖f‖ ≤ limit,  and f is what stops it where that is enough (Coulomb, solved for the
///   tick: no chatter)
/// `load` is the sum of all other forces on it, seen from the jaws (m g, the bed's push, −m a of the tool).
/// At rest with ‖load‖ ≤ limit the object stays exactly where it is, and f = load. Friction never does
/// positive work. Deterministic. Source: Coulomb, implicit step as Moreau's time stepping; 2 μ N of two
/// faces.
/// Thread: haptic; allocates nothing.
class GripSlide {
public:
    /// Advances by one tick; `mass_kg` > 0. Returns the grip's force on the object, −f in the equation above.
    /// The tool receives the opposite force, so that it feels the load that it holds.
    core::Vec3 step(const core::Vec3& load_N, double limit_N, double mass_kg, double dt_s) noexcept {
        // The force that would bring it to rest within this tick
        const core::Vec3 stopping = load_N + m_velocity * (mass_kg / dt_s);
        const GripLoad grip = GripLoad::of(stopping, limit_N);
        m_slipping = grip.slips;
        m_velocity = grip.slips ? core::Vec3(m_velocity + (load_N - grip.held) * (dt_s / mass_kg))
                                : core::Vec3::Zero();
        m_offset += m_velocity * dt_s;
        // When the grip holds again after a slide, it also stops the object within this tick; the tool is
        // shown the load without that jerk.
        return grip.slips ? core::Vec3(-grip.held) : core::Vec3(-GripLoad::of(load_N, limit_N).held);
    }
    /// Starts anew with an object that has just been taken, at offset 0.
    void reset() noexcept { *this = GripSlide(); }
    bool slipping() const noexcept { return m_slipping; }
    const core::Vec3& offset() const noexcept { return m_offset; }     ///< s, m
    const core::Vec3& velocity() const noexcept { return m_velocity; } ///< u, m/s

private:
    core::Vec3 m_offset = core::Vec3::Zero();
    core::Vec3 m_velocity = core::Vec3::Zero();
    bool m_slipping = false;
};

} // namespace chiron::simulation
