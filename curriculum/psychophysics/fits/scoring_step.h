// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/likelihood.h"

#include <algorithm>
#include <cmath>
#include <utility>

// One step of Newton's method, or of Fisher scoring if the likelihood is not concave, over (alpha, beta) or,
// with Ends, over (alpha, beta, lapse, guess). Inline because it is the inner loop of every fit.
namespace chiron::psychophysics::scoring {

inline constexpr double kLeastBeta = 1e-7;
inline constexpr double kMostBeta = 1e9;

template <bool Ends> inline constexpr std::size_t kParameters = Ends ? 4 : 2;

template <bool Ends>
using Triangle = std::array<std::array<double, kParameters<Ends>>, kParameters<Ends>>; ///< the lower triangle

template <bool Ends> struct Sums {
    double logLikelihood = 0.0;
    double pearson = 0.0;
    std::array<double, kParameters<Ends>> gradient{};
    Triangle<Ends> expected{};
    Triangle<Ends> observed{};
};

/// Computes the log-likelihood, its gradient, and its negative second derivatives: expected and observed.
template <class Shape, bool Ends>
Sums<Ends> sumsAt(const LevelsView& levels, const UnitCurve& curve, [[maybe_unused]] bool equal) noexcept {
    Sums<Ends> sums;
    const double reach = 1.0 - curve.guess - curve.lapse;
    for (std::size_t i = 0; i < levels.size; ++i) {
        const double u = levels.unit[i];
        const SigmoidValue s = Shape::at(curve.alpha + curve.beta * u);
        // A level of 0 on a logarithmic axis is at minus infinity. S is flat there, whatever rounding does to
        // its slope.
        const double place = std::isfinite(u) ? u : 0.0;
        const double psi = curve.guess + reach * s.rise;
        const double rest = curve.lapse + reach * s.rest;
        sums.logLikelihood += levelLogLikelihood(levels.right[i], levels.of[i], psi, rest);
        const double weight = 1.0 / std::max(psi * rest, 1e-300);
        const double excess = levels.right[i] * rest - (levels.of[i] - levels.right[i]) * psi; // k − nψ
        sums.pearson += excess * excess * weight / levels.of[i];
        // The terms are added separately: their sum over ψ(1 − ψ) would lose what a saturated level says
        // about the lapse rate, where 1 − ψ is below the precision of a double.
        const double right = levels.right[i] / std::max(psi, 1e-150),
                     wrong = (levels.of[i] - levels.right[i]) / std::max(rest, 1e-150);
        const double score = right - wrong;
        std::array<double, kParameters<Ends>> d{reach * s.slope, reach * s.slope * place};
        if constexpr (Ends) {
            d[2] = equal ? s.rest - s.rise : -s.rise;
            d[3] = equal ? 0.0 : s.rest;
        }
        const double curvature = right / std::max(psi, 1e-150) + wrong / std::max(rest, 1e-150),
                     expected = levels.of[i] * weight;
        for (std::size_t a = 0; a < d.size(); ++a) {
            sums.gradient[a] += score * d[a];
            for (std::size_t b = 0; b <= a; ++b) {
                sums.expected[a][b] += expected * d[a] * d[b];
                sums.observed[a][b] += curvature * d[a] * d[b];
            }
        }
        const double bend = score * reach * s.bend;
        sums.observed[0][0] -= bend;
        sums.observed[1][0] -= bend * place;
        sums.observed[1][1] -= bend * place * place;
        if constexpr (Ends) {
            const double byLapse = (equal ? 2.0 : 1.0) * score * s.slope,
                         byGuess = equal ? 0.0 : score * s.slope;
            sums.observed[2][0] += byLapse;
            sums.observed[2][1] += byLapse * place;
            sums.observed[3][0] += byGuess;
            sums.observed[3][1] += byGuess * place;
        }
    }
    return sums;
}

/// Returns which parameters may move: those that are free and not pressed against a bound.
template <bool Ends>
std::array<bool, kParameters<Ends>> movable(const Sums<Ends>& sums, const UnitCurve& at,
                                            const FreeParameters& free) noexcept {
    std::array<bool, kParameters<Ends>> moves{};
    moves[0] = free.alpha;
    moves[1] = free.beta && !(at.beta <= kLeastBeta && sums.gradient[1] < 0.0) &&
               !(at.beta >= kMostBeta && sums.gradient[1] > 0.0);
    if constexpr (Ends) {
        const auto held = [](double value, double most, double gradient) {
            return (value <= 0.0 && gradient <= 0.0) || (value >= most && gradient >= 0.0);
        };
        moves[2] = free.lapse && !held(at.lapse, free.largestLapse, sums.gradient[2]);
        moves[3] = free.guess && !held(at.guess, free.largestGuess, sums.gradient[3]);
    }
    return moves;
}

template <bool Ends> using Move = std::pair<std::array<double, kParameters<Ends>>, double>;

/// Solves (information + damping · its diagonal) move = gradient by Cholesky decomposition over the
/// parameters that may move. The second result is gradient · move, the Newton decrement; it is negative if
/// the information is not positive definite.
template <bool Ends>
Move<Ends> solved(const Triangle<Ends>& information, const std::array<double, kParameters<Ends>>& gradient,
                  const std::array<bool, kParameters<Ends>>& moves, double damping) noexcept {
    constexpr std::size_t size = kParameters<Ends>;
    Triangle<Ends> lower{};
    std::array<double, size> y{};
    double decrement = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        if (!moves[i]) {
            continue;
        }
        for (std::size_t j = 0; j <= i; ++j) {
            double value = information[i][j] * (i == j ? 1.0 + damping + 1e-13 : 1.0);
            for (std::size_t k = 0; k < j; ++k) {
                value -= lower[i][k] * lower[j][k];
            }
            const bool tooSmall = i == j && !(value > 1e-10 * information[i][i]);
            lower[i][j] = i == j ? (tooSmall ? 0.0 : std::sqrt(value)) : moves[j] ? value / lower[j][j] : 0.0;
        }
        if (!(lower[i][i] > 0.0) || !std::isfinite(lower[i][i])) {
            return {{}, -1.0};
        }
        y[i] = gradient[i];
        for (std::size_t k = 0; k < i; ++k) {
            y[i] -= lower[i][k] * y[k];
        }
        y[i] /= lower[i][i];
        decrement += y[i] * y[i];
    }
    std::array<double, size> move{};
    for (std::size_t i = size; i-- > 0;) {
        if (moves[i]) {
            double value = y[i];
            for (std::size_t k = i + 1; k < size; ++k) {
                value -= lower[k][i] * move[k];
            }
            move[i] = value / lower[i][i];
        }
    }
    return {move, decrement};
}

/// Returns Newton's step if the observed information is positive definite, else Fisher's.
template <bool Ends>
Move<Ends> stepFrom(const Sums<Ends>& sums, const UnitCurve& at, const FreeParameters& free,
                    double damping) noexcept {
    const auto moves = movable<Ends>(sums, at, free);
    const Move<Ends> newton = solved<Ends>(sums.observed, sums.gradient, moves, damping);
    return newton.second >= 0.0 ? newton : solved<Ends>(sums.expected, sums.gradient, moves, damping);
}

/// Limits a value. Unlike with std::clamp the bounds may cross (a start far beyond the steepest curve): then
/// `high` holds.
inline double limited(double value, double low, double high) noexcept {
    return std::min(std::max(value, low), high);
}

/// Moves a share and keeps it between 0 and its largest value. It does not jump onto 0 from far away, because
/// the likelihood may rise again next to 0.
inline double movedShare(double from, double by, double most) noexcept {
    constexpr double kNear = 1e-3;
    return from + by <= 0.0 && from > kNear ? 0.25 * from : limited(from + by, 0.0, most);
}

template <std::size_t Size>
UnitCurve moved(const UnitCurve& from, const std::array<double, Size>& move,
                const FreeParameters& free) noexcept {
    UnitCurve to = from;
    to.alpha += move[0];
    to.beta = limited(from.beta + move[1], std::max(kLeastBeta, 0.1 * from.beta),
                      std::min(kMostBeta, 10.0 * from.beta));
    if constexpr (Size == 4) {
        if (free.lapse) {
            to.lapse = movedShare(from.lapse, move[2], free.largestLapse);
        }
        to.guess = free.equal   ? to.lapse
                   : free.guess ? movedShare(from.guess, move[3], free.largestGuess)
                                : from.guess;
    }
    return to;
}

} // namespace chiron::psychophysics::scoring
