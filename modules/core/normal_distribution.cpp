// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/normal_distribution.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace chiron::core {

namespace {

constexpr int kHalleySteps = 2;

/// Hastings' approximation of z(p) for 0 < p ≤ ½.
double roughQuantile(double p) noexcept {
    const double t = std::sqrt(-2.0 * std::log(p));
    return ((0.010328 * t + 0.802853) * t + 2.515517) /
               (((0.001308 * t + 0.189269) * t + 1.432788) * t + 1.0) -
           t;
}

/// Returns z(p) for 0 < p ≤ ½: the lower tail, where Φ keeps its relative accuracy.
double lowerQuantile(double p) noexcept {
    double x = roughQuantile(p);
    for (int step = 0; step < kHalleySteps; ++step) {
        const double u = (normalCumulative(x) - p) / normalDensity(x);
        x -= u / (1.0 + 0.5 * x * u); // Halley: φ′/φ = −x
    }
    return x;
}

} // namespace

double normalDensity(double x) noexcept {
    return std::exp(-0.5 * x * x) * (std::numbers::inv_sqrtpi / std::numbers::sqrt2);
}

double normalCumulative(double x) noexcept {
    return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

double normalQuantile(double p) noexcept {
    if (!(p >= 0.0 && p <= 1.0))
        return std::numeric_limits<double>::quiet_NaN();
    if (p == 0.0 || p == 1.0)
        return p == 0.0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    return p <= 0.5 ? lowerQuantile(p) : -lowerQuantile(1.0 - p);
}

} // namespace chiron::core
