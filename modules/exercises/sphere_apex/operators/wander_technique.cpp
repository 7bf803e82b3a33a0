// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/wander_technique.h"

#include "core/units.h"

#include <cmath>

namespace chiron::operators {

using core::Vec2;

WanderTechnique::WanderTechnique(const SphereApexOperatorSettings& settings, std::uint64_t seed) noexcept
    : m_radius_m(settings.wanderRadius_m), m_speed_m_per_s(settings.sweepSpeed_m_per_s),
      m_time_s(settings.wanderTime_s), m_random(core::Random::stream(seed, "sphere_apex/wander")) {}

void WanderTechnique::begin(const Percept& felt) noexcept {
    m_middle = felt.place.head<2>();
    m_highestPlace = m_middle;
    m_highest_m = felt.place.z();
    m_began_s = felt.time_s;
    chooseGoal();
    m_goalBegan_s = felt.time_s;
}

void WanderTechnique::resume(const Percept& felt) noexcept {
    m_middle = felt.place.head<2>(); // the highest place so far stays remembered
    chooseGoal();
    m_goalBegan_s = felt.time_s;
}

void WanderTechnique::chooseGoal() noexcept {
    const double radius = m_radius_m * std::sqrt(m_random.uniform());
    const double angle = m_random.uniform(0.0, 2.0 * core::kPi);
    m_goal = m_middle + radius * Vec2(std::cos(angle), std::sin(angle));
}

SurfaceWish WanderTechnique::look(const Percept& felt) noexcept {
    const Vec2 place = felt.place.head<2>();
    if (felt.touching && felt.place.z() > m_highest_m) {
        m_highest_m = felt.place.z();
        m_highestPlace = place;
    }
    if ((m_goal - place).norm() < 0.003 || felt.time_s - m_goalBegan_s > 1.5) {
        chooseGoal();
        m_goalBegan_s = felt.time_s;
    }
    return {towards(m_goal, place, m_speed_m_per_s), felt.time_s - m_began_s > m_time_s, false};
}

} // namespace chiron::operators
