// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/make_mesh.h"
#include "simulation/geometry/mesh/mesh_report.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::simulation {

/// A mesh during import: its shape, and the line of the file from which each triangle came (empty if there
/// are no lines).
struct ReadMesh {
    MeshShape shape;
    std::vector<std::uint32_t> lines;
};

/// Splits bytes into lines and words for the text readers.
class MeshLines {
public:
    explicit MeshLines(std::string_view bytes) noexcept : m_rest(bytes) {}
    bool next() noexcept;                                      ///< goes to the next line; false at the end
    std::uint32_t number() const noexcept { return m_number; } ///< from 1
    std::string place() const { return "line " + std::to_string(m_number); }
    std::string_view word() noexcept; ///< the next word of the line; empty if none is left

private:
    std::string_view m_rest;
    std::string_view m_line;
    std::uint32_t m_number = 0;
};

/// Reads three numbers from the words of the line. Returns false, with a finding, if one is missing, not a
/// number or not finite.
bool readPoint(MeshLines& lines, double scale, core::Vec3& out, MeshReport& report);
/// Adds one triangle. Returns false, with a finding, if that is one too many.
bool addTriangle(ReadMesh& mesh, const std::array<std::uint32_t, 3>& corners, std::uint32_t line,
                 MeshReport& report);
MeshFinding tooMany(const std::string& place, std::size_t found);

/// The readers stop at the first thing that they cannot read; the report says what it was.
ReadMesh readObj(std::string_view bytes, double metresPerUnit, MeshReport& report);
ReadMesh readStl(std::string_view bytes, double metresPerUnit, MeshReport& report);

/// Repairs and checks, in the order in which importMesh() applies them. Each adds its findings to the report.
void joinVertices(ReadMesh& mesh, MeshReport& report);
void dropTriangles(ReadMesh& mesh, MeshReport& report); ///< drops those that have no area or occur twice
/// False: there are holes, or edges of three triangles.
bool checkEdges(const ReadMesh& mesh, MeshReport& report);
/// Turns all of a shell the same way, outwards; false: the shell is one-sided.
bool turnTriangles(ReadMesh& mesh, MeshReport& report);
void splitVertices(ReadMesh& mesh, MeshReport& report); ///< gives every fan of triangles its own vertex
void dropVertices(ReadMesh& mesh, MeshReport& report);  ///< drops those that no triangle uses

std::string trianglePlace(const ReadMesh& mesh, std::size_t triangle);
std::string edgePlace(const ReadMesh& mesh, std::uint64_t key);

} // namespace chiron::simulation
