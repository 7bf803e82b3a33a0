// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/palpation/surface_map.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

SurfaceMap::SurfaceMap(const core::Vec2& half_m, double padRadius_m, double coverForce_N) noexcept
    : m_half_m(half_m), m_padRadius_m(padRadius_m), m_coverForce_N(coverForce_N) {}

void SurfaceMap::clear() noexcept {
    m_force_N.fill(0.0F);
    m_covered = 0;
    ++m_step;
}

core::Vec2 SurfaceMap::middle_m(int column, int row) const noexcept {
    return {m_half_m.x() * ((2.0 * column + 1.0) / kColumns - 1.0),
            m_half_m.y() * ((2.0 * row + 1.0) / kRows - 1.0)};
}

double SurfaceMap::coverage() const noexcept {
    return static_cast<double>(m_covered) / (kColumns * kRows);
}

void SurfaceMap::press(const core::Vec2& p_m, double normalForce_N) noexcept {
    if (!p_m.allFinite() || !(normalForce_N > 0.0))
        return;
    const auto force = static_cast<float>(normalForce_N);
    const core::Vec2 cell(2.0 * m_half_m.x() / kColumns, 2.0 * m_half_m.y() / kRows);
    // Clamped as a double, because the cell of a tool far away would overflow an int.
    const auto cellOf = [](double offset_m, double size_m, int count) {
        return static_cast<int>(std::clamp(std::floor(offset_m / size_m), -1.0, static_cast<double>(count)));
    };
    const int left = std::max(0, cellOf(p_m.x() - m_padRadius_m + m_half_m.x(), cell.x(), kColumns));
    const int right =
        std::min(kColumns - 1, cellOf(p_m.x() + m_padRadius_m + m_half_m.x(), cell.x(), kColumns));
    const int low = std::max(0, cellOf(p_m.y() - m_padRadius_m + m_half_m.y(), cell.y(), kRows));
    const int high = std::min(kRows - 1, cellOf(p_m.y() + m_padRadius_m + m_half_m.y(), cell.y(), kRows));
    bool changed = false;
    for (int row = low; row <= high; ++row)
        for (int column = left; column <= right; ++column) {
            float& kept = m_force_N[index(column, row)];
            if (kept >= force || (middle_m(column, row) - p_m).squaredNorm() > m_padRadius_m * m_padRadius_m)
                continue;
            m_covered += kept < m_coverForce_N && force >= m_coverForce_N ? 1 : 0;
            kept = force;
            changed = true;
        }
    m_step += changed ? 1U : 0U;
}

} // namespace chiron::simulation
