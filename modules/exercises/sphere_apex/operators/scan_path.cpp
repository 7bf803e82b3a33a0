// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/operators/scan_path.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

ScanPath::ScanPath(double radius_m, double spacing_m) noexcept
    : m_radius_m(radius_m), m_spacing_m(spacing_m), m_lines(1 + 2 * static_cast<int>(radius_m / spacing_m)) {}

bool ScanPath::next() noexcept {
    ++m_leg;
    return m_leg < 2 * m_lines;
}

core::Vec2 ScanPath::end() const noexcept {
    const int line = m_leg / 2;
    const double offset = m_spacing_m * ((line + 1) / 2) * (line % 2 == 1 ? 1.0 : -1.0);
    const double half = std::sqrt(std::max(0.0, m_radius_m * m_radius_m - offset * offset));
    const bool rightwards = line % 2 == 0;
    return {onLine() == rightwards ? half : -half, offset};
}

} // namespace chiron::operators
