// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/laparoscopy/grasp_reach.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec3;

void GraspReach::start(const Vec3& p_D) noexcept {
    m_place = p_D;
    m_velocity.setZero();
    m_jaw_rad = 0.0;
    m_wish = {};
}

mechanisms::HandIntention GraspReach::advance() noexcept {
    const double dt = core::kTickSeconds;
    const double share = dt / (dt + std::max(0.0, m_settings.smoothing_s));
    const Vec3 change = share * (m_wish.velocity_m_per_s - m_velocity);
    const double most = m_settings.acceleration_m_per_s2 * dt;
    const double size = change.norm();
    m_velocity += size > most ? Vec3(change * (most / size)) : change;
    m_place += dt * m_velocity;
    const Vec3 low(-kAcross_m, -kAcross_m, kLowest_m), high(kAcross_m, kAcross_m, kHighest_m);
    for (int axis = 0; axis < 3; ++axis) {
        if (m_place[axis] < low[axis] || m_place[axis] > high[axis]) {
            m_place[axis] = std::clamp(m_place[axis], low[axis], high[axis]);
            m_velocity[axis] = 0.0;
        }
    }
    const double turn = std::abs(m_wish.jawSpeed_rad_per_s) * dt;
    m_jaw_rad = std::clamp(m_jaw_rad + std::clamp(m_wish.jaw_rad - m_jaw_rad, -turn, turn), 0.0, kWidest_rad);
    mechanisms::HandIntention wanted;
    wanted.p_DDesired = m_place;
    wanted.v_DDesired = m_velocity;
    wanted.jaw_rad = m_jaw_rad;
    return wanted;
}

} // namespace chiron::operators
