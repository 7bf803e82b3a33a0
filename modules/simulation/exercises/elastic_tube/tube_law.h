// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

/// Tension of the whole tube over its stretch x beyond the rest length L₀ (m), zero when slack:
///   T(x) = k x,  or with strain stiffening  T(x) = (k/b)(e^{bx} − 1);  U(x) = ∫₀ˣ T
/// Beyond `limit_m` (where it tears) tension stays what it is there, so that nothing overflows. N, J, N/m. T and U are
/// continuous, T′ is but at 0 and at the limit. Pure. Thread: any. Source: P2 "Elastic Tube Model"; models.md §2.2, §2.4.
struct TubeLaw {
    double stiffness_N_per_m = 100.0; ///< k > 0, small-strain slope
    double stiffening_per_m = 0.0;    ///< b ≥ 0; 0: linear
    double viscosity_Ns_per_m = 0.0;  ///< ≥ 0, along the tube, of its whole length
    double limit_m = 1.0;             ///< > 0

    double tension_N(double x_m) const noexcept {
        const double x = std::clamp(x_m, 0.0, limit_m);
        if (stiffening_per_m == 0.0)
            return stiffness_N_per_m * x;
        return stiffness_N_per_m / stiffening_per_m * std::expm1(stiffening_per_m * x);
    }
    double energy_J(double x_m) const noexcept {
        const double x = std::clamp(x_m, 0.0, limit_m);
        const double beyond = std::max(0.0, x_m - limit_m) * tension_N(limit_m);
        if (stiffening_per_m == 0.0)
            return 0.5 * stiffness_N_per_m * x * x + beyond;
        const double b = stiffening_per_m;
        return stiffness_N_per_m / b * (std::expm1(b * x) / b - x) + beyond;
    }
    /// dT/dx; 0 when slack and beyond the limit.
    double slope_N_per_m(double x_m) const noexcept {
        if (!(x_m > 0.0) || x_m > limit_m)
            return 0.0;
        return stiffness_N_per_m * std::exp(stiffening_per_m * x_m);
    }
};

} // namespace chiron::simulation
