// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

// The soft shadows of objects on the floor. `light` of a vertex is the darkness. Mesh in W, in millimetres;
// pure.

/// Darkness of the shadow of an object whose lower side is this far above the floor.
double shadeOf(double above_m);
MeshVertex shadeVertex(const core::Vec2& p_m, double floor_m, double dark);
/// Adds the shadow of a round object at this position.
void addShade(TriangleMesh& mesh, const core::Vec3& p_W, double radius_m, double floor_m);

} // namespace chiron::scene3d
