// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_reading.h"
#include "simulation/geometry/mesh/mesh_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace chiron::simulation {

namespace {

/// Vertices that are nearer to each other than this share of the mesh's size are joined where the mesh would
/// otherwise have holes. Assumption: single precision keeps 1e-7 of the size.
constexpr double kNear = 1e-6;

using Key = std::array<double, 3>;

std::size_t openEdges(const MeshShape& shape) {
    std::size_t open = 0;
    forEachEdge(sortedSides(shape.triangles),
                [&](std::span<const MeshSide> edge) { open += edge.size() == 1 ? 1 : 0; });
    return open;
}

/// Keeps the vertices for which `keep` holds. Corners first move to the vertex that `into` names and then get
/// its new number.
void renumber(MeshShape& shape, const std::vector<std::uint32_t>& into, const std::vector<bool>& keep) {
    std::vector<std::uint32_t> number(shape.vertices.size(), 0);
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
        if (keep[v]) {
            number[v] = count;
            shape.vertices[count++] = shape.vertices[v];
        }
    shape.vertices.resize(count);
    for (auto& triangle : shape.triangles)
        for (std::uint32_t& corner : triangle)
            corner = number[into[corner]];
}

/// Joins the vertices whose keys agree into the first of them. Returns the first vertex that is removed and
/// the number of removed ones.
template <class KeyOf> std::pair<std::size_t, std::size_t> joinBy(MeshShape& shape, KeyOf&& keyOf) {
    std::vector<Key> keys;
    keys.reserve(shape.vertices.size());
    for (const core::Vec3& p : shape.vertices)
        keys.push_back(keyOf(p));
    std::vector<std::uint32_t> order(keys.size()), into(keys.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::tie(keys[a], a) < std::tie(keys[b], b); });
    std::vector<bool> keep(keys.size(), false);
    std::size_t first = std::numeric_limits<std::size_t>::max(), joined = 0;
    std::uint32_t head = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || keys[order[i]] != keys[head]) {
            head = order[i];
            keep[head] = true;
        } else {
            first = std::min<std::size_t>(first, order[i]);
            ++joined;
        }
        into[order[i]] = head;
    }
    if (joined > 0)
        renumber(shape, into, keep);
    return {first, joined};
}

void tell(const std::pair<std::size_t, std::size_t>& joined, const char* how, MeshReport& report) {
    if (joined.second > 0)
        report.add({MeshProblem::duplicateVertices, "vertex " + std::to_string(joined.first + 1), how,
                    "one vertex a place", joined.second, true});
}

/// Two positions that are nearer than `near` along every axis share a cell of twice that size in one of eight
/// grids, which are shifted by half a cell or not along each axis.
void joinNear(MeshShape& shape, double near, MeshReport& report) {
    for (int grid = 0; grid < 8; ++grid)
        tell(joinBy(shape,
                    [&](const core::Vec3& p) {
                        Key key{};
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            key[axis] = std::floor(p[static_cast<Eigen::Index>(axis)] / (2.0 * near) +
                                                   ((grid >> axis & 1) != 0 ? 0.5 : 0.0));
                        return key;
                    }),
             "lies within a millionth of the size of another one, joined", report);
}

bool noArea(const MeshShape& shape, const std::array<std::uint32_t, 3>& t) {
    const core::Vec3 a = shape.vertices[t[1]] - shape.vertices[t[0]],
                     b = shape.vertices[t[2]] - shape.vertices[t[0]];
    const double longest2 = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return !(a.cross(b).norm() > 1e-9 * longest2);
}

template <class Drop> void dropWhere(ReadMesh& mesh, Drop&& drop) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.shape.triangles.size(); ++t)
        if (!drop(t)) {
            mesh.shape.triangles[kept] = mesh.shape.triangles[t];
            if (!mesh.lines.empty())
                mesh.lines[kept] = mesh.lines[t];
            ++kept;
        }
    mesh.shape.triangles.resize(kept);
    if (!mesh.lines.empty())
        mesh.lines.resize(kept);
}

void dropDoubled(ReadMesh& mesh, MeshReport& report) {
    std::vector<std::array<std::uint32_t, 3>> turned = mesh.shape.triangles;
    for (auto& t : turned) // rotated so that the lowest corner comes first; the orientation stays
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::vector<std::uint32_t> order(turned.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(turned[a], a) < std::tie(turned[b], b);
    });
    std::vector<bool> again(turned.size(), false);
    for (std::size_t i = 1; i < order.size(); ++i)
        if (turned[order[i]] == turned[order[i - 1]]) {
            again[order[i]] = true;
            report.add({MeshProblem::doubledTriangle, trianglePlace(mesh, order[i]),
                        "the same three corners as " + trianglePlace(mesh, order[i - 1]) + ", dropped",
                        "every triangle once", 1, true});
        }
    dropWhere(mesh, [&](std::size_t t) { return again[t]; });
}

} // namespace

void joinVertices(ReadMesh& mesh, MeshReport& report) {
    MeshShape& shape = mesh.shape;
    tell(joinBy(shape,
                [](const core::Vec3& p) {
                    return Key{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
                }),
         "lies where another one does, joined", report);
    if (shape.vertices.empty() || openEdges(shape) == 0)
        return;
    core::Vec3 low = shape.vertices[0], high = low;
    for (const core::Vec3& p : shape.vertices) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    if ((high - low).norm() > 0.0)
        joinNear(shape, kNear * (high - low).norm(), report);
}

void dropTriangles(ReadMesh& mesh, MeshReport& report) {
    const auto same = [&](std::size_t t) {
        const auto& c = mesh.shape.triangles[t];
        return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
    };
    for (std::size_t t = 0; t < mesh.shape.triangles.size(); ++t)
        if (same(t))
            report.add({MeshProblem::degenerateTriangle, trianglePlace(mesh, t),
                        "two corners at one place, dropped", "three corners", 1, true});
    dropWhere(mesh, same); // its other two sides were one edge, so no hole opens
    dropDoubled(mesh, report);
    std::vector<bool> flat(mesh.shape.triangles.size());
    MeshFinding finding{MeshProblem::degenerateTriangle, {}, {}, "a triangle with an area", 0, false};
    for (std::size_t t = 0; t < flat.size(); ++t) {
        flat[t] = noArea(mesh.shape, mesh.shape.triangles[t]);
        if (flat[t] && finding.count++ == 0)
            finding.place = trianglePlace(mesh, t);
    }
    if (finding.count == 0)
        return;
    ReadMesh without = mesh;
    dropWhere(without, [&](std::size_t t) { return flat[t]; });
    finding.repaired = openEdges(without.shape) <= openEdges(mesh.shape);
    finding.found = finding.repaired ? "three corners on a line, dropped"
                                     : "three corners on a line; without it there would be a hole";
    if (finding.repaired)
        mesh = std::move(without);
    report.add(std::move(finding));
}

void dropVertices(ReadMesh& mesh, MeshReport& report) {
    std::vector<bool> used(mesh.shape.vertices.size(), false);
    for (const auto& triangle : mesh.shape.triangles)
        for (const std::uint32_t corner : triangle)
            used[corner] = true;
    const auto unused = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
    if (unused == 0)
        return;
    const auto first = std::find(used.begin(), used.end(), false) - used.begin();
    report.add({MeshProblem::unusedVertices, "vertex " + std::to_string(first + 1), "in no triangle, dropped",
                "vertices of triangles", unused, true});
    std::vector<std::uint32_t> into(used.size());
    std::iota(into.begin(), into.end(), 0U);
    renumber(mesh.shape, into, used);
}

} // namespace chiron::simulation
