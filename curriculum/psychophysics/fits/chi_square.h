// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::psychophysics {

/// Returns P(X > value) for chi-square with `freedom` degrees of freedom. Not a number for freedom <= 0 or
/// value < 0. Error below 1e-12.
double chiSquareTail(double value, double freedom) noexcept;
/// Returns the value below which chi-square with one degree of freedom lies with probability `confidence`
/// (3.841 at 0.95).
double chiSquareQuantileOne(double confidence) noexcept;
/// Returns the same quantile for the likelihood ratio of one parameter when `bounded` others (0 to 2) are
/// fitted and may lie at a bound, as lapse and guess rates at 0: 3.841, 4.231 and 5.435 at 0.95. The ratio is
/// then a mixture of chi-squares (chi-bar-square; Self & Liang 1987) that depends on how well the other
/// parameters can compensate for this one. The values are the largest possible ones, in the limit of full
/// compensation by parameters that carry no information about each other: chi-square with j degrees of
/// freedom, weighted by the probability of j heads in `bounded` + 1 throws. Not a number outside these
/// ranges.
double chiBarSquareQuantile(double confidence, int bounded) noexcept;

} // namespace chiron::psychophysics
