// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/observers/thurstone.h"

#include "core/normal_distribution.h"

namespace chiron::psychophysics {

using core::normalCumulative;
using core::normalDensity;

namespace {

constexpr double kReach = 9.0; ///< sd; the density outside is below 1e-18
constexpr int kPoints = 73;    ///< trapezoids of a quarter sd: exact to rounding for such integrands

struct Pair {
    double lowFirst;
    double highFirst;
};

/// Returns, for a middle object at 0 and the others at `one` and `other`, P(one < middle < other) and P(other
/// < middle < one).
Pair withMiddle(double one, double other) noexcept {
    Pair sum{0.0, 0.0};
    constexpr double kStep = 2.0 * kReach / (kPoints - 1);
    for (int i = 0; i < kPoints; ++i) {
        const double y = -kReach + kStep * i;
        const double weight = kStep * normalDensity(y);
        sum.lowFirst += weight * normalCumulative(y - one) * normalCumulative(other - y);
        sum.highFirst += weight * normalCumulative(y - other) * normalCumulative(one - y);
    }
    return sum;
}

} // namespace

std::array<double, 6> rankProbabilities(double d) noexcept {
    const Pair one = withMiddle(-d, d);       // 0<1<2 and 2<1<0
    const Pair zero = withMiddle(d, 2.0 * d); // 1<0<2 and 2<0<1; by symmetry 0<2<1 and 1<2<0
    const double total = one.lowFirst + one.highFirst + 2.0 * (zero.lowFirst + zero.highFirst);
    return {one.lowFirst / total,   zero.lowFirst / total,  zero.lowFirst / total,
            zero.highFirst / total, zero.highFirst / total, one.highFirst / total};
}

std::array<double, 6> rankProbabilities(double d, double lapse) noexcept {
    std::array<double, 6> probability = rankProbabilities(d);
    for (double& p : probability)
        p = (1.0 - lapse) * p + lapse / 6.0;
    return probability;
}

} // namespace chiron::psychophysics
