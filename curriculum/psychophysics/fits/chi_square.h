// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::psychophysics {

/// P(X > value) for chi-square with so many degrees of freedom. Not a number for freedom <= 0 or value < 0. Error below 1e-12.
double chiSquareTail(double value, double freedom) noexcept;
/// The value that a share `confidence` of chi-square with one degree of freedom lies below (3.841 at 0.95).
double chiSquareQuantileOne(double confidence) noexcept;

} // namespace chiron::psychophysics
