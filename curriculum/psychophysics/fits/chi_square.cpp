// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/chi_square.h"

#include "core/normal_distribution.h"

#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

// Stirling's series after raising x. Intervals of stored studies were computed with it, to the last bit, so
// it is not replaced by core::logGamma.
double logGamma(double x) noexcept {
    double shift = 0.0;
    while (x < 15.0) {
        shift -= std::log(x);
        x += 1.0;
    }
    const double r = 1.0 / (x * x);
    const double series = (1.0 / 12.0 - r * (1.0 / 360.0 - r * (1.0 / 1260.0 - r / 1680.0))) / x;
    return shift + (x - 0.5) * std::log(x) - x + 0.91893853320467274178 + series;
}

/// Regularised lower incomplete gamma function by its power series (x < a + 1).
double lowerBySeries(double a, double x) noexcept {
    double term = 1.0 / a, sum = term;
    for (int n = 1; n < 2000 && term > 1e-17 * sum; ++n) {
        term *= x / (a + n);
        sum += term;
    }
    return sum * std::exp(a * std::log(x) - x - logGamma(a));
}

/// Regularised upper incomplete gamma function by its continued fraction (x >= a + 1), evaluated forwards
/// (modified Lentz).
double upperByFraction(double a, double x) noexcept {
    constexpr double kTiny = 1e-300;
    double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, h = d;
    for (int i = 1; i < 2000; ++i) {
        const double an = -i * (i - a);
        b += 2.0;
        d = an * d + b;
        d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
        c = b + an / c;
        c = std::abs(c) < kTiny ? kTiny : c;
        h *= d * c;
        if (std::abs(d * c - 1.0) < 1e-16) {
            break;
        }
    }
    return h * std::exp(a * std::log(x) - x - logGamma(a));
}

} // namespace

double chiSquareTail(double value, double freedom) noexcept {
    if (!(freedom > 0.0) || !(value >= 0.0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double a = 0.5 * freedom, x = 0.5 * value;
    if (x == 0.0) {
        return 1.0;
    }
    return x < a + 1.0 ? 1.0 - lowerBySeries(a, x) : upperByFraction(a, x);
}

double chiSquareQuantileOne(double confidence) noexcept {
    const double z = core::normalQuantile(0.5 * (1.0 + confidence));
    return z * z;
}

double chiBarSquareQuantile(double confidence, int bounded) noexcept {
    if (bounded < 0 || bounded > 2 || !(confidence > 0.0) || !(confidence < 1.0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (bounded == 0) {
        return chiSquareQuantileOne(confidence);
    }
    const int most = bounded + 1;
    const auto above = [&](double value) { // the point mass at 0 exceeds no value
        double share = 0.0, ways = 1.0;
        for (int j = 1; j <= most; ++j) {
            ways *= static_cast<double>(most - j + 1) / j;
            share += ways * chiSquareTail(value, j);
        }
        return std::ldexp(share, -most);
    };
    double low = 0.0, high = 1.0;
    while (above(high) > 1.0 - confidence) {
        high *= 2.0;
    }
    for (int halving = 0; halving < 60; ++halving) {
        const double between = 0.5 * (low + high);
        (above(between) > 1.0 - confidence ? low : high) = between;
    }
    return 0.5 * (low + high);
}

} // namespace chiron::psychophysics
