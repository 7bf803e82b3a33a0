// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/make_mesh.h"
#include "simulation/geometry/mesh/mesh_report.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::simulation {

/// A mesh on its way in: its shape and which line of the file each triangle came from (empty: from none).
struct ReadMesh {
    MeshShape shape;
    std::vector<std::uint32_t> lines;
};

/// What the text readers share: lines and words of bytes, and numbers that are numbers.
class MeshLines {
public:
    explicit MeshLines(std::string_view bytes) noexcept : m_rest(bytes) {}
    bool next() noexcept;                          ///< goes to the next line; false at the end
    std::uint32_t number() const noexcept { return m_number; } ///< from 1
    std::string place() const { return "line " + std::to_string(m_number); }
    std::string_view word() noexcept;              ///< the next word of the line; empty: none is left

private:
    std::string_view m_rest;
    std::string_view m_line;
    std::uint32_t m_number = 0;
};

/// Three numbers from words; false, with a finding, if one is missing, no number or not finite.
bool readPoint(MeshLines& lines, double scale, core::Vec3& out, MeshReport& report);
/// One triangle more; false, with a finding, if that is one too many.
bool addTriangle(ReadMesh& mesh, const std::array<std::uint32_t, 3>& corners, std::uint32_t line, MeshReport& report);
MeshFinding tooMany(const std::string& place, std::size_t found);

/// Readers stop at the first thing that cannot be read; what it was is in the report.
ReadMesh readObj(std::string_view bytes, double metresPerUnit, MeshReport& report);
ReadMesh readStl(std::string_view bytes, double metresPerUnit, MeshReport& report);

/// Repairs, in the order in which importMesh() takes them. Each adds what it found.
void joinVertices(ReadMesh& mesh, MeshReport& report);
void dropTriangles(ReadMesh& mesh, MeshReport& report);  ///< without area, or there twice
bool checkEdges(const ReadMesh& mesh, MeshReport& report); ///< false: holes, or edges of three triangles
bool turnTriangles(ReadMesh& mesh, MeshReport& report);  ///< one way for all of a shell, outwards; false: one-sided
void splitVertices(ReadMesh& mesh, MeshReport& report);  ///< a vertex for every fan
void dropVertices(ReadMesh& mesh, MeshReport& report);   ///< that no triangle uses

std::string trianglePlace(const ReadMesh& mesh, std::size_t triangle);
std::string edgePlace(const ReadMesh& mesh, std::uint64_t key);

} // namespace chiron::simulation
