// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace chiron::simulation {

/// What can be wrong with a mesh that somebody brings.
enum class MeshProblem : std::uint8_t {
    wrongFile,          ///< neither OBJ nor STL
    truncated,          ///< it ends in the middle
    badLine,            ///< a line that says nothing
    badNumber,          ///< not a number, or not finite
    badIndex,           ///< a corner that is no vertex
    tooManyTriangles,   ///< more than TriangleMesh::kMostTriangles
    noTriangles,
    polygons,           ///< faces of more than three corners, cut into triangles
    bytesBehindTheEnd,
    duplicateVertices,  ///< the same place more than once
    unusedVertices,
    degenerateTriangle, ///< no area
    doubledTriangle,    ///< the same three corners twice
    hole,               ///< an edge of one triangle only
    nonManifoldEdge,    ///< an edge of three triangles or more
    nonManifoldVertex,  ///< two fans of triangles that share nothing but a vertex
    flippedTriangle,    ///< looks the other way than its neighbours
    oneSided,           ///< cannot be given an outside (a Möbius strip)
    insideOut,          ///< all of a shell looks inwards
    severalShells,      ///< parts that do not hang together
};
inline constexpr std::size_t kMeshProblems = 20;

/// One finding: where, what was found, what was expected, how often, and whether it was put right.
struct MeshFinding {
    MeshProblem problem = MeshProblem::wrongFile;
    std::string place;    ///< of the first one: "line 12", "triangle 7 (line 310)", "edge 3-8 at (1.0, 2.0, 3.5) mm", "byte 80"
    std::string found;
    std::string expected;
    std::size_t count = 1; ///< how many of this kind in all
    bool repaired = false; ///< put right, or harmless; else the mesh is refused
};

/// All that was found in a mesh. English, for people and logs; the kinds are for programs (and translations).
struct MeshReport {
    std::vector<MeshFinding> findings; ///< one a kind at most, in the order in which they were met
    std::size_t vertices = 0;          ///< of the mesh as it came out
    std::size_t triangles = 0;
    std::size_t shells = 0;
    std::array<double, 3> size_m{};    ///< of the box round it
    double volume_m3 = 0.0;

    /// Adds to the finding of this kind, or a new one.
    void add(MeshFinding finding);
    const MeshFinding* find(MeshProblem problem) const noexcept; ///< nullptr: none of this kind
    bool usable() const noexcept; ///< nothing is left that was not put right
    /// One line a finding, and one of what came out.
    std::string text() const;
};

} // namespace chiron::simulation
