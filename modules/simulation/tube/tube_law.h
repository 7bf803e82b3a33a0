// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/elasticity.h"

#include <algorithm>

namespace chiron::simulation {

/// Tension of the whole tube as a function of its stretch x beyond the rest length L₀ (m). It is the tube's
/// elasticity, zero when slack:
///   T(x) = k x,  or with strain stiffening  T(x) = (k/b)(e^{bx} − 1);  U(x) = ∫₀ˣ T
/// Beyond `limit_m` (where the tube tears) the tension keeps its value, so that nothing overflows when a hand
/// moves far away during a pause. The law has been checked up to there (models.md §2.4). T and U are
/// continuous, and so is T′ except at 0 and at the limit. Pure. Source: P2 "Elastic Tube Model"; models.md
/// §2.2, §2.4. Unit: N, J, N/m. Thread: any.
struct TubeLaw {
    ElasticLaw elastic{100.0, 0.0};
    double viscosity_Ns_per_m = 0.0; ///< ≥ 0, along the tube, for its whole length
    double limit_m = 1.0;            ///< > 0

    double tension_N(double x_m) const noexcept { return elastic.tension(std::clamp(x_m, 0.0, limit_m)); }
    double energy_J(double x_m) const noexcept {
        const double beyond_m = std::max(0.0, x_m - limit_m);
        return elastic.energy(std::clamp(x_m, 0.0, limit_m)) + beyond_m * elastic.tension(limit_m);
    }
    /// dT/dx; 0 when slack and beyond the limit.
    double slope_N_per_m(double x_m) const noexcept {
        return x_m > 0.0 && x_m <= limit_m ? elastic.slope(x_m) : 0.0;
    }
};

} // namespace chiron::simulation
