// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/drawn_mesh.h"

#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// One cross-section of a soft, round body: its position, its radius, and how much of the light reaches it.
/// Above 1, `light` means blanched tissue (1.4: lit, and 40 % paler); values below 0 mark the ragged ends of
/// wounds.
/// Unit: mm.
struct SweepRing {
    core::Vec3 p_mm = core::Vec3::Zero();
    double radius_mm = 1.0;
    double light = 1.0;
};

/// How the ends of a swept body are closed.
enum class SweepEnd {
    open,   ///< not closed, because the end lies inside something else
    round,  ///< half a sphere beyond the last ring
    ragged, ///< torn, with fringes of uneven length
};

/// Adds a surface round a bent line, with frames that are transported without twist. Texture coordinates are
/// in millimetres along and round the body. Fewer than two rings add nothing. Pure; allocates.
void addSweep(TriangleMesh& mesh, const std::vector<SweepRing>& rings, SweepEnd first, SweepEnd last,
              int sides = 16);

/// Adds a lobed ellipsoid round `centre_mm`. `lobes` is the relative height of the lobes; each seed gives
/// another shape.
void addLobe(TriangleMesh& mesh, const core::Vec3& centre_mm, const core::Vec3& halfAxes_mm, double lobes,
             std::uint32_t seed, int rows = 18);

} // namespace chiron::scene3d
