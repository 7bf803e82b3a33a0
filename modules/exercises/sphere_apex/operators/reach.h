// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "mechanisms/hand_strategy.h"

namespace chiron::operators {

/// The motor command: turns a wished velocity into a smooth desired position. Acceleration is bounded, and so
/// is the distance of the desired position from where the trainee began (its arm is no longer). Called in
/// every tick; allocates nothing.
/// Unit: SI.
/// Frame: D.
class Reach {
public:
    static constexpr double kAcceleration_m_per_s2 = 1.5; ///< unhurried arm movements: assumption

    void start(const core::Vec3& p_D) noexcept;
    void wish(const core::Vec3& velocity_m_per_s) noexcept { m_wish = velocity_m_per_s; }
    mechanisms::HandIntention advance(std::uint32_t buttons) noexcept; ///< by one tick
    const core::Vec3& place() const noexcept { return m_place; }       ///< desired, m

private:
    core::Vec3 m_home = core::Vec3::Zero();
    core::Vec3 m_place = core::Vec3::Zero();
    core::Vec3 m_velocity = core::Vec3::Zero();
    core::Vec3 m_wish = core::Vec3::Zero();
};

} // namespace chiron::operators
