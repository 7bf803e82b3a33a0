// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/exact_tests.h"

#include "core/log_gamma.h"
#include "core/normal_distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Lentz's method for the continued fraction of the incomplete beta function.
double betaFraction(double x, double a, double b) noexcept {
    constexpr double tiny = 1e-300;
    double c = 1.0;
    double d = 1.0 - (a + b) * x / (a + 1.0);
    d = 1.0 / (std::abs(d) < tiny ? tiny : d);
    double result = d;
    for (int m = 1; m <= 10000; ++m) {
        for (int half = 0; half < 2; ++half) {
            const double top = half == 0 ? m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
                                         : -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
            d = 1.0 + top * d;
            d = 1.0 / (std::abs(d) < tiny ? tiny : d);
            c = 1.0 + top / c;
            c = std::abs(c) < tiny ? tiny : c;
            result *= c * d;
        }
        if (std::abs(c * d - 1.0) < 1e-15)
            break;
    }
    return result;
}

double gammaSeries(double a, double x) noexcept { // lower incomplete gamma
    double term = 1.0 / a;
    double sum = term;
    for (int n = 1; n < 10000 && term > 1e-17 * sum; ++n) {
        term *= x / (a + n);
        sum += term;
    }
    return sum * std::exp(-x + a * std::log(x) - core::logGamma(a));
}

double gammaFraction(double a, double x) noexcept { // upper incomplete gamma
    double b = x + 1.0 - a;
    double c = 1e300;
    double d = 1.0 / b;
    double result = d;
    for (int i = 1; i < 10000; ++i) {
        const double top = -i * (i - a);
        b += 2.0;
        d = 1.0 / (top * d + b);
        c = b + top / c;
        result *= c * d;
        if (std::abs(c * d - 1.0) < 1e-15)
            break;
    }
    return result * std::exp(-x + a * std::log(x) - core::logGamma(a));
}

/// Returns the x in [0, 1] at which a falling function crosses zero.
template <class Function> double crossing(Function&& f) noexcept {
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < 100; ++step) {
        const double middle = 0.5 * (low + high);
        (f(middle) > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace

double logChoose(double n, double k) noexcept {
    return core::logGamma(n + 1.0) - core::logGamma(k + 1.0) - core::logGamma(n - k + 1.0);
}

double betaRegularised(double x, double a, double b) noexcept {
    if (!(a > 0.0 && b > 0.0) || std::isnan(x))
        return kNan;
    if (x <= 0.0 || x >= 1.0)
        return x <= 0.0 ? 0.0 : 1.0;
    const double front = std::exp(core::logGamma(a + b) - core::logGamma(a) - core::logGamma(b) +
                                  a * std::log(x) + b * std::log1p(-x));
    return x < (a + 1.0) / (a + b + 2.0) ? front * betaFraction(x, a, b) / a
                                         : 1.0 - front * betaFraction(1.0 - x, b, a) / b;
}

double gammaUpperRegularised(double a, double x) noexcept {
    if (!(a > 0.0) || std::isnan(x))
        return kNan;
    if (x <= 0.0)
        return 1.0;
    if (std::isinf(x))
        return 0.0;
    return x < a + 1.0 ? 1.0 - gammaSeries(a, x) : gammaFraction(a, x);
}

double binomialUpperTail(long long right, long long of, double p) noexcept {
    if (of < 0 || !(p >= 0.0 && p <= 1.0))
        return kNan;
    if (right <= 0)
        return 1.0;
    return right > of ? 0.0
                      : betaRegularised(p, static_cast<double>(right), static_cast<double>(of - right) + 1.0);
}

double binomialLowerTail(long long right, long long of, double p) noexcept {
    if (of < 0 || !(p >= 0.0 && p <= 1.0))
        return kNan;
    return right >= of ? 1.0 : binomialUpperTail(of - right, of, 1.0 - p);
}

ProportionInterval exactInterval(long long right, long long of, double level) noexcept {
    if (of <= 0 || right < 0 || right > of || !(level > 0.0 && level < 1.0))
        return {};
    const double tail = 0.5 * (1.0 - level);
    return {right == 0 ? 0.0 : crossing([&](double p) { return tail - binomialUpperTail(right, of, p); }),
            right == of ? 1.0 : crossing([&](double p) { return binomialLowerTail(right, of, p) - tail; })};
}

ProportionInterval wilsonInterval(long long right, long long of, double level, bool continuity) noexcept {
    if (of <= 0 || right < 0 || right > of || !(level > 0.0 && level < 1.0))
        return {};
    const double z = core::normalQuantile(0.5 * (1.0 + level));
    const double n = static_cast<double>(of);
    const double shift = continuity ? 0.5 / n : 0.0;
    const double p = static_cast<double>(right) / n;
    const auto end = [&](double direction) {
        const double q = std::clamp(p + direction * shift, 0.0, 1.0);
        const double root = std::sqrt(q * (1.0 - q) / n + z * z / (4.0 * n * n));
        return (q + z * z / (2.0 * n) + direction * z * root) / (1.0 + z * z / n);
    };
    return {right == 0 ? 0.0 : std::max(0.0, end(-1.0)), right == of ? 1.0 : std::min(1.0, end(1.0))};
}

double chiSquareUpperTail(double value, double degrees) noexcept {
    return gammaUpperRegularised(0.5 * degrees, 0.5 * value);
}

double chiSquareQuantile(double p, double degrees) noexcept {
    if (!(p > 0.0 && p < 1.0) || !(degrees > 0.0))
        return kNan;
    double high = degrees + 1.0;
    while (chiSquareUpperTail(high, degrees) > 1.0 - p && high < 1e300)
        high *= 2.0;
    return high *
           crossing([&](double share) { return chiSquareUpperTail(share * high, degrees) - (1.0 - p); });
}

double studentUpperTail(double t, double degrees) noexcept {
    if (std::isinf(degrees))
        return core::normalCumulative(-t);
    const double both = betaRegularised(degrees / (degrees + t * t), 0.5 * degrees, 0.5);
    return t >= 0.0 ? 0.5 * both : 1.0 - 0.5 * both;
}

double studentQuantile(double p, double degrees) noexcept {
    if (std::isinf(degrees))
        return core::normalQuantile(p);
    if (!(p > 0.0 && p < 1.0) || !(degrees > 0.0))
        return kNan;
    if (p < 0.5)
        return -studentQuantile(1.0 - p, degrees);
    double low = 0.0;
    double high = 1.0;
    while (studentUpperTail(high, degrees) > 1.0 - p && high < 1e12)
        high *= 2.0;
    for (int step = 0; step < 200 && high - low > 1e-14 * high; ++step) {
        const double middle = 0.5 * (low + high);
        (studentUpperTail(middle, degrees) > 1.0 - p ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace chiron::psychophysics
