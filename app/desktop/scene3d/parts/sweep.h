// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// One cross-section of a soft, round body: where, how thick, how much of the light reaches it. Above 1 `light` says how
/// much the tissue is blanched (1.4: lit, and 40 % paler); ragged ends are below 0: wounds. Millimetres.
struct SweepRing {
    core::Vec3 p_mm = core::Vec3::Zero();
    double radius_mm = 1.0;
    double light = 1.0;
};

/// How the ends of a swept body are closed.
enum class SweepEnd {
    open,   ///< it runs into something
    round,  ///< half a ball beyond the last ring
    ragged, ///< torn: fringes of uneven length
};

/// A skin round a bent line, its frames carried along without a twist. The texture runs in millimetres along and round it.
/// Fewer than two rings: nothing. Pure; allocates.
void addSweep(TriangleMesh& mesh, const std::vector<SweepRing>& rings, SweepEnd first, SweepEnd last, int sides = 16);

/// A lobed ellipsoid round `centre_mm`; `lobes`: how far they stand out, as a share; the seed makes each another one.
void addLobe(TriangleMesh& mesh, const core::Vec3& centre_mm, const core::Vec3& halfAxes_mm, double lobes, std::uint32_t seed,
             int rows = 18);

} // namespace chiron::scene3d
