// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace chiron::session {

/// A point dragged behind the tool on a rope: taut, it says that the tool slides, and which way. A clipped bristle (bristle_friction.h) is
/// dragged in the same way, on a rope of μ f_n/σ₀; so where one that is surely longer is taut, all of μ f_n is rendered. After a turn that takes twice
/// the length, 3.5 mm at μ = 1 and 1.75 N: no speed and no fixed distance tells it. Pure.
class SlidingTrail {
public:
    void drag(double x_m, double y_m, double length_m) noexcept { ///< the tool moves on by so much
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
    /// The share of a force that holds the tool back; the trail has to be taut.
    double against(double x_N, double y_N) const noexcept { return -(x_N * m_behind[0] + y_N * m_behind[1]) / m_length_m; }

private:
    std::array<double, 2> m_behind{}; ///< from the dragged point to the tool
    double m_length_m = 0.0;
    bool m_taut = false;
};

} // namespace chiron::session
