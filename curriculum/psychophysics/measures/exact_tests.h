// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::psychophysics {

/// Tail probabilities and limits that several measures share. Pure functions; not a number for arguments that
/// make no sense (of < 0, p outside [0, 1]).
/// Thread: any.

double logChoose(double n, double k) noexcept; ///< ln of the binomial coefficient
/// Returns P(X ≥ right) for `of` independent trials, each right with probability p. Exact sum in log space.
double binomialUpperTail(long long right, long long of, double p) noexcept;
double binomialLowerTail(long long right, long long of, double p) noexcept; ///< P(X ≤ right)

struct ProportionInterval {
    double low = 0.0;
    double high = 1.0;
};
/// Returns the interval of Clopper & Pearson (1934): exact, with at least the nominal coverage. 0..1 for no
/// trials.
ProportionInterval exactInterval(long long right, long long of, double level = 0.95) noexcept;
/// Returns the score interval of Wilson (1927); with `continuity` it has the correction of Newcombe (1998,
/// method 4), as in R's prop.test. 0..1 for no trials.
ProportionInterval wilsonInterval(long long right, long long of, double level = 0.95,
                                  bool continuity = false) noexcept;

/// Regularised incomplete beta and upper gamma function (continued fraction and series; Abramowitz &
/// Stegun 26.5.8, 6.5.29, 6.5.31).
double betaRegularised(double x, double a, double b) noexcept;
double gammaUpperRegularised(double a, double x) noexcept;

double chiSquareUpperTail(double value, double degrees) noexcept;
double chiSquareQuantile(double p, double degrees) noexcept; ///< x with P(X ≤ x) = p
double studentUpperTail(double t, double degrees) noexcept;  ///< P(T > t)
double studentQuantile(double p,
                       double degrees) noexcept; ///< t with P(T ≤ t) = p; normal for infinite degrees

} // namespace chiron::psychophysics
