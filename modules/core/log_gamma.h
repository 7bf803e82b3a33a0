// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace chiron::core {

/// Returns ln Γ(x) for x > 0. std::lgamma also writes the sign to a global variable; this function does not.
/// Thread: any.
inline double logGamma(double x) noexcept {
    int sign = 0;
    return ::lgamma_r(x, &sign);
}

} // namespace chiron::core
