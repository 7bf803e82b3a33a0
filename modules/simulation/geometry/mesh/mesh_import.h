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

/// Result of an import: the mesh if it can be used, its shape for storage, and in any case the report.
struct MeshImport {
    std::optional<TriangleMesh> mesh;
    MeshShape shape; ///< as repaired; `mesh` was made from it
    MeshReport report;
};

/// Reads a mesh from a file's bytes, checks it, and repairs it where this does not change its shape. It joins
/// vertices at the same position, drops triangles that have no area or occur twice if that leaves no hole,
/// turns triangles that face the wrong way, and gives every fan of triangles its own vertex where fans share
/// only a vertex. It refuses, naming the place, holes, edges of three triangles, numbers that are not
/// numbers, broken and unknown files, and more than TriangleMesh::kMostTriangles. That limit is checked while
/// reading or from the header, so memory stays below 300 bytes per triangle of the limit, whatever the file
/// claims.
///
/// The formats are OBJ (v, f; polygons as fans; everything else is skipped) and STL (ASCII and binary; stored
/// normals are skipped). `metresPerUnit` > 0 is needed because neither format states its unit; 0.001 means
/// millimetres. Deterministic. Allocates; takes 1 s for 500,000 triangles.
/// Thread: any but the haptic one.
MeshImport importMesh(std::string_view bytes, MeshFormat format, double metresPerUnit = 0.001);

/// Checks and repairs a shape in memory (metres) in the same way.
MeshImport importMesh(MeshShape shape);

/// Recognises the format of the bytes by their beginning and length, not by a name; returns nothing if they
/// are neither.
std::optional<MeshFormat> guessMeshFormat(std::string_view bytes) noexcept;

// Limits of a stored mesh in content (schema/mesh_source.json).
inline constexpr std::size_t kMostStoredVertices = 50'000;
inline constexpr std::size_t kMostStoredTriangles = 100'000;
inline constexpr double kFarthestStored_um = 1e6; ///< distance from the origin along each axis

/// Converts the shape to the form that content stores, in whole micrometres. Because rounding can close thin
/// parts, the rounded shape is checked and repaired once more, as in importMesh().
/// Errors: refuses, naming the place, what cannot be repaired then and what content does not accept (a vertex
/// more than 1 m away, more than kMostStoredVertices or kMostStoredTriangles).
core::Result<MeshSource> storedMesh(const MeshShape& shape, std::string id);

/// Write the shape as a file, in units of `metresPerUnit`, with 9 digits (OBJ, ASCII STL) or single precision
/// (binary STL).
std::string writeObj(const MeshShape& shape, double metresPerUnit = 0.001);
std::string writeStl(const MeshShape& shape, double metresPerUnit = 0.001);
std::string writeBinaryStl(const MeshShape& shape, double metresPerUnit = 0.001);

} // namespace chiron::simulation
