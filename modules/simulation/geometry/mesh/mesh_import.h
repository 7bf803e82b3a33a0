// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/make_mesh.h"
#include "simulation/geometry/mesh/mesh_report.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace chiron::simulation {

enum class MeshFormat : std::uint8_t { obj, stl };

/// What came of an import: the mesh if it could be used, its shape to be stored, and in any case the report.
struct MeshImport {
    std::optional<TriangleMesh> mesh;
    MeshShape shape; ///< as repaired; what `mesh` was made of
    MeshReport report;
};

/// Reads a mesh from a file's bytes, checks it and puts right what can be put right without changing its shape: vertices at
/// one place are joined, triangles without area or there twice are dropped if that leaves no hole, triangles that look the
/// wrong way are turned, fans that share one vertex get one each. Refused, with the place: holes, edges of three triangles,
/// numbers that are none, broken and wrong files, more than TriangleMesh::kMostTriangles (found while reading or from the
/// header: memory stays below 300 bytes a triangle of that limit, whatever the file claims).
/// Formats: OBJ (v, f; polygons as fans; the rest is passed over) and STL (ASCII and binary; stored normals are passed over).
/// `metresPerUnit` > 0: neither format knows its unit; 0.001 for millimetres. Deterministic. Allocates; 1 s for 500,000
/// triangles. Thread: any but the haptic one.
MeshImport importMesh(std::string_view bytes, MeshFormat format, double metresPerUnit = 0.001);

/// The same checks and repairs for a shape in memory (metres).
MeshImport importMesh(MeshShape shape);

/// What the bytes are, by their beginning and length, not by a name; none: neither.
std::optional<MeshFormat> guessMeshFormat(std::string_view bytes) noexcept;

// What content takes of a stored mesh (schema/mesh_source.json).
inline constexpr std::size_t kMostStoredVertices = 50'000;
inline constexpr std::size_t kMostStoredTriangles = 100'000;
inline constexpr double kFarthestStored_um = 1e6; ///< from the origin, along each axis

/// The shape as content stores it, in whole micrometres. Rounding can close what was thin: the rounded shape is checked and put
/// right once more, as importMesh() does. Refused, with the place: what cannot be put right then, and what content does not take
/// (a vertex more than 1 m away, more than kMostStoredVertices or kMostStoredTriangles).
core::Result<MeshSource> storedMesh(const MeshShape& shape, std::string id);

/// The shape as a file, in units of `metresPerUnit`: 9 digits (OBJ, ASCII STL) or single precision (binary STL).
std::string writeObj(const MeshShape& shape, double metresPerUnit = 0.001);
std::string writeStl(const MeshShape& shape, double metresPerUnit = 0.001);
std::string writeBinaryStl(const MeshShape& shape, double metresPerUnit = 0.001);

} // namespace chiron::simulation
