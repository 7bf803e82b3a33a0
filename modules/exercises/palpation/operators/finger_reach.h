// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"
#include "mechanisms/hand_strategy.h"

#include <algorithm>

namespace chiron::operators {

/// The motor command: turns a goal into a smooth desired position with bounded speed and acceleration. Called
/// in every tick; allocates nothing.
/// Unit: SI.
/// Frame: D.
class FingerReach {
public:
    /// Speed per remaining distance, so that it slows down before the goal; assumption.
    static constexpr double kGain_per_s = 22.0;
    static constexpr double kAcceleration_m_per_s2 = 4.0; ///< brisk: assumption

    void start(const core::Vec3& p_D) noexcept {
        m_place = p_D;
        m_velocity.setZero();
    }
    mechanisms::HandIntention advance(const core::Vec3& goal_D, double speed_m_per_s) noexcept {
        const core::Vec3 left = goal_D - m_place;
        const double distance = left.norm();
        core::Vec3 wish = core::Vec3::Zero();
        if (distance > 1e-9)
            wish = left * (std::min(kGain_per_s * distance, speed_m_per_s) / distance);
        const core::Vec3 change = wish - m_velocity;
        const double most = kAcceleration_m_per_s2 * core::kTickSeconds, size = change.norm();
        m_velocity += size > most ? core::Vec3(change * (most / size)) : change;
        m_place += core::kTickSeconds * m_velocity;
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = m_place;
        wanted.v_DDesired = m_velocity;
        return wanted;
    }
    const core::Vec3& place() const noexcept { return m_place; }

private:
    core::Vec3 m_place = core::Vec3::Zero();
    core::Vec3 m_velocity = core::Vec3::Zero();
};

} // namespace chiron::operators
