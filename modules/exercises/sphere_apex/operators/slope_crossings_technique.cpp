// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/slope_crossings_technique.h"

namespace chiron::operators {

using core::Vec2;

namespace {
constexpr double kSettled_m = 0.005;
constexpr double kForgetting_s = 8.0; ///< about the duration of a cross: assumption
} // namespace

SlopeCrossingsTechnique::SlopeCrossingsTechnique(const SphereApexOperatorSettings& settings) noexcept
    : m_firstHalfWidth_m(settings.sweepHalfWidth_m), m_speed_m_per_s(settings.sweepSpeed_m_per_s),
      m_crosses(settings.crosses), m_fit(kForgetting_s, Senses::kLook_s) {}

void SlopeCrossingsTechnique::begin(const Percept& felt) noexcept {
    m_axis = 0;
    m_cross = 0;
    m_halfWidth_m = m_firstHalfWidth_m;
    m_apex = felt.place.head<2>();
    m_before = m_apex;
    m_fit.clear();
    enter(Step::toStart, felt);
}

void SlopeCrossingsTechnique::enter(Step step, const Percept& felt) noexcept {
    m_step = step;
    m_entered_s = felt.time_s;
}

Vec2 SlopeCrossingsTechnique::goal() const noexcept {
    Vec2 end = m_apex;
    end[m_axis] += m_step == Step::forth ? m_halfWidth_m : -m_halfWidth_m;
    return end;
}

SurfaceWish SlopeCrossingsTechnique::look(const Percept& felt) noexcept {
    const Vec2 place = felt.place.head<2>();
    const Vec2 end = goal();
    if (felt.touching)
        m_fit.add(place, felt.slope);
    const double longest_s = 0.5 + 4.0 * m_halfWidth_m / m_speed_m_per_s;
    const double missing = (end - place)[m_axis] * (m_step == Step::forth ? 1.0 : -1.0);
    if (missing < 0.001 || felt.time_s - m_entered_s > longest_s) {
        if (m_step == Step::back) {
            const SurfaceWish wish = finishAxis();
            enter(Step::toStart, felt);
            return wish;
        }
        enter(m_step == Step::toStart ? Step::forth : Step::back, felt);
    }
    SurfaceWish wish;
    wish.velocity = towards(end, place, m_speed_m_per_s);
    if (m_step != Step::toStart)
        wish.velocity[m_axis] = m_step == Step::forth ? m_speed_m_per_s : -m_speed_m_per_s;
    return wish;
}

SurfaceWish SlopeCrossingsTechnique::finishAxis() noexcept {
    SurfaceWish wish;
    Vec2 apex = m_apex;
    const bool hill = m_fit.apex(apex);
    // An apex far outside the sweeps is a guess: go to the end of the sweeps and look again.
    const Vec2 step = apex - m_apex;
    m_apex += step.norm() > m_firstHalfWidth_m ? Vec2(step * (m_firstHalfWidth_m / step.norm())) : step;
    if (m_axis == 0) {
        m_axis = 1;
        return wish;
    }
    m_axis = 0;
    ++m_cross;
    m_halfWidth_m = m_firstHalfWidth_m * (2.0 / 3.0);
    const bool settled = (m_apex - m_before).norm() < kSettled_m;
    m_before = m_apex;
    wish.noHill = !hill;
    wish.done = hill && (m_cross > m_crosses || (m_cross >= m_crosses && settled));
    return wish;
}

} // namespace chiron::operators
