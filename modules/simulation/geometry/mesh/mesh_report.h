// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace chiron::simulation {

/// Problems that an imported mesh can have.
enum class MeshProblem : std::uint8_t {
    wrongFile,        ///< neither OBJ nor STL
    truncated,        ///< the file ends in the middle of its data
    badLine,          ///< a line without meaning
    badNumber,        ///< not a number, or not finite
    badIndex,         ///< a corner that refers to no vertex
    tooManyTriangles, ///< more than TriangleMesh::kMostTriangles
    noTriangles,
    polygons, ///< faces of more than three corners; they are cut into triangles
    bytesBehindTheEnd,
    duplicateVertices, ///< the same position more than once
    unusedVertices,
    degenerateTriangle, ///< no area
    doubledTriangle,    ///< the same three corners twice
    hole,               ///< an edge that only one triangle has
    nonManifoldEdge,    ///< an edge that three or more triangles share
    nonManifoldVertex,  ///< two fans of triangles that share nothing but a vertex
    flippedTriangle,    ///< faces the other way than its neighbours
    oneSided,           ///< has no outside (a Möbius strip)
    insideOut,          ///< a whole shell faces inwards
    severalShells,      ///< parts that are not connected
};
inline constexpr std::size_t kMeshProblems = 20;

/// One finding: where it is, what was found, what was expected, how often it occurs, and whether it was
/// repaired.
struct MeshFinding {
    MeshProblem problem = MeshProblem::wrongFile;
    /// Place of the first one: "line 12", "triangle 7 (line 310)", "edge 3-8 at (1.0, 2.0, 3.5) mm", "byte
    /// 80".
    std::string place;
    std::string found;
    std::string expected;
    std::size_t count = 1; ///< how many problems of this type there are in all
    bool repaired = false; ///< repaired, or harmless; otherwise the mesh is refused
};

/// All findings about a mesh. The texts are English, for people and logs; programs (and translations) use the
/// MeshProblem values.
struct MeshReport {
    /// At most one for each MeshProblem, in the order in which they were met.
    std::vector<MeshFinding> findings;
    std::size_t vertices = 0; ///< of the resulting mesh
    std::size_t triangles = 0;
    std::size_t shells = 0;
    std::array<double, 3> size_m{}; ///< of the bounding box
    double volume_m3 = 0.0;

    /// Adds to the finding with the same problem, or as a new one.
    void add(MeshFinding finding);
    const MeshFinding* find(MeshProblem problem) const noexcept; ///< nullptr: there is no such finding
    bool usable() const noexcept; ///< every finding has been repaired or is harmless
    /// Returns one line for each finding, and one about the resulting mesh.
    std::string text() const;
};

} // namespace chiron::simulation
