// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/midpoints_technique.h"

#include <cmath>

namespace chiron::operators {

using core::Vec2;

namespace {
constexpr double kSmoothing = 0.1;       ///< share per observation for smoothing the felt slope: 0.1 s
constexpr double kLongestSweep_s = 4.0;  ///< after this time the position reached counts as the edge
constexpr double kShortestSweep_s = 0.4; ///< within this time the slope of the edge that it leaves is ignored
} // namespace

MidpointsTechnique::MidpointsTechnique(const SphereApexOperatorSettings& settings) noexcept
    : m_edgeSlope(settings.edgeSlope), m_speed_m_per_s(settings.sweepSpeed_m_per_s) {}

void MidpointsTechnique::begin(const Percept& felt) noexcept {
    m_axis = 0;
    m_edges = 0;
    m_middle = felt.place.head<2>();
    m_slope = felt.slope;
    startSweep(Step::up, felt);
}

void MidpointsTechnique::startSweep(Step step, const Percept& felt) noexcept {
    m_step = step;
    m_turned_s = felt.time_s;
    m_line = m_middle;
    m_touchedFor_s = 0.0;
}

SurfaceWish MidpointsTechnique::look(const Percept& felt) noexcept {
    m_slope += kSmoothing * (felt.slope - m_slope);
    if (felt.touching) {
        m_touched = felt.place.head<2>();
        m_touchedFor_s += Senses::kLook_s;
    }
    const Vec2 place = felt.place.head<2>();
    const double elapsed = felt.time_s - m_turned_s;
    if (m_step == Step::centre) {
        if ((m_middle - place).norm() < 0.002 || elapsed > 2.0) {
            if (m_axis == 1)
                return {Vec2::Zero(), m_edges > 1, m_edges <= 1};
            m_axis = 1;
            startSweep(Step::up, felt);
        }
        return {towards(m_middle, place, m_speed_m_per_s), false, false};
    }
    const double direction = m_step == Step::up ? 1.0 : -1.0;
    const bool steep = direction * m_slope[m_axis] > m_edgeSlope;
    const bool gone = !felt.touching && m_touchedFor_s > kShortestSweep_s;
    if ((steep && elapsed > kShortestSweep_s) || gone || elapsed > kLongestSweep_s) {
        m_edges += steep || gone;
        if (m_step == Step::up) {
            m_edge = m_touched[m_axis];
            startSweep(Step::down, felt);
        } else {
            m_middle[m_axis] = 0.5 * (m_edge + m_touched[m_axis]);
            startSweep(Step::centre, felt);
        }
    }
    Vec2 velocity = towards(m_line, place, m_speed_m_per_s);
    velocity[m_axis] = direction * m_speed_m_per_s;
    return {velocity, false, false};
}

} // namespace chiron::operators
