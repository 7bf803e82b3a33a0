// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_platform.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms::tests {

/// The most that the pad gets in 4 s (N, mean over a tick) when 4 to 8 N are asked at once every 0.8 s, half
/// the time while it leans to and fro by 0.3 rad.
inline double mostOf(const FingertipPlatformParameters& parameters, std::uint64_t seed) {
    FingertipPlatform platform(parameters, seed);
    double most = 0.0;
    for (int n = 0; n < 4000; ++n) {
        const double asked = n / 400 % 2 == 0 ? 0.0 : 4.0 + n / 800;
        platform.tick({asked, n < 2000 ? 0.0 : 0.3 * std::sin(0.01 * n), 0.0}, true);
        most = std::max(most, platform.truth().normalForce_N);
    }
    return most;
}

} // namespace chiron::mechanisms::tests
