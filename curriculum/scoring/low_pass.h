// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <vector>

namespace chiron::scoring {

/// Applies a zero-phase second-order Butterworth low-pass (models.md §6), forwards and then backwards: gain ½
/// at `cutOff_Hz`, no delay. Coefficients come from the bilinear transform with the cut-off pre-warped, K =
/// tan(π f_c/f_s), H(z) = K²(1+z⁻¹)² / ((1+√2K+K²) + 2(K²−1)z⁻¹ + (1−√2K+K²)z⁻²).
///
/// At the edges, both ends are continued by odd reflection (2x₀ − x_k) over three periods of the cut-off, at
/// most by all samples but one, and each pass starts in the steady state of its first value. Constants and
/// ramps pass unchanged. `positions` are evenly spaced in time, m; `rate_Hz` > 2 cutOff_Hz. Fewer than two
/// samples are returned unchanged.
std::vector<core::Vec3> lowPassZeroPhase(const std::vector<core::Vec3>& positions, double rate_Hz,
                                         double cutOff_Hz);

} // namespace chiron::scoring
