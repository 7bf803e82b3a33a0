// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "mechanisms/hand_strategy.h"

namespace chiron::operators {

/// How a laparoscopist's hand follows its intention.
struct GraspReachSettings {
    double acceleration_m_per_s2 = 0.5; ///< largest acceleration
    double smoothing_s = 0.12;          ///< time constant of the smoothing
};

/// The wish of the decision model for one hand until its next percept. Velocities are in the frame that reach
/// and wish share.
struct GraspWish {
    core::Vec3 velocity_m_per_s = core::Vec3::Zero();
    double jaw_rad = 0.0;            ///< wanted opening
    double jawSpeed_rad_per_s = 1.0; ///< speed of opening or closing
};

/// The motor command: it turns a wished velocity into a smooth desired position and a wished opening into a
/// moving jaw. Acceleration is bounded, and so is the desired position (to the reach of the instrument
/// through its entry point). Runs every tick.
/// Unit: SI.
/// Frame: D.
/// Thread: haptic; allocates nothing.
class GraspReach {
public:
    static constexpr double kAcross_m = 0.130; ///< either side of the point under the entry point
    static constexpr double kLowest_m = -0.015;
    static constexpr double kHighest_m = 0.098; ///< the pivot is 180 mm above the table, and the shortest
                                                ///< depth is 80 mm
    static constexpr double kWidest_rad = 1.6;

    explicit GraspReach(const GraspReachSettings& settings) noexcept : m_settings(settings) {}
    void start(const core::Vec3& p_D) noexcept;
    void wish(const GraspWish& wish_D) noexcept { m_wish = wish_D; }
    mechanisms::HandIntention advance() noexcept; ///< by one tick
    const core::Vec3& place() const noexcept { return m_place; }
    double jaw_rad() const noexcept { return m_jaw_rad; }

private:
    GraspReachSettings m_settings;
    core::Vec3 m_place = core::Vec3::Zero();
    core::Vec3 m_velocity = core::Vec3::Zero();
    double m_jaw_rad = 0.0;
    GraspWish m_wish;
};

} // namespace chiron::operators
