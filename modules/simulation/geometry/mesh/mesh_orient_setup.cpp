// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_reading.h"
#include "simulation/geometry/mesh/mesh_sides.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// Up to this many shells are tested for which lies in which; if there are more, all face outwards.
constexpr std::size_t kMostNested = 64;
constexpr std::uint32_t kNone = 0xffffffffU;

struct Neighbour {
    std::uint32_t triangle = 0;
    bool same = false; ///< runs along the edge in the same direction: one of the two is flipped
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours neighboursOf(const MeshShape& shape) {
    Neighbours out(shape.triangles.size());
    const std::vector<MeshSide> sides = sortedSides(shape.triangles);
    forEachEdge(sides, [&](std::span<const MeshSide> edge) {
        const bool same = edge[0].forward == edge[1].forward;
        out[edge[0].triangle][edge[0].opposite] = {edge[1].triangle, same};
        out[edge[1].triangle][edge[1].opposite] = {edge[0].triangle, same};
    });
    return out;
}

struct Shell {
    std::vector<std::uint32_t> triangles;
    core::Vec3 low = core::Vec3::Zero(), high = core::Vec3::Zero();
    double volume_m3 = 0.0; ///< signed, by the present orientation of its triangles
};

/// Collects one shell from triangle `start`. It visits every neighbour and records which triangles face the
/// other way than the first. Returns false if the shell is one-sided.
bool gather(const Neighbours& neighbours, std::uint32_t start, std::vector<std::uint8_t>& flip,
            Shell& shell) {
    constexpr std::uint8_t kUnseen = 2;
    flip[start] = 0;
    shell.triangles.push_back(start);
    bool twoSided = true;
    for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
        const std::uint32_t t = shell.triangles[i];
        for (const Neighbour& n : neighbours[t]) {
            const auto wanted = static_cast<std::uint8_t>(flip[t] ^ (n.same ? 1 : 0));
            if (flip[n.triangle] == kUnseen) {
                flip[n.triangle] = wanted;
                shell.triangles.push_back(n.triangle);
            } else if (flip[n.triangle] != wanted) {
                twoSided = false;
            }
        }
    }
    std::sort(shell.triangles.begin(), shell.triangles.end());
    return twoSided;
}

void measure(const MeshShape& shape, Shell& shell) {
    const core::Vec3 origin = shape.vertices[shape.triangles[shell.triangles[0]][0]];
    shell.low = shell.high = origin;
    shell.volume_m3 = 0.0;
    for (const std::uint32_t t : shell.triangles) {
        const core::Vec3 a = shape.vertices[shape.triangles[t][0]], b = shape.vertices[shape.triangles[t][1]],
                         c = shape.vertices[shape.triangles[t][2]];
        shell.volume_m3 += (a - origin).dot((b - origin).cross(c - origin)) / 6.0;
        shell.low = shell.low.cwiseMin(a).cwiseMin(b).cwiseMin(c);
        shell.high = shell.high.cwiseMax(a).cwiseMax(b).cwiseMax(c);
    }
}

/// Says whether the shell winds around p. The winding number (van Oosterom & Strackee 1983) is about 1 or −1
/// inside, 0 outside.
bool windsRound(const MeshShape& shape, const Shell& shell, const core::Vec3& p) {
    if ((p.array() < shell.low.array()).any() || (p.array() > shell.high.array()).any())
        return false;
    double sum = 0.0;
    for (const std::uint32_t t : shell.triangles) {
        const core::Vec3 a = shape.vertices[shape.triangles[t][0]] - p,
                         b = shape.vertices[shape.triangles[t][1]] - p,
                         c = shape.vertices[shape.triangles[t][2]] - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum +=
            2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return std::abs(sum) > 2.0 * core::kPi;
}

void turn(MeshShape& shape, std::uint32_t triangle) {
    std::swap(shape.triangles[triangle][1], shape.triangles[triangle][2]);
}

/// Orients a shell consistently by turning the minority of its triangles.
void turnFew(ReadMesh& mesh, const std::vector<std::uint8_t>& flip, const Shell& shell, MeshReport& report) {
    const auto others = static_cast<std::size_t>(std::count_if(
        shell.triangles.begin(), shell.triangles.end(), [&](std::uint32_t t) { return flip[t] == 1; }));
    const std::uint8_t few = 2 * others > shell.triangles.size() ? 0 : 1;
    for (const std::uint32_t t : shell.triangles)
        if (flip[t] == few) {
            turn(mesh.shape, t);
            report.add({MeshProblem::flippedTriangle, trianglePlace(mesh, t),
                        "looks the other way than its neighbours, turned", "all one way", 1, true});
        }
}

/// Turns whole shells outwards, or inwards where the shell is the wall of a hollow.
void turnOut(ReadMesh& mesh, std::vector<Shell>& shells, MeshReport& report) {
    for (std::size_t s = 0; s < shells.size(); ++s) {
        const core::Vec3& p = mesh.shape.vertices[mesh.shape.triangles[shells[s].triangles[0]][0]];
        std::size_t around = 0;
        for (std::size_t o = 0; shells.size() <= kMostNested && o < shells.size(); ++o)
            around += o != s && windsRound(mesh.shape, shells[o], p) ? 1 : 0;
        const bool hollow = around % 2 == 1;
        if ((shells[s].volume_m3 < 0.0) == hollow)
            continue;
        for (const std::uint32_t t : shells[s].triangles)
            turn(mesh.shape, t);
        shells[s].volume_m3 = -shells[s].volume_m3;
        report.add(
            {MeshProblem::insideOut,
             "shell " + std::to_string(s + 1) + ", from " + trianglePlace(mesh, shells[s].triangles[0]),
             "its inside is outside, turned",
             hollow ? "the wall of a hollow looks into it" : "outwards, counter-clockwise", 1, true});
    }
}

} // namespace

bool checkEdges(const ReadMesh& mesh, MeshReport& report) {
    MeshFinding hole{
        MeshProblem::hole, {}, "an edge of one triangle: a hole", "every edge in two triangles", 0, false};
    MeshFinding many{MeshProblem::nonManifoldEdge, {}, {}, "every edge in two triangles", 0, false};
    forEachEdge(sortedSides(mesh.shape.triangles), [&](std::span<const MeshSide> edge) {
        if (edge.size() == 1 && hole.count++ == 0)
            hole.place = edgePlace(mesh, edge[0].key) + ", " + trianglePlace(mesh, edge[0].triangle);
        if (edge.size() > 2 && many.count++ == 0) {
            many.place = edgePlace(mesh, edge[0].key) + ", " + trianglePlace(mesh, edge[2].triangle);
            many.found = "an edge of " + std::to_string(edge.size()) + " triangles";
        }
    });
    const bool closed = hole.count == 0 && many.count == 0;
    if (hole.count > 0)
        report.add(std::move(hole));
    if (many.count > 0)
        report.add(std::move(many));
    return closed;
}

bool turnTriangles(ReadMesh& mesh, MeshReport& report) {
    const Neighbours neighbours = neighboursOf(mesh.shape);
    std::vector<std::uint8_t> flip(mesh.shape.triangles.size(), 2);
    std::vector<Shell> shells;
    for (std::uint32_t t = 0; t < flip.size(); ++t) {
        if (flip[t] != 2)
            continue;
        Shell shell;
        if (!gather(neighbours, t, flip, shell)) {
            report.add({MeshProblem::oneSided, trianglePlace(mesh, t), "a surface with one side only",
                        "an inside and an outside", 1, false});
            return false;
        }
        turnFew(mesh, flip, shell, report);
        measure(mesh.shape, shell);
        shells.push_back(std::move(shell));
    }
    turnOut(mesh, shells, report);
    report.shells = shells.size();
    for (const Shell& shell : shells)
        report.volume_m3 += shell.volume_m3;
    if (shells.size() > 1)
        report.add({MeshProblem::severalShells,
                    "shell 2, from " + trianglePlace(mesh, shells[1].triangles[0]),
                    std::to_string(shells.size()) + " parts, kept", "one part", 1, true});
    return true;
}

void splitVertices(ReadMesh& mesh, MeshReport& report) {
    const Neighbours neighbours = neighboursOf(mesh.shape);
    const auto corners = mesh.shape.triangles;
    std::vector<std::array<bool, 3>> seen(corners.size(), {false, false, false});
    std::vector<bool> taken(mesh.shape.vertices.size(), false);
    for (std::uint32_t start = 0; start < corners.size(); ++start)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            if (seen[start][corner])
                continue;
            const std::uint32_t vertex = corners[start][corner];
            std::uint32_t name = vertex;
            if (taken[vertex]) {
                name = static_cast<std::uint32_t>(mesh.shape.vertices.size());
                mesh.shape.vertices.push_back(core::Vec3(mesh.shape.vertices[vertex]));
                report.add({MeshProblem::nonManifoldVertex,
                            "vertex " + std::to_string(vertex + 1ULL) + ", " + trianglePlace(mesh, start),
                            "two fans of triangles meet in it alone, given one each", "one fan a vertex", 1,
                            true});
            }
            taken[vertex] = true;
            std::uint32_t t = start;
            std::size_t at = corner;
            while (t != kNone && !seen[t][at]) { // once around the fan
                seen[t][at] = true;
                mesh.shape.triangles[t][at] = name;
                t = neighbours[t][(at + 1) % 3].triangle;
                at = static_cast<std::size_t>(std::find(corners[t].begin(), corners[t].end(), vertex) -
                                              corners[t].begin());
                if (at == 3)
                    t = kNone;
            }
        }
}

} // namespace chiron::simulation
