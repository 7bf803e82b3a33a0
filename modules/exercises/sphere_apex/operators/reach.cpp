// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/reach.h"

#include "core/units.h"

#include <algorithm>

namespace chiron::operators {

using core::Vec3;

namespace {
constexpr double kReachAcross_m = 0.080;
constexpr double kReachDown_m = 0.090;
constexpr double kReachUp_m = 0.030;
} // namespace

void Reach::start(const Vec3& p_D) noexcept {
    m_home = p_D;
    m_place = p_D;
    m_velocity.setZero();
    m_wish.setZero();
}

mechanisms::HandIntention Reach::advance(std::uint32_t buttons) noexcept {
    const Vec3 change = m_wish - m_velocity;
    const double most = kAcceleration_m_per_s2 * core::kTickSeconds;
    const double size = change.norm();
    m_velocity += size > most ? Vec3(change * (most / size)) : change;
    m_place += core::kTickSeconds * m_velocity;
    const Vec3 low = m_home - Vec3(kReachAcross_m, kReachAcross_m, kReachDown_m);
    const Vec3 high = m_home + Vec3(kReachAcross_m, kReachAcross_m, kReachUp_m);
    for (int axis = 0; axis < 3; ++axis) {
        if (m_place[axis] < low[axis] || m_place[axis] > high[axis]) {
            m_place[axis] = std::clamp(m_place[axis], low[axis], high[axis]);
            m_velocity[axis] = 0.0;
        }
    }
    mechanisms::HandIntention wanted;
    wanted.p_DDesired = m_place;
    wanted.v_DDesired = m_velocity;
    wanted.buttons = buttons;
    return wanted;
}

} // namespace chiron::operators
