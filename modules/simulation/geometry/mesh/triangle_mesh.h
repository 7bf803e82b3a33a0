// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"
#include "simulation/geometry/mesh/mesh_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::simulation {

/// Three vertices, counter-clockwise from outside, and the triangle across each side: `neighbour[i]` shares
/// the edge opposite to `vertex[i]`, which runs from vertex[i+1] to vertex[i+2].
struct SurfaceTriangle {
    std::array<std::uint32_t, 3> vertex{};
    std::array<std::uint32_t, 3> neighbour{};
};

/// A vertex of the surface and the outward unit normal there: the average of the normals of its triangles,
/// weighted by their angles at the vertex (P2 figure 6; the weights make it independent of how the surface is
/// cut into triangles).
struct SurfaceVertex {
    core::Vec3 position = core::Vec3::Zero(); ///< m
    core::Vec3 normal = core::Vec3::UnitZ();
};

/// A closed, consistently oriented surface of triangles, laid out for the tick: 48 bytes per vertex, 24 per
/// triangle, and the tree that finds the nearest triangle. Triangles and vertices are renumbered so that
/// neighbours in space are close in memory; their numbers therefore differ from those of the shape from which
/// the mesh was made, while the connections are the same. It has one or several shells, and every edge
/// belongs to exactly two triangles. A value type, immutable once made. Source: P2 "Deformation", figure 6;
/// models.md §2.2.
/// Frame: the object's own.
/// Thread: any.
class TriangleMesh {
public:
    static constexpr std::size_t kMostTriangles = 2'000'000; ///< assumption: 250 MB, and 1 s to build

    /// Builds a mesh. mesh_import.h repairs beforehand what can be repaired. Allocates.
    /// Thread: any.
    /// Errors: refuses, naming the place, any surface that is not closed or valid: an index out of range, an
    /// edge without its opposite or used twice, a triangle without area, a number that is not finite, too
    /// many triangles.
    static core::Result<TriangleMesh> create(std::span<const core::Vec3> vertices,
                                             std::span<const std::array<std::uint32_t, 3>> triangles);

    const core::Vec3& position(std::uint32_t vertex) const noexcept { return m_vertices[vertex].position; }
    const core::Vec3& normal(std::uint32_t vertex) const noexcept { return m_vertices[vertex].normal; }
    const SurfaceTriangle& triangle(std::uint32_t index) const noexcept { return m_triangles[index]; }
    /// Upper bound on the distance of any vertex from its position in the tree: 0 here; a moving view returns
    /// its largest displacement (m).
    double largestDisplacement_m() const noexcept { return 0.0; }
    static constexpr bool kMoves = false; ///< a place stays where it is from tick to tick
    const MeshTree& tree() const noexcept { return m_tree; }

    std::span<const SurfaceVertex> vertices() const noexcept { return m_vertices; }
    std::span<const SurfaceTriangle> triangles() const noexcept { return m_triangles; }
    const core::Vec3& lowest() const noexcept { return m_lowest; }   ///< corner of the bounding box, m
    const core::Vec3& highest() const noexcept { return m_highest; } ///< corner of the bounding box, m
    double meanEdge_m() const noexcept { return m_meanEdge_m; }
    double longestEdge_m() const noexcept { return m_longestEdge_m; }

private:
    void lay(std::span<const core::Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles);

    std::vector<SurfaceVertex> m_vertices;
    std::vector<SurfaceTriangle> m_triangles;
    MeshTree m_tree;
    core::Vec3 m_lowest = core::Vec3::Zero();
    core::Vec3 m_highest = core::Vec3::Zero();
    double m_meanEdge_m = 0.0;
    double m_longestEdge_m = 0.0;
};

/// Angles of a triangle at its three corners, rad.
using CornerAngles = std::array<double, 3>;
/// Returns the angles of every triangle of the mesh at rest. Allocates.
std::vector<CornerAngles> cornerAngles(const TriangleMesh& mesh);

/// Computes unit normals of vertices that have moved. They are angle-weighted like those of TriangleMesh, but
/// with the angles of the mesh at rest: a push of some millimetres changes these little, and their arc
/// tangents would take most of an organ's step. `moved` and `normals` are as long as mesh.vertices(),
/// `weights` as mesh.triangles(). One pass over the triangles.
/// Thread: any (the slow model's step); allocates nothing.
void smoothNormals(const TriangleMesh& mesh, std::span<const CornerAngles> weights,
                   std::span<const core::Vec3> moved, std::span<core::Vec3> normals) noexcept;

} // namespace chiron::simulation
