// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/apex_technique.h"

namespace chiron::operators {

namespace {
constexpr double kGain_per_s = 1.3; // stays damped with 0.4 s of reaction, feeling and arm in the loop
} // namespace

core::Vec2 towards(const core::Vec2& goal, const core::Vec2& place, double speed_m_per_s) noexcept {
    const core::Vec2 velocity = kGain_per_s * (goal - place);
    const double size = velocity.norm();
    return size > speed_m_per_s ? core::Vec2(velocity * (speed_m_per_s / size)) : velocity;
}

} // namespace chiron::operators
