// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace chiron::simulation {

/// When tissue gives way, and how fast what it answers falls then. Data of a level or a tissue; by default it never does.
struct YieldLaw {
    double force_N = std::numeric_limits<double>::infinity(); ///< > 0: the most that the tissue ever answers
    double fall_s = 0.020;                                     ///< > 0: from the yield force to nothing
};

/// Tissue that gives way under one tool: whole, then falling, then nothing until the tool has come out of it.
///
///   factor = 1                                             while ‖f‖ ≤ F_y
///   factor = min(1, F_y (1 − smoothstep(t/T)) / ‖f‖)       t after ‖f‖ first passed F_y
///   factor = 0                                             from t = T until the tool is outside
///
/// so that the force never exceeds F_y, is continuous, and changes by at most 1.5 F_y dt/T in a tick by the fall. It only takes energy:
/// what was stored is not given back. Scale all of a contact's force and torque, its stored energy and its stiffness by the factor.
/// One object for each tool and body that it may break. Fixed size; thread: haptic.
class TissueYield {
public:
    TissueYield() noexcept = default;
    explicit TissueYield(const YieldLaw& law) noexcept : m_law(law) {}

    /// One tick of `dt_s`. `wanted_N` ≥ 0 is what the law answers; `outside`: the tool touches nothing of this body.
    double step(double wanted_N, bool outside, double dt_s) noexcept {
        m_yielded = false;
        if (outside) {
            m_through = false;
            return 1.0;
        }
        if (!m_through) {
            if (!(wanted_N > m_law.force_N))
                return 1.0;
            m_through = m_yielded = true;
            m_since_s = 0.0;
        } else {
            m_since_s += dt_s;
        }
        const double x = std::min(1.0, m_since_s / m_law.fall_s);
        const double left_N = m_law.force_N * (1.0 - x * x * (3.0 - 2.0 * x));
        return wanted_N > left_N ? left_N / wanted_N : 1.0;
    }
    bool yielded() const noexcept { return m_yielded; } ///< at the last step
    bool through() const noexcept { return m_through; }
    void reset() noexcept { m_through = m_yielded = false; } ///< a new trial: whole tissue

private:
    YieldLaw m_law;
    double m_since_s = 0.0;
    bool m_through = false;
    bool m_yielded = false;
};

} // namespace chiron::simulation
