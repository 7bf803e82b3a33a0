// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace chiron::simulation {

/// Says when tissue gives way and how fast its force falls from then on. Data of a level or a tissue; by
/// default tissue never gives way.
struct YieldLaw {
    /// > 0: yield force F_y, the largest force that the tissue ever exerts.
    double force_N = std::numeric_limits<double>::infinity();
    /// > 0: duration T of the fall from the yield force to zero.
    double fall_s = 0.020;
    /// > 0: yield torque τ_y, the largest torque that the tissue ever exerts.
    double torque_Nm = std::numeric_limits<double>::infinity();
};

/// Decides how much of its force tissue still exerts on one tool: all of it, then a falling share, then
/// nothing until the tool has left the tissue. With the load ℓ = max(‖f‖/F_y, ‖τ‖/τ_y):
///
///   factor = 1                                  while ℓ ≤ 1
///   factor = min(1, (1 − smoothstep(t/T)) / ℓ)  at time t after ℓ first exceeded 1
///   factor = 0                                  from t = T until the tool is outside
///
/// The force therefore never exceeds F_y and the torque never exceeds τ_y. Both are continuous, and the fall
/// changes them by at most 1.5 F_y dt/T and 1.5 τ_y dt/T per tick. The law only takes energy, because the
/// stored energy is not given back. If the tool already lies too deep in the first tick (of a trial, or after
/// an object appears), it did not get there by pressing through the tissue: it touches nothing until it is
/// outside, and this does not count as yielding. Multiply a contact's force, torque, stored energy and
/// stiffness by the factor. Use one instance for each pair of tool and body. Fixed size.
///
/// Thread: haptic.
class TissueYield {
public:
    TissueYield() noexcept = default;
    explicit TissueYield(const YieldLaw& law) noexcept : m_law(law) {}

    /// Advances by one tick of `dt_s` and returns the factor. `wanted_N` and `wanted_Nm` ≥ 0 are the force
    /// and torque of the law. `outside`: the tool does not touch this body. `breached`: the tool is at a pose
    /// for which the law is not defined, and the tissue gives way whatever its load is there.
    double step(double wanted_N, bool outside, double dt_s, double wanted_Nm = 0.0,
                bool breached = false) noexcept {
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
    bool yielded() const noexcept { return m_yielded; } ///< in the last step
    bool through() const noexcept { return m_through; }
    void reset() noexcept { *this = TissueYield(m_law); } ///< for a new trial: the tissue is whole again

private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();
    static double share(double left, double from, double wanted) noexcept {
        const double most = from < kNever ? left * from : kNever;
        return wanted > most ? most / wanted : 1.0;
    }
    /// Sets where the fall starts. Tissue that breaks under a load below its yield load falls from that load;
    /// tissue without a yield force falls from its present force.
    void fallFrom(double load, double wanted_N) noexcept {
        m_from_N = m_law.force_N < kNever ? load * m_law.force_N : wanted_N;
        m_from_Nm = m_law.torque_Nm < kNever ? load * m_law.torque_Nm : kNever;
    }

    YieldLaw m_law;
    double m_since_s = 0.0;
    double m_from_N = 0.0; ///< force from which the fall starts
    double m_from_Nm = 0.0;
    bool m_fresh = true; ///< no step has been made yet
    bool m_through = false;
    bool m_yielded = false;
};

} // namespace chiron::simulation
