// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/lumen_sight.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

LumenSight::View LumenSight::look(const core::Vec3& p_A, const core::Vec3& axis_A,
                                  const CentrelineFoot& foot) const noexcept {
    Rings rings;
    View view;
    for (std::size_t n = ringsAhead(p_A, foot, rings); n > 0; --n) {
        const core::Vec3& to = rings[n - 1].toMiddle;
        if (to.dot(axis_A) >= m_cosHalfView * to.norm() && passes(rings, n - 1)) {
            view.open = true;
            view.p_A = p_A + to;
            return view;
        }
    }
    return view;
}

std::size_t LumenSight::ringsAhead(const core::Vec3& p_A, const CentrelineFoot& foot,
                                   Rings& rings) const noexcept {
    const double tip_s_m = foot.at.s_m;
    const double first = std::ceil(tip_s_m / kStep_m) + 1.0;
    const std::size_t from = first > 0.0 ? static_cast<std::size_t>(first) : 0;
    const core::Vec3 e_A = foot.ex_m * core::Vec3::UnitX() + foot.en_m * foot.at.n_A;
    std::size_t count = 0;
    for (std::size_t i = from; i < m_stations.size() && count < kAhead; ++i) {
        const Station& station = m_stations[i];
        const double open = m_wall.opening(station.s_m, tip_s_m);
        const double stretched_m =
            station.radius_m + std::max(0.0, m_wall.endoscope().radius_m - station.radius_m) * open;
        rings[count].toMiddle = station.p_A + open * e_A - p_A;
        rings[count].radius2_m2 = stretched_m * stretched_m;
        ++count;
    }
    return count;
}

bool LumenSight::passes(const Rings& rings, std::size_t target) noexcept {
    const core::Vec3& to = rings[target].toMiddle;
    const double length2 = to.squaredNorm();
    for (std::size_t i = 0; i < target; ++i) {
        const core::Vec3& middle = rings[i].toMiddle;
        const double along = middle.dot(to);
        if (middle.squaredNorm() * length2 - along * along > rings[i].radius2_m2 * length2)
            return false;
    }
    return true;
}

} // namespace chiron::simulation
