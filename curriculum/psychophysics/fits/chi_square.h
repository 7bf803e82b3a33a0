// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::psychophysics {

/// P(X > value) for chi-square with so many degrees of freedom. Not a number for freedom <= 0 or value < 0. Error below 1e-12.
double chiSquareTail(double value, double freedom) noexcept;
/// The value that a share `confidence` of chi-square with one degree of freedom lies below (3.841 at 0.95).
double chiSquareQuantileOne(double confidence) noexcept;
/// The same of the likelihood ratio of one parameter beside `bounded` others (0 to 2) that are fitted and may lie at an end of what they can be, as
/// lapses and guesses at 0: 3.841, 4.231 and 5.435 at 0.95. There the ratio is a mixture of chi-squares (chi-bar-square; Self & Liang 1987), which
/// depends on how far the others can stand in for the parameter; these are the largest values it has, in the limit where they can do so wholly, for
/// others that say nothing of each other: chi-square of j degrees with the chances of j heads in `bounded` + 1 throws. Not a number elsewhere.
double chiBarSquareQuantile(double confidence, int bounded) noexcept;

} // namespace chiron::psychophysics
