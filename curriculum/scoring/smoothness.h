// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"

#include <span>

namespace chiron::scoring {

/// Returns the spectral arc length of one movement's speed profile (Balasubramanian et al. 2015, J NeuroEng
/// Rehabil 12:112, eq. 5): −∫ √((1/ω_c)² + (dV̂/dω)²) dω over 0…ω_c, where V̂ is the amplitude spectrum
/// divided by its value at zero. As in the authors' program, the profile is zero-padded to 2^(⌈log₂ n⌉+4)
/// points, and the cut-off is the last frequency ≤ 10 Hz at which V̂ ≥ 0.05. `speed` is evenly spaced by
/// `dt_s`, in any unit, ≥ 0. The result is dimensionless and below zero; nearer zero is smoother. For
/// example, v = e^{−5t²}, t ∈ [−1,1) at 100 Hz gives −1.41403. Undefined: no speed above zero, or fewer than
/// two frequencies.
Measurement spectralArcLength(std::span<const double> speed, double dt_s);

/// Returns the log dimensionless jerk of one movement (the same paper, eq. 3 in its logarithmic form):
/// −ln(T³/v²_peak ∫ v̈² dt), with v̈ from second differences of speed and T = n·dt. Nearer zero is smoother.
/// The same profile gives −5.81636. Undefined: fewer than three samples, no speed, or no jerk at all.
Measurement logDimensionlessJerk(std::span<const double> speed, double dt_s);

} // namespace chiron::scoring
