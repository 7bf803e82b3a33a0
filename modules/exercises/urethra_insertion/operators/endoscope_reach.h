// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "mechanisms/hand_strategy.h"
#include "mechanisms/spherical_joint.h"

namespace chiron::operators {

/// The wished motion: speeds of the tip in the plane in which it can move, and rates of the two angles.
struct EndoscopeWish {
    double along_m_per_s = 0.0;  ///< along the instrument
    double across_m_per_s = 0.0; ///< upwards, at right angles to it
    double pitch_rad_per_s = 0.0;
    double yaw_rad_per_s = 0.0;
};

/// The motor command: turns wished speeds into a smooth desired pose. Accelerations are bounded, and so are
/// the desired angles (no wrist turns further). The instrument is not rolled. Called in every tick; allocates
/// nothing.
/// Unit: SI.
/// Frame: D.
class EndoscopeReach {
public:
    static constexpr double kAcceleration_m_per_s2 = 0.3; ///< fine movements of a held instrument: assumption
    static constexpr double kAcceleration_rad_per_s2 = 6.0; ///< assumption
    static constexpr double kLowestPitch_rad = -0.45, kHighestPitch_rad = 1.6;
    static constexpr double kWidestYaw_rad = 0.5;

    void start(const core::Vec3& p_D, const core::Quat& q_D) noexcept;
    /// `pitch_rad` is the direction that the operator believes the instrument to have.
    void wish(const EndoscopeWish& wish, double pitch_rad) noexcept;
    mechanisms::HandIntention advance() noexcept; ///< by one tick

    const core::Vec3& place_D() const noexcept { return m_place; }
    double pitch_rad() const noexcept { return m_angles.pitch; } ///< desired
    double yaw_rad() const noexcept { return m_angles.yaw; }

private:
    core::Vec3 m_place = core::Vec3::Zero();
    core::Vec3 m_velocity = core::Vec3::Zero();
    core::Vec3 m_wantedVelocity = core::Vec3::Zero();
    mechanisms::EndoscopeAngles m_angles;
    core::Vec2 m_rate = core::Vec2::Zero(); ///< pitch, yaw
    core::Vec2 m_wantedRate = core::Vec2::Zero();
};

} // namespace chiron::operators
