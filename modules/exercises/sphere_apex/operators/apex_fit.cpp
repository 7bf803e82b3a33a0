// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/apex_fit.h"

#include <cmath>

namespace chiron::operators {

using core::Vec2;

ApexFit::ApexFit(double forgetting_s, double look_s) noexcept : m_keep(std::exp(-look_s / forgetting_s)) {}

void ApexFit::clear() noexcept {
    m_n = 0.0;
    m_place.setZero();
    m_slope.setZero();
    m_placePlace = 0.0;
    m_placeSlope = 0.0;
}

void ApexFit::add(const Vec2& place, const Vec2& slope) noexcept {
    m_n = m_keep * m_n + 1.0;
    m_place = m_keep * m_place + place;
    m_slope = m_keep * m_slope + slope;
    m_placePlace = m_keep * m_placePlace + place.squaredNorm();
    m_placeSlope = m_keep * m_placeSlope + place.dot(slope);
}

double ApexFit::steepening_per_m() const noexcept {
    if (m_n < 100.0) // a second of observations
        return 0.0;
    const double spread = m_placePlace - m_place.squaredNorm() / m_n;
    const double together = m_placeSlope - m_place.dot(m_slope) / m_n;
    return spread > 0.0 ? together / spread : 0.0;
}

bool ApexFit::apex(Vec2& place) const noexcept {
    const double b = steepening_per_m();
    if (!(b > kHill_per_m))
        return false;
    place = (m_place - m_slope / b) / m_n;
    return true;
}

} // namespace chiron::operators
