// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/cues/canal_reach.h"

#include <cmath>

namespace chiron::simulation {

/// Decides from poses alone whether the shaft is in the canal. The shaft enters only through the meatus, and
/// it is out as soon as its tip is before the meatus again. To enter, the tip has to pass s = −ℓ, where the
/// end of the beak is at the entrance and every force is still 0, within `radius_m` of the centre-line. A tip
/// that passes there farther off is beside the canal, wherever it moves then. A tip that lies beyond that
/// point before any movement was seen is in the canal if it is within kCanalReach_m. A radius of 0
/// means that there is no meatus and everything is canal. Deterministic, fixed size.
/// Thread: any.
class MeatusGate {
public:
    MeatusGate(double radius_m, double beak_m) noexcept : m_radius_m(radius_m), m_beak_m(beak_m) {}

    /// Takes in the next position of the tip: the arc length of its foot and its distance from the
    /// centre-line. Returns true if it is in the canal.
    bool step(double s_m, double offset_m) noexcept {
        if (!(m_radius_m > 0.0))
            return m_inside = true;
        if (s_m <= -m_beak_m) {
            m_inside = false;
        } else if (!m_known) {
            m_inside = offset_m <= kCanalReach_m;
        } else if (m_s_m <= -m_beak_m) {
            const double x = (-m_beak_m - m_s_m) / (s_m - m_s_m);
            m_inside = m_offset_m + x * (offset_m - m_offset_m) <= m_radius_m;
        }
        m_known = true;
        m_s_m = s_m;
        m_offset_m = offset_m;
        return m_inside;
    }
    bool inside() const noexcept { return m_inside; }
    void forget() noexcept { m_known = false; } ///< treats the next position as the first one

private:
    double m_radius_m;
    double m_beak_m;
    double m_s_m = 0.0;
    double m_offset_m = 0.0;
    bool m_known = false;
    bool m_inside = false;
};

} // namespace chiron::simulation
