// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/discrimination.h"

#include "core/normal_distribution.h"
#include "psychophysics/measures/quadrature.h"
#include "psychophysics/observers/thurstone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace chiron::psychophysics {

namespace {

using core::normalCumulative;
using core::normalDensity;

constexpr double kRoot2 = std::numbers::sqrt2;
const double kRoot3 = std::sqrt(3.0);
const double kRoot6 = std::sqrt(6.0);

double mAfc(double d, int m) {
    if (m == 2)
        return normalCumulative(d / kRoot2);
    return integrate([=](double x) { return normalDensity(x) * std::pow(normalCumulative(x + d), m - 1); },
                     -kNormalTail, kNormalTail);
}

double triangle(double d) {
    const double shift = d * std::sqrt(2.0 / 3.0);
    return 2.0 * integrate(
                     [=](double x) {
                         return normalDensity(x) * (normalCumulative(shift - x * kRoot3) +
                                                    normalCumulative(-shift - x * kRoot3));
                     },
                     0.0, kNormalTail);
}

/// In coordinates centred between the two means, the most likely odd object is the one farthest from half the
/// sum of all three. The answer is right if both others lie on the same side of zero and of the odd object.
double oddity(double d) {
    const double h = 0.5 * d;
    const auto square = [](double v) { return v * v; };
    const double above =
        integrate([=](double x) { return normalDensity(x + h) * square(normalCumulative(h - x)); }, 0.0,
                  kNormalTail + h);
    const double below =
        integrate([=](double x) { return normalDensity(x + h) * square(normalCumulative(x - h)); },
                  -kNormalTail - h, 0.0);
    return std::pow(normalCumulative(h), 3) + above + std::pow(normalCumulative(-h), 3) + below;
}

double tetrad(double d) {
    const double wrong = integrate(
        [=](double x) {
            const double far = normalCumulative(x - d);
            return normalDensity(x) * far * (2.0 * normalCumulative(x) - far);
        },
        -kNormalTail, kNormalTail + d);
    return 1.0 - 2.0 * wrong;
}

/// Returns the probability that two independent judgements are both right or both wrong.
double bothOrNeither(double a, double b) {
    return normalCumulative(a) * normalCumulative(b) + normalCumulative(-a) * normalCumulative(-b);
}

constexpr double kTableEnd = 12.0;
constexpr int kTableSteps = 600; ///< 50 steps per unit of d

std::vector<std::array<double, 6>> orderTable() {
    std::vector<std::array<double, 6>> table;
    for (int i = -1; i <= kTableSteps + 1; ++i)
        table.push_back(rankProbabilities(kTableEnd * i / kTableSteps));
    return table;
}

// −d: the same with objects 0 and 2 exchanged.
std::array<double, 6> turnedRound(const std::array<double, 6>& p) {
    return {p[5], p[3], p[4], p[1], p[2], p[0]};
}

} // namespace

double chanceOf(const DiscriminationTask& task) noexcept {
    switch (task.rule) {
    case Discrimination::mAfc:
        return 1.0 / std::max(2, task.alternatives);
    case Discrimination::oddityDifferencing:
    case Discrimination::oddityIndependent:
    case Discrimination::tetrad:
        return 1.0 / 3.0;
    case Discrimination::sameDifferentIndependent:
    case Discrimination::abxDifferencing:
    case Discrimination::abxIndependent:
        break;
    }
    return 0.5;
}

double proportionCorrect(const DiscriminationTask& task, double dPrime) noexcept {
    if (std::isnan(dPrime))
        return dPrime;
    const double d = std::min(std::abs(dPrime), 60.0);
    switch (task.rule) {
    case Discrimination::mAfc:
        return std::clamp(mAfc(std::copysign(d, dPrime), std::clamp(task.alternatives, 2, 1000)), 0.0, 1.0);
    case Discrimination::oddityDifferencing:
        return triangle(d);
    case Discrimination::oddityIndependent:
        return oddity(d);
    case Discrimination::sameDifferentIndependent:
        return bothOrNeither(0.5 * d, 0.5 * d);
    case Discrimination::abxDifferencing:
        return bothOrNeither(d / kRoot2, d / kRoot6);
    case Discrimination::abxIndependent:
        return bothOrNeither(d / kRoot2, 0.5 * d);
    case Discrimination::tetrad:
        return tetrad(d);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

double dPrimeAt(const DiscriminationTask& task, double proportion) noexcept {
    if (!(proportion >= 0.0 && proportion <= 1.0))
        return std::numeric_limits<double>::quiet_NaN();
    if (proportion >= 1.0)
        return HUGE_VAL;
    const bool bothSigns = task.rule == Discrimination::mAfc;
    if (!bothSigns && proportion <= chanceOf(task))
        return 0.0;
    if (proportion <= 0.0)
        return -HUGE_VAL;
    double low = bothSigns ? -40.0 : 0.0;
    double high = 40.0;
    while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high)
            break;
        (proportionCorrect(task, middle) < proportion ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double slopeOf(const DiscriminationTask& task, double dPrime) noexcept {
    constexpr double step = 1e-4; // central differences: error of order step², 1e-9
    return (proportionCorrect(task, dPrime + step) - proportionCorrect(task, dPrime - step)) / (2.0 * step);
}

std::array<double, 6> tabulatedOrderProbabilities(double d) noexcept {
    static const std::vector<std::array<double, 6>> table = orderTable();
    if (d < 0.0)
        return turnedRound(tabulatedOrderProbabilities(-d));
    if (!(d < kTableEnd))
        return std::isnan(d) ? std::array<double, 6>{d, d, d, d, d, d}
                             : std::array<double, 6>{1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double place = d * kTableSteps / kTableEnd;
    const auto at = static_cast<std::size_t>(place);
    const double u = place - static_cast<double>(at);
    const std::array<double, 4> weight{-u * (u - 1.0) * (u - 2.0) / 6.0,
                                       (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0,
                                       -(u + 1.0) * u * (u - 2.0) / 2.0, (u + 1.0) * u * (u - 1.0) / 6.0};
    std::array<double, 6> result{};
    for (std::size_t order = 0; order < result.size(); ++order) {
        for (std::size_t row = 0; row < weight.size(); ++row)
            result[order] += weight[row] * table[at + row][order];
        result[order] = std::max(0.0, result[order]);
    }
    return result;
}

} // namespace chiron::psychophysics
