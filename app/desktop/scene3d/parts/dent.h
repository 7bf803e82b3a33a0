// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::scene3d {

/// The dent that one tip makes in a drawn surface. Every point x near the touched point s moves by
///   u(x) = −depth · n · (1 − |x − s|²/reach²)³   for |x − s| < reach, 0 beyond,
/// so that s itself comes to lie on the tip, and position and slope are continuous everywhere. The force law
/// defines a depth but no profile, so the profile is our choice. shaders/tissue.vert computes the same. Pure.
/// Unit: m.
/// Frame: W (world).
struct Dent {
    core::Vec3 p_WSurface = core::Vec3::Zero(); ///< s
    core::Vec3 normal = core::Vec3::UnitZ();    ///< n, unit vector, outward: from the tip to s
    double depth_m = 0.0;                       ///< ≥ 0; 0 = no contact
    double reach_m = kBaseReach_m;

    /// a light touch moves tissue about twice a 2.5 mm shaft's radius away.
    static constexpr double kBaseReach_m = 0.005;
    static constexpr double kReachPerDepth = 1.6; ///< keeps the steepest slope, 1.72 depth/reach, near 1

    core::Vec3 displaced(const core::Vec3& p_W) const noexcept {
        const double rest = 1.0 - (p_W - p_WSurface).squaredNorm() / (reach_m * reach_m);
        if (rest <= 0.0 || depth_m <= 0.0)
            return p_W;
        return p_W - depth_m * rest * rest * rest * normal;
    }
};

} // namespace chiron::scene3d
