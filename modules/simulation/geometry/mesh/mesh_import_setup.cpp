// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_import.h"
#include "simulation/geometry/mesh/mesh_reading.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

namespace chiron::simulation {

namespace {

MeshImport finish(ReadMesh read, MeshReport report) {
    MeshImport out;
    const bool readable = report.usable();
    if (readable && read.shape.triangles.empty())
        report.add({MeshProblem::noTriangles, "the end of the file", "no triangle", "four at least"});
    if (report.usable()) {
        joinVertices(read, report);
        dropTriangles(read, report);
        dropVertices(read, report);
    }
    if (report.usable() && read.shape.triangles.empty())
        report.add(
            {MeshProblem::noTriangles, "the end of the file", "no triangle with an area", "four at least"});
    if (report.usable() && checkEdges(read, report) && turnTriangles(read, report))
        splitVertices(read, report);
    out.shape = std::move(read.shape);
    if (report.usable()) {
        if (auto mesh = TriangleMesh::create(out.shape.vertices, out.shape.triangles)) {
            report.vertices = mesh->vertices().size();
            report.triangles = mesh->triangles().size();
            for (std::size_t axis = 0; axis < 3; ++axis)
                report.size_m[axis] = (mesh->highest() - mesh->lowest())[static_cast<Eigen::Index>(axis)];
            out.mesh = std::move(*mesh);
        } else {
            report.add(
                {MeshProblem::degenerateTriangle, "the mesh", mesh.error().message, "a closed surface"});
        }
    }
    out.report = std::move(report);
    return out;
}

void appendPoint(std::string& out, const char* tag, const core::Vec3& p, double metresPerUnit) {
    char line[120];
    std::snprintf(line, sizeof line, "%s %.9g %.9g %.9g\n", tag, p.x() / metresPerUnit, p.y() / metresPerUnit,
                  p.z() / metresPerUnit);
    out += line;
}

core::Vec3 normalOf(const MeshShape& shape, const std::array<std::uint32_t, 3>& t) {
    return (shape.vertices[t[1]] - shape.vertices[t[0]])
        .cross(shape.vertices[t[2]] - shape.vertices[t[0]])
        .normalized();
}

void appendWhole(std::string& out, std::uint32_t value) {
    for (int i = 0; i < 4; ++i)
        out += static_cast<char>(value >> (8 * i) & 0xffU);
}

core::Result<MeshSource> inMicrometres(const MeshShape& shape) {
    if (shape.vertices.size() > kMostStoredVertices || shape.triangles.size() > kMostStoredTriangles)
        return core::fail(core::ErrorCode::badInput,
                          "mesh: " + std::to_string(shape.vertices.size()) + " vertices and " +
                              std::to_string(shape.triangles.size()) + " triangles, expected at most " +
                              std::to_string(kMostStoredVertices) + " and " +
                              std::to_string(kMostStoredTriangles) + " in content");
    MeshSource source;
    source.shape = MeshSource::Shape::stored;
    source.vertices_um.reserve(3 * shape.vertices.size());
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const double um = std::nearbyint(1e6 * shape.vertices[v][axis]);
            if (!(std::abs(um) <= kFarthestStored_um))
                return core::fail(core::ErrorCode::badInput, "mesh: vertex " + std::to_string(v) + ": " +
                                                                 std::to_string(1e-6 * um) +
                                                                 " m, expected within 1 m");
            source.vertices_um.push_back(static_cast<std::int32_t>(um));
        }
    source.triangles.reserve(3 * shape.triangles.size());
    for (const auto& triangle : shape.triangles)
        source.triangles.insert(source.triangles.end(), triangle.begin(), triangle.end());
    return source;
}

} // namespace

MeshImport importMesh(std::string_view bytes, MeshFormat format, double metresPerUnit) {
    MeshReport report;
    if (!(metresPerUnit > 0.0) || !std::isfinite(metresPerUnit))
        report.add({MeshProblem::badNumber, "the unit", std::to_string(metresPerUnit) + " m", "more than 0"});
    else if (!guessMeshFormat(bytes) && bytes.substr(0, 5) != "solid" &&
             (format == MeshFormat::obj || bytes.empty()))
        report.add({MeshProblem::wrongFile, "the beginning",
                    bytes.empty() ? "an empty file" : "neither OBJ nor STL", "OBJ or STL"});
    if (!report.usable()) {
        MeshImport out;
        out.report = std::move(report);
        return out;
    }
    ReadMesh read = format == MeshFormat::obj ? readObj(bytes, metresPerUnit, report)
                                              : readStl(bytes, metresPerUnit, report);
    return finish(std::move(read), std::move(report));
}

MeshImport importMesh(MeshShape shape) {
    MeshReport report;
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
        if (!shape.vertices[v].allFinite())
            report.add({MeshProblem::badNumber, "vertex " + std::to_string(v + 1), "not a finite number",
                        "a finite number"});
    for (std::size_t t = 0; t < shape.triangles.size(); ++t)
        for (const std::uint32_t corner : shape.triangles[t])
            if (corner >= shape.vertices.size())
                report.add({MeshProblem::badIndex, "triangle " + std::to_string(t + 1),
                            "vertex " + std::to_string(corner + 1ULL),
                            "1 to " + std::to_string(shape.vertices.size())});
    if (shape.triangles.size() > TriangleMesh::kMostTriangles)
        report.add(
            tooMany("triangle " + std::to_string(TriangleMesh::kMostTriangles + 1), shape.triangles.size()));
    return finish({std::move(shape), {}}, std::move(report));
}

core::Result<MeshSource> storedMesh(const MeshShape& shape, std::string id) {
    const auto rounded = inMicrometres(shape);
    CHIRON_TRY(rounded);
    const auto whole = makeMeshShape(*rounded);
    CHIRON_TRY(whole);
    const MeshImport again = importMesh(*whole);
    for (const MeshFinding& finding : again.report.findings)
        if (!finding.repaired)
            return core::fail(core::ErrorCode::badInput, "mesh in whole micrometres: " + finding.place +
                                                             ": " + finding.found + ", expected " +
                                                             finding.expected);
    auto source = inMicrometres(again.shape);
    if (source)
        source->id = std::move(id);
    return source;
}

std::string writeObj(const MeshShape& shape, double metresPerUnit) {
    std::string out = "# Chiron\n";
    for (const core::Vec3& p : shape.vertices)
        appendPoint(out, "v", p, metresPerUnit);
    for (const auto& t : shape.triangles)
        out += "f " + std::to_string(t[0] + 1ULL) + " " + std::to_string(t[1] + 1ULL) + " " +
               std::to_string(t[2] + 1ULL) + "\n";
    return out;
}

std::string writeStl(const MeshShape& shape, double metresPerUnit) {
    std::string out = "solid chiron\n";
    for (const auto& t : shape.triangles) {
        appendPoint(out, "facet normal", normalOf(shape, t), 1.0);
        out += "outer loop\n";
        for (const std::uint32_t corner : t)
            appendPoint(out, "vertex", shape.vertices[corner], metresPerUnit);
        out += "endloop\nendfacet\n";
    }
    return out + "endsolid chiron\n";
}

std::string writeBinaryStl(const MeshShape& shape, double metresPerUnit) {
    std::string out(80, ' ');
    appendWhole(out, static_cast<std::uint32_t>(shape.triangles.size()));
    for (const auto& t : shape.triangles) {
        std::array<core::Vec3, 4> rows{normalOf(shape, t), shape.vertices[t[0]] / metresPerUnit,
                                       shape.vertices[t[1]] / metresPerUnit,
                                       shape.vertices[t[2]] / metresPerUnit};
        for (const core::Vec3& row : rows)
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                appendWhole(out, std::bit_cast<std::uint32_t>(static_cast<float>(row[axis])));
        out += std::string(2, '\0');
    }
    return out;
}

} // namespace chiron::simulation
