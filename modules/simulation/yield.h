// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace chiron::simulation {

/// When tissue gives way, and how fast what it answers falls then. Data of a level or a tissue; by default it never does.
struct YieldLaw {
    double force_N = std::numeric_limits<double>::infinity();   ///< > 0: the most that the tissue ever answers
    double fall_s = 0.020;                                       ///< > 0: from the yield force to nothing
    double torque_Nm = std::numeric_limits<double>::infinity(); ///< > 0: the most that it ever turns back with
};

/// Tissue that gives way under one tool: whole, then falling, then nothing until the tool has come out of it. With the load
/// ℓ = max(‖f‖/F_y, ‖τ‖/τ_y):
///
///   factor = 1                                  while ℓ ≤ 1
///   factor = min(1, (1 − smoothstep(t/T)) / ℓ)  t after ℓ first passed 1
///   factor = 0                                  from t = T until the tool is outside
///
/// so that the force never exceeds F_y nor the torque τ_y, both are continuous, and change by at most 1.5 F_y dt/T and 1.5 τ_y dt/T in a
/// tick by the fall. It only takes energy: what was stored is not given back. A tool that is found from the first tick on (of a trial, of an
/// object that appears) where tissue would have to bear more has not come there through it: it touches nothing until it is outside, and
/// nothing has yielded. Scale all of a contact's force and torque, its stored energy and its stiffness by the factor.
/// One object for each tool and body that it may break. Fixed size; thread: haptic.
class TissueYield {
public:
    TissueYield() noexcept = default;
    explicit TissueYield(const YieldLaw& law) noexcept : m_law(law) {}

    /// One tick of `dt_s`. `wanted_N` and `wanted_Nm` ≥ 0 are what the law answers; `outside`: the tool touches nothing of this body;
    /// `breached`: the tool is where the law has no place, and the tissue gives way under whatever load it has there.
    double step(double wanted_N, bool outside, double dt_s, double wanted_Nm = 0.0, bool breached = false) noexcept {
        m_yielded = false;
        const bool found = m_fresh;
        m_fresh = false;
        if (outside) {
            m_through = false;
            return 1.0;
        }
        if (!m_through) {
            const double load = std::max(wanted_N / m_law.force_N, wanted_Nm / m_law.torque_Nm);
            if (!(load > 1.0) && !breached)
                return 1.0;
            m_through = true;
            m_yielded = !found;
            m_since_s = found ? m_law.fall_s : 0.0;
            fallFrom(std::min(1.0, load), wanted_N);
        } else {
            m_since_s += dt_s;
        }
        const double x = std::min(1.0, m_since_s / m_law.fall_s);
        const double left = 1.0 - x * x * (3.0 - 2.0 * x);
        return std::min(share(left, m_from_N, wanted_N), share(left, m_from_Nm, wanted_Nm));
    }
    bool yielded() const noexcept { return m_yielded; } ///< at the last step
    bool through() const noexcept { return m_through; }
    void reset() noexcept { *this = TissueYield(m_law); } ///< a new trial: whole tissue

private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();
    static double share(double left, double from, double wanted) noexcept {
        const double most = from < kNever ? left * from : kNever;
        return wanted > most ? most / wanted : 1.0;
    }
    /// What breaks under a smaller load than it bears falls from that one; without a yield force, from the force it has.
    void fallFrom(double load, double wanted_N) noexcept {
        m_from_N = m_law.force_N < kNever ? load * m_law.force_N : wanted_N;
        m_from_Nm = m_law.torque_Nm < kNever ? load * m_law.torque_Nm : kNever;
    }

    YieldLaw m_law;
    double m_since_s = 0.0;
    double m_from_N = 0.0;  ///< from here it falls
    double m_from_Nm = 0.0;
    bool m_fresh = true; ///< no tick has been seen
    bool m_through = false;
    bool m_yielded = false;
};

} // namespace chiron::simulation
