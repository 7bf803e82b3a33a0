// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/apex_technique.h"

namespace chiron::operators {

namespace {
// Stays damped with 0.4 s of delay in the loop from reaction, perception and arm
constexpr double kGain_per_s = 1.3;
} // namespace

core::Vec2 towards(const core::Vec2& goal, const core::Vec2& place, double speed_m_per_s) noexcept {
    const core::Vec2 velocity = kGain_per_s * (goal - place);
    const double size = velocity.norm();
    return size > speed_m_per_s ? core::Vec2(velocity * (speed_m_per_s / size)) : velocity;
}

} // namespace chiron::operators
