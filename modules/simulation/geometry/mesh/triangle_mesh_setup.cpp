// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/triangle_mesh.h"

#include "simulation/geometry/mesh/mesh_sides.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::simulation {

namespace {

using Corners = std::array<std::uint32_t, 3>;

std::string edgeName(std::uint64_t key) {
    return "edge " + std::to_string(key >> 32U) + "-" + std::to_string(key & 0xffffffffU);
}

core::Result<void> join(std::span<const Corners> corners, std::vector<SurfaceTriangle>& triangles) {
    const std::vector<MeshSide> sides = sortedSides(corners);
    std::string wrong;
    forEachEdge(sides, [&](std::span<const MeshSide> edge) {
        if (!wrong.empty())
            return;
        if (edge.size() != 2) {
            wrong = edgeName(edge[0].key) + ": found in " + std::to_string(edge.size()) +
                    " triangles, expected 2";
            return;
        }
        if (edge[0].forward == edge[1].forward)
            wrong = edgeName(edge[0].key) + ": triangles " + std::to_string(edge[0].triangle) + " and " +
                    std::to_string(edge[1].triangle) + " run along it the same way, expected opposite ways";
        triangles[edge[0].triangle].neighbour[edge[0].opposite] = edge[1].triangle;
        triangles[edge[1].triangle].neighbour[edge[1].opposite] = edge[0].triangle;
    });
    if (!wrong.empty())
        return core::fail(core::ErrorCode::badInput, wrong);
    return {};
}

struct Sorted {
    std::vector<core::Vec3> vertices;
    std::vector<Corners> triangles;
};

/// Puts triangles in the tree's order and vertices in the order of their first triangle, so that a step to a
/// neighbour finds its data nearby.
Sorted sortedForTheTick(std::span<const core::Vec3> vertices, std::span<const Corners> triangles,
                        std::span<const std::uint32_t> order) {
    constexpr std::uint32_t kNew = 0xffffffffU;
    Sorted out;
    std::vector<std::uint32_t> number(vertices.size(), kNew);
    out.triangles.reserve(triangles.size());
    out.vertices.reserve(vertices.size());
    for (const std::uint32_t t : order) {
        Corners corners = triangles[t];
        for (std::uint32_t& corner : corners) {
            if (number[corner] == kNew) {
                number[corner] = static_cast<std::uint32_t>(out.vertices.size());
                out.vertices.push_back(vertices[corner]);
            }
            corner = number[corner];
        }
        out.triangles.push_back(corners);
    }
    return out;
}

/// The angles of a triangle at its corners, rad.
CornerAngles anglesOf(const std::array<core::Vec3, 3>& p) noexcept {
    CornerAngles angles{};
    for (std::size_t i = 0; i < 3; ++i) {
        const core::Vec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
        angles[i] = std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return angles;
}

/// Adds the normal of one triangle to its corners, with these weights.
void addNormals(const Corners& corners, const CornerAngles& weights, const std::array<core::Vec3, 3>& p,
                std::span<core::Vec3> normals) noexcept {
    const core::Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    for (std::size_t i = 0; i < 3; ++i)
        normals[corners[i]] += weights[i] * normal;
}

core::Result<void> checkNumbers(std::span<const core::Vec3> vertices, std::span<const Corners> triangles) {
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (!vertices[v].allFinite())
            return core::fail(core::ErrorCode::badInput,
                              "vertex " + std::to_string(v) + ": not a finite number");
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const std::uint32_t v : triangles[t])
            if (v >= vertices.size())
                return core::fail(core::ErrorCode::badInput, "triangle " + std::to_string(t) + ": vertex " +
                                                                 std::to_string(v) + " of " +
                                                                 std::to_string(vertices.size()));
        const core::Vec3& a = vertices[triangles[t][0]];
        const core::Vec3 side = (vertices[triangles[t][1]] - a).cross(vertices[triangles[t][2]] - a);
        if (!(side.squaredNorm() > 0.0))
            return core::fail(core::ErrorCode::badInput, "triangle " + std::to_string(t) + ": no area");
    }
    return {};
}

} // namespace

core::Result<TriangleMesh> TriangleMesh::create(std::span<const core::Vec3> vertices,
                                                std::span<const Corners> triangles) {
    if (triangles.empty() || triangles.size() > kMostTriangles)
        return core::fail(core::ErrorCode::badInput, std::to_string(triangles.size()) +
                                                         " triangles, expected 4 to " +
                                                         std::to_string(kMostTriangles));
    CHIRON_TRY(checkNumbers(vertices, triangles));
    std::vector<SurfaceTriangle> unsorted(triangles.size());
    CHIRON_TRY(join(triangles, unsorted)); // errors name the caller's numbers
    std::vector<std::array<core::Vec3, 3>> places;
    places.reserve(triangles.size());
    for (const Corners& t : triangles)
        places.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
    TriangleMesh mesh;
    std::vector<std::uint32_t> order;
    mesh.m_tree = MeshTree(places, order);
    const Sorted sorted = sortedForTheTick(vertices, triangles, order);
    std::vector<std::uint32_t> now(order.size());
    for (std::uint32_t t = 0; t < order.size(); ++t)
        now[order[t]] = t;
    mesh.m_triangles.resize(order.size());
    for (std::uint32_t t = 0; t < order.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            mesh.m_triangles[t].neighbour[i] = now[unsorted[order[t]].neighbour[i]];
    mesh.lay(sorted.vertices, sorted.triangles);
    return mesh;
}

void TriangleMesh::lay(std::span<const core::Vec3> vertices, std::span<const Corners> triangles) {
    std::vector<core::Vec3> normals(vertices.size(), core::Vec3::Zero());
    double sum = 0.0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        m_triangles[t].vertex = triangles[t];
        const std::array<core::Vec3, 3> p{vertices[triangles[t][0]], vertices[triangles[t][1]],
                                          vertices[triangles[t][2]]};
        addNormals(triangles[t], anglesOf(p), p, normals);
        for (std::size_t i = 0; i < 3; ++i) {
            const double edge = (p[(i + 1) % 3] - p[i]).norm();
            sum += edge;
            m_longestEdge_m = std::max(m_longestEdge_m, edge);
        }
    }
    m_meanEdge_m = sum / (3.0 * static_cast<double>(triangles.size()));
    m_lowest = m_highest = vertices[triangles[0][0]];
    m_vertices.reserve(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double length = normals[v].norm();
        m_vertices.push_back(
            {vertices[v], length > 0.0 ? core::Vec3(normals[v] / length) : core::Vec3::UnitZ()});
        m_lowest = m_lowest.cwiseMin(vertices[v]);
        m_highest = m_highest.cwiseMax(vertices[v]);
    }
}

std::vector<CornerAngles> cornerAngles(const TriangleMesh& mesh) {
    std::vector<CornerAngles> angles;
    angles.reserve(mesh.triangles().size());
    for (const SurfaceTriangle& triangle : mesh.triangles())
        angles.push_back(anglesOf({mesh.position(triangle.vertex[0]), mesh.position(triangle.vertex[1]),
                                   mesh.position(triangle.vertex[2])}));
    return angles;
}

void smoothNormals(const TriangleMesh& mesh, std::span<const CornerAngles> weights,
                   std::span<const core::Vec3> moved, std::span<core::Vec3> normals) noexcept {
    std::fill(normals.begin(), normals.end(), core::Vec3::Zero());
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
        const Corners& v = mesh.triangles()[t].vertex;
        addNormals(v, weights[t], {moved[v[0]], moved[v[1]], moved[v[2]]}, normals);
    }
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const double length = normals[v].norm();
        normals[v] =
            length > 0.0 ? core::Vec3(normals[v] / length) : mesh.normal(static_cast<std::uint32_t>(v));
    }
}

} // namespace chiron::simulation
