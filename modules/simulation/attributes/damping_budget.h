// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace chiron::simulation {

/// No bound: for a law that is evaluated on its own, or a device that renders no force.
inline constexpr double kUnboundedDamping = std::numeric_limits<double>::infinity();

/// Keeps account of the damping (N·s/m) of one tool in one tick: the slope of friction, viscosity and contact
/// damping together. All of it acts on the same velocity, which is quantised and delayed, so a mechanism is
/// stable or not by the sum (models.md §8). Every law asks here before it damps, and the passivity controller
/// may inject what is left over. Pure except for its own account.
/// Thread: haptic; allocates nothing.
class DampingBudget {
public:
    explicit constexpr DampingBudget(double most_Ns_per_m = kUnboundedDamping) noexcept
        : m_left_Ns_per_m(std::max(0.0, most_Ns_per_m)) {}

    /// The share, 0..1, of a damper of `wanted_Ns_per_m` ≥ 0 that fits into `most_Ns_per_m`; exactly 1 where
    /// all of it fits.
    static constexpr double share(double wanted_Ns_per_m, double most_Ns_per_m) noexcept {
        return wanted_Ns_per_m > most_Ns_per_m ? std::max(0.0, most_Ns_per_m) / wanted_Ns_per_m : 1.0;
    }

    constexpr void spend(double used_Ns_per_m) noexcept {
        m_used_Ns_per_m += used_Ns_per_m;
        m_left_Ns_per_m = std::max(0.0, m_left_Ns_per_m - used_Ns_per_m);
    }
    constexpr double left_Ns_per_m() const noexcept { return m_left_Ns_per_m; }
    constexpr double used_Ns_per_m() const noexcept { return m_used_Ns_per_m; }

private:
    double m_left_Ns_per_m;
    double m_used_Ns_per_m = 0.0;
};

} // namespace chiron::simulation
