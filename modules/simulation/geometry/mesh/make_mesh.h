// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/geometry/mesh/mesh_source.h"
#include "simulation/geometry/mesh/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// Vertices and triangles before anything is known of them. Metres; counter-clockwise from outside.
struct MeshShape {
    std::vector<core::Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The mesh of a source, in the object's own frame: the same source gives the same mesh, vertex for vertex.
/// Dome: centre of the ball at the origin, the plate's top at z = 0, the apex at (0, 0, R). Ellipsoid: centre at the origin.
/// Stored: as it is. Refused with the reason: Shape::none, a size that is not positive, an edge that would make more than
/// TriangleMesh::kMostTriangles, bumps so steep that the surface could fold (slope > 1), a stored surface that is not closed.
/// Allocates; 500,000 triangles take about 1 s. Thread: any but the haptic one.
core::Result<TriangleMesh> makeMesh(const MeshSource& source);

/// The shape alone, without adjacency, normals and tree (what is drawn, exported or tested).
core::Result<MeshShape> makeMeshShape(const MeshSource& source);

/// A watertight half ball on a round plate, by rings of triangles: radius halfAxisX_m. Bumps are along the normal, fade out at the
/// plate and towards the apex, so that the highest point stays the apex: weight min(1, (ρ/ρ₀)²) with ρ₀² = max(R²/4, 4RA).
MeshShape domeShape(const MeshSource& source);
/// A closed ellipsoid from an icosahedron cut to edge_m (20 n² triangles), with bumps along its normal.
MeshShape ellipsoidShape(const MeshSource& source);

} // namespace chiron::simulation
