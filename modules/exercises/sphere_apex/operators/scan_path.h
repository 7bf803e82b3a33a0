// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::operators {

/// Parallel lines over a disc: the middle one first, then alternately on either side, in alternating
/// direction. Odd legs are the lines, even legs lead to their starting points. It only keeps account, in felt
/// coordinates.
class ScanPath {
public:
    ScanPath(double radius_m, double spacing_m) noexcept;
    void begin() noexcept { m_leg = 0; }
    bool next() noexcept; ///< to the next leg; false after the last line
    bool onLine() const noexcept { return m_leg % 2 == 1; }
    core::Vec2 end() const noexcept; ///< end of the present leg, relative to the centre of the disc

private:
    double m_radius_m;
    double m_spacing_m;
    int m_lines;
    int m_leg = 0;
};

} // namespace chiron::operators
