// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/triangle_mesh.h"

namespace chiron::scene3d {

// The soft shade of things on the floor; `light` of a vertex is how dark. W, millimetres in the mesh; pure.

/// How dark the shade of something is whose lower side is so far above the floor.
double shadeOf(double above_m);
MeshVertex shadeVertex(const core::Vec2& p_m, double floor_m, double dark);
/// Of a round thing at this place.
void addShade(TriangleMesh& mesh, const core::Vec3& p_W, double radius_m, double floor_m);

} // namespace chiron::scene3d
