// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/geometry/mesh/mesh_source.h"
#include "simulation/geometry/mesh/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// Vertices and triangles without adjacency or normals. Triangles are counter-clockwise from outside.
/// Unit: m.
struct MeshShape {
    std::vector<core::Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Makes the mesh of a source, in the object's own frame. The same source gives the same mesh, vertex for
/// vertex. For a dome the centre of the ball is at the origin, the plate's top at z = 0 and the apex at (0,
/// 0, R). For an ellipsoid the centre is at the origin. A stored mesh is used as it is. Allocates; 500,000
/// triangles take about 1 s.
/// Thread: any but the haptic one.
/// Errors: refuses, with the reason, Shape::none, a size that is not positive, an edge that would make more
/// than TriangleMesh::kMostTriangles, bumps so steep that the surface could fold (slope > 1), and a stored
/// surface that is not closed.
core::Result<TriangleMesh> makeMesh(const MeshSource& source);

/// Makes the shape alone, without adjacency, normals and tree (for drawing, export or tests).
core::Result<MeshShape> makeMeshShape(const MeshSource& source);

/// Makes a watertight half ball of radius halfAxisX_m on a round plate from rings of triangles. The bumps are
/// along the normal. They fade out at the plate and towards the apex, so that the highest point stays the
/// apex: weight min(1, (ρ/ρ₀)²) with ρ₀² = max(R²/4, 4RA).
MeshShape domeShape(const MeshSource& source);
/// Makes a closed ellipsoid from an icosahedron that is subdivided to edge_m (20 n² triangles), with bumps
/// along its normal.
MeshShape ellipsoidShape(const MeshSource& source);

} // namespace chiron::simulation
