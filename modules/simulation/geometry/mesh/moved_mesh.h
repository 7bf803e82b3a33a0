// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/triangle_mesh.h"

#include <cstdint>
#include <span>

namespace chiron::simulation {

/// A mesh whose vertices have moved: the same triangles, neighbours and tree as at rest, each place and normal from the
/// caller's arrays (blended from a slow model's answers, say). What tracking and contact need of a surface:
///   position(vertex), normal(vertex), triangle(index), tree(), largestDisplacement_m(), kMoves.
/// Any type that answers these can be touched; this one looks at arrays that outlive it. Thread: haptic.
class MovedMesh {
public:
    /// `positions`, `normals`: as long as mesh.vertices(); `largestDisplacement_m`: no vertex is farther from rest.
    MovedMesh(const TriangleMesh& mesh, std::span<const core::Vec3> positions, std::span<const core::Vec3> normals,
              double largestDisplacement_m) noexcept
        : m_mesh(&mesh), m_positions(positions), m_normals(normals), m_largestDisplacement_m(largestDisplacement_m) {}

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
