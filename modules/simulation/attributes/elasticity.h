// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::simulation {

/// Elastic contact as a potential: U = ½ k d² (J), f = −∇U = −k d ∇d − ½ d² ∇k (N, on the tool, W). `depth_m`
/// ≥ 0; `depthGradient` = ∇d (−n for a smooth surface; −n + ∇h with a micro-height h); `stiffness_N_per_m` =
/// k and its gradient are taken at the tool's position. The second term is a lateral force; without it a
/// press–slide–lift loop over a stiff lump would create energy. Pure. Conservative. Source: models.md §0,
/// §2.2.
struct Elasticity {
    static double energy(double stiffness_N_per_m, double depth_m) noexcept {
        return 0.5 * stiffness_N_per_m * depth_m * depth_m;
    }
    static core::Vec3 force(double stiffness_N_per_m, const core::Vec2& stiffnessGradient_N_per_m2,
                            double depth_m, const core::Vec3& depthGradient) noexcept {
        core::Vec3 f = -stiffness_N_per_m * depth_m * depthGradient;
        const double lateral = 0.5 * depth_m * depth_m;
        f.x() -= lateral * stiffnessGradient_N_per_m2.x();
        f.y() -= lateral * stiffnessGradient_N_per_m2.y();
        return f;
    }
};

/// Elasticity along one line, with or without strain stiffening, as a function of the extension (or depth) x
/// in m:
///   b = 0:  f = −k x,                   U = ½ k x²
///   b > 0:  f = −(k/b) (e^{bx} − 1),    U = (k/b²) (e^{bx} − 1 − bx)
/// k is the stiffness at small strain (N/m, ≥ 0) and b the stiffening (1/m, ≥ 0); the slope k e^{bx} doubles
/// every 0.69/b metres. The limit b → 0 is exact: below b|x| = 0.1 both expressions are summed as series.
/// Beyond b x = kLargestExponent the law continues linearly with the force and slope that it has there, so
/// that no input overflows; this is far outside what a device renders (the slope there is 5·10⁸ k). For x < 0
/// the force acts in the opposite direction; a caller that has slack (a tube) or must not pull (a contact)
/// evaluates only x > 0. Pure; conservative. Source: P2 "Elastic Tube Model"; models.md §2.2 (small-strain
/// slope a there is k here).
struct ElasticLaw {
    static constexpr double kLargestExponent = 20.0;
    /// Bound of b|x|; above it expm1(u) − u loses less than 5·10⁻¹⁵.
    static constexpr double kSeriesBelow = 0.1;

    double stiffness_N_per_m = 0.0; ///< k
    double stiffening_per_m = 0.0;  ///< b

    /// Returns −f (N), which rises with x.
    double tension(double x_m) const noexcept {
        if (stiffening_per_m == 0.0) // the usual case, bit for bit the linear law
            return stiffness_N_per_m * x_m;
        const double u = stiffening_per_m * x_m;
        if (std::abs(u) < kSeriesBelow)
            return stiffness_N_per_m * x_m * (1.0 + u * excess(u));
        if (u > kLargestExponent)
            return tensionAtEnd() + endSlope() * (x_m - end_m());
        return stiffness_N_per_m / stiffening_per_m * std::expm1(u);
    }

    /// Returns U (J), ≥ 0.
    double energy(double x_m) const noexcept {
        if (stiffening_per_m == 0.0)
            return stiffness_N_per_m * x_m * x_m * 0.5;
        const double u = stiffening_per_m * x_m;
        if (std::abs(u) < kSeriesBelow)
            return stiffness_N_per_m * x_m * x_m * excess(u);
        const double over = x_m - end_m();
        const double inside = u > kLargestExponent ? kLargestExponent : u;
        const double stored =
            stiffness_N_per_m / (stiffening_per_m * stiffening_per_m) * (std::expm1(inside) - inside);
        return u > kLargestExponent ? stored + over * (tensionAtEnd() + 0.5 * endSlope() * over) : stored;
    }

    /// Returns −df/dx (N/m), the stiffness felt at x.
    double slope(double x_m) const noexcept {
        const double u = stiffening_per_m * x_m;
        return stiffness_N_per_m * (u == 0.0 ? 1.0 : std::exp(u > kLargestExponent ? kLargestExponent : u));
    }

private:
    /// Returns (e^u − 1 − u)/u² by its series for |u| < kSeriesBelow; the first omitted term is below
    /// 3·10⁻¹⁸.
    static double excess(double u) noexcept {
        double sum = 1.0 / 39916800.0;
        for (const double term : {1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0,
                                  1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5})
            sum = sum * u + term;
        return sum;
    }
    double end_m() const noexcept { return kLargestExponent / stiffening_per_m; }
    double tensionAtEnd() const noexcept {
        return stiffness_N_per_m / stiffening_per_m * std::expm1(kLargestExponent);
    }
    double endSlope() const noexcept { return stiffness_N_per_m * std::exp(kLargestExponent); }
};

} // namespace chiron::simulation
