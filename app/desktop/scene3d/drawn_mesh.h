// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// A vertex as it is passed to the graphics driver. It uses millimetres, so that floats resolve about 10 nm.
/// Unit: mm.
/// Frame: W (world), or the part's own.
struct MeshVertex {
    float position_mm[3] = {0.0F, 0.0F, 0.0F};
    float normal[3] = {0.0F, 0.0F, 1.0F};
    float texture[2] = {0.0F, 0.0F}; ///< tissue: mm along the surface; instruments: x = share of bare steel
    float light = 1.0F;              ///< 0..1: how much of the surrounding light reaches this point
};

struct TriangleMesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices; ///< three per triangle, counter-clockwise from outside
};

} // namespace chiron::scene3d
