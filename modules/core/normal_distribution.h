// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::core {

/// The standard normal distribution, for signal detection and psychometric functions. Pure; any thread.
double normalDensity(double x) noexcept;
double normalCumulative(double x) noexcept; ///< Φ(x); its relative accuracy holds far into the lower tail
/// Returns z(p), the inverse of Φ: −∞ at 0, +∞ at 1, not a number outside [0, 1] (or for NaN). The error is
/// below 1e-12 for p in [1e-300, 1 − 1e-16].
///
/// Start value: the rational approximation of Hastings (Approximations for Digital Computers, 1955, sheet 68;
/// Abramowitz & Stegun 1964, 26.2.23; |error| < 4.5e-4). Two steps of Halley's method on Φ follow, each of
/// which cubes the error.
double normalQuantile(double p) noexcept;

} // namespace chiron::core
