// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/triangle_mesh.h"

#include <cstdint>
#include <span>

namespace chiron::simulation {

/// A mesh whose vertices have moved. Triangles, neighbours and tree are those at rest; positions and normals
/// come from the caller's arrays (for example, blended from a slow model's answers). Tracking and contact
/// need the following of a surface:
///   position(vertex), normal(vertex), triangle(index), tree(), largestDisplacement_m(), kMoves.
/// Any type that has these can be touched. This one refers to arrays that have to outlive it.
/// Thread: haptic.
class MovedMesh {
public:
    /// `positions` and `normals` are as long as mesh.vertices(); no vertex is farther from rest than
    /// `largestDisplacement_m`.
    MovedMesh(const TriangleMesh& mesh, std::span<const core::Vec3> positions,
              std::span<const core::Vec3> normals, double largestDisplacement_m) noexcept
        : m_mesh(&mesh), m_positions(positions), m_normals(normals),
          m_largestDisplacement_m(largestDisplacement_m) {}

    const core::Vec3& position(std::uint32_t vertex) const noexcept { return m_positions[vertex]; }
    const core::Vec3& normal(std::uint32_t vertex) const noexcept { return m_normals[vertex]; }
    const SurfaceTriangle& triangle(std::uint32_t index) const noexcept { return m_mesh->triangle(index); }
    const MeshTree& tree() const noexcept { return m_mesh->tree(); }
    double largestDisplacement_m() const noexcept { return m_largestDisplacement_m; }
    static constexpr bool kMoves = true;

private:
    const TriangleMesh* m_mesh;
    std::span<const core::Vec3> m_positions;
    std::span<const core::Vec3> m_normals;
    double m_largestDisplacement_m;
};

} // namespace chiron::simulation
