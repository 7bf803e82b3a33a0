// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"
#include "mechanisms/gimbal_kinematics.h"
#include "mechanisms/hand_parameters.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace chiron::operators {

/// An instrument as the hand that holds it feels it: position and motion of its tip, and the parts of f_z
/// that come from the instrument itself.
///   tip        p + e, b_g ė + k_g e = f: the grip yields as a spring with a damper, with a lag of 5 ms
///   own part   1, along the rod (through the port) v_a u_z, z u_z, ż u_z; m a_z;
///              across it, in x and y, z u, v u
/// z: friction builds up over a travel of kPresliding_m (ż = v − |v| z/kPresliding_m); u is the rod's
/// direction. A hand that strokes along y moves the rod through its port by v_y y/R, which is faster than its
/// tremor: friction along the rod (0.1 N) changes its sign in the middle of a stroke, whatever the height
/// does. A fit determines the amount of each part. State: grip and bristles. The choice of regressors is
/// ours.
/// Thread: haptic; allocates nothing.
class InstrumentFeel {
public:
    static constexpr std::size_t kOwn = 9;
    using Own = std::array<double, kOwn>;

    explicit InstrumentFeel(const mechanisms::HandParameters& hand) noexcept
        : m_grip_N_per_m(hand.gripStiffness_N_per_m),
          m_follows(1.0 -
                    std::exp(-core::kTickSeconds * hand.gripStiffness_N_per_m / hand.gripDamping_Ns_per_m)) {}

    /// Takes the hand's position and the force on it; call it once per tick.
    /// Unit: SI.
    /// Frame: D.
    void feel(const core::Vec3& p, const core::Vec3& f) noexcept {
        const core::Vec3 yield = f / m_grip_N_per_m;
        m_yield = m_felt > 0 ? core::Vec3(m_yield + m_follows * (yield - m_yield)) : yield;
        const core::Vec3 tip = p + m_yield;
        const core::Vec3 velocity =
            m_felt > 0 ? core::Vec3((tip - m_tip) / core::kTickSeconds) : core::Vec3(core::Vec3::Zero());
        m_acceleration = m_felt > 1 ? core::Vec3((velocity - m_velocity) / core::kTickSeconds)
                                    : core::Vec3(core::Vec3::Zero());
        m_tip = tip;
        m_velocity = velocity;
        m_felt += m_felt < 2 ? 1 : 0;
        slide();
    }
    const core::Vec3& tip() const noexcept { return m_tip; }
    const core::Vec3& velocity() const noexcept { return m_velocity; }
    /// The instrument's own part of f_z, each entry in units of its coefficient.
    const Own& own() const noexcept { return m_own; }

private:
    static constexpr double kPresliding_m = 50e-6;

    /// Advances a bristle by one tick, implicitly; it never becomes longer than 1 (in units of
    /// kPresliding_m). Returns the change.
    static double bend(double& z, double v) noexcept {
        const double before = z;
        z = (z + v * core::kTickSeconds / kPresliding_m) /
            (1.0 + std::abs(v) * core::kTickSeconds / kPresliding_m);
        return z - before;
    }
    void slide() noexcept {
        const core::Vec3 rod =
            m_tip - core::Vec3(0.0, 0.0, mechanisms::GimbalKinematics::kDefaultPivotHeight_m);
        const core::Vec3 u = rod.normalized();
        const double along = m_velocity.dot(u);
        const core::Vec3 across = m_velocity - along * u;
        const double bending = bend(m_along, along);
        bend(m_x, across.x());
        bend(m_y, across.y());
        m_own = {1.0,         along * u.z(),      m_along * u.z(), bending * u.z(),   m_acceleration.z(),
                 m_y * u.y(), across.y() * u.y(), m_x * u.x(),     across.x() * u.x()};
    }

    double m_grip_N_per_m;
    double m_follows; ///< share of its way to rest that the grip covers per tick
    core::Vec3 m_yield = core::Vec3::Zero();
    core::Vec3 m_tip = core::Vec3::Zero(), m_velocity = core::Vec3::Zero(),
               m_acceleration = core::Vec3::Zero();
    double m_along = 0.0, m_x = 0.0, m_y = 0.0; ///< bristles, −1..1
    Own m_own{};
    int m_felt = 0;
};

} // namespace chiron::operators
