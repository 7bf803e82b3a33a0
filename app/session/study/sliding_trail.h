// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace chiron::session {

/// A point dragged behind the tool on a virtual rope: while the rope is taut, the tool slides in its
/// direction. A clipped bristle (bristle_friction.h) is dragged in the same way, on a rope of length μ
/// f_n/σ₀; so if a rope that is certainly longer is taut, the full μ f_n is rendered. After a change of
/// direction this takes twice the length, 3.5 mm at μ = 1 and 1.75 N, which no speed and no fixed distance
/// can detect. Pure.
class SlidingTrail {
public:
    void drag(double x_m, double y_m, double length_m) noexcept { ///< the tool moves by this distance
        m_behind[0] += x_m;
        m_behind[1] += y_m;
        const double now_m = std::hypot(m_behind[0], m_behind[1]);
        m_taut = now_m > length_m && length_m > 0.0;
        if (m_taut)
            for (double& along : m_behind)
                along *= length_m / now_m;
        m_length_m = length_m;
    }
    bool taut() const noexcept { return m_taut; }
    /// The component of a force that holds the tool back; requires a taut trail.
    double against(double x_N, double y_N) const noexcept {
        return -(x_N * m_behind[0] + y_N * m_behind[1]) / m_length_m;
    }

private:
    std::array<double, 2> m_behind{}; ///< vector from the dragged point to the tool
    double m_length_m = 0.0;
    bool m_taut = false;
};

} // namespace chiron::session
