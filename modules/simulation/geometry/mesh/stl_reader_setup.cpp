// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_import.h"
#include "simulation/geometry/mesh/mesh_reading.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace chiron::simulation {

namespace {

constexpr std::size_t kHeader = 80, kBegin = 84, kFacet = 50; // bytes of a binary STL

std::uint32_t wholeAt(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i]))
                 << (8 * i); // little-endian by definition
    return value;
}

std::uint64_t expectedSize(std::string_view bytes) {
    return kBegin + kFacet * static_cast<std::uint64_t>(wholeAt(bytes, kHeader));
}

void push(ReadMesh& mesh, const std::array<core::Vec3, 3>& corners, std::uint32_t line) {
    const auto first = static_cast<std::uint32_t>(mesh.shape.vertices.size());
    mesh.shape.vertices.insert(mesh.shape.vertices.end(), corners.begin(), corners.end());
    mesh.shape.triangles.push_back({first, first + 1, first + 2});
    mesh.lines.push_back(line);
}

ReadMesh readBinary(std::string_view bytes, double scale, MeshReport& report) {
    ReadMesh mesh;
    const std::uint32_t count = wholeAt(bytes, kHeader);
    if (count > TriangleMesh::kMostTriangles) {
        report.add(tooMany("byte 80", count));
        return mesh;
    }
    if (bytes.size() < expectedSize(bytes)) {
        report.add(
            {MeshProblem::truncated, "byte " + std::to_string(bytes.size()),
             "the end of the file: cut off, or no STL",
             std::to_string(expectedSize(bytes)) + " bytes for " + std::to_string(count) + " triangles"});
        return mesh;
    }
    if (bytes.size() > expectedSize(bytes))
        report.add({MeshProblem::bytesBehindTheEnd, "byte " + std::to_string(expectedSize(bytes)),
                    std::to_string(bytes.size() - expectedSize(bytes)) + " bytes more, passed over",
                    "the end of the file", 1, true});
    for (std::uint32_t t = 0; t < count; ++t) {
        std::array<core::Vec3, 3> corners;
        for (std::size_t i = 0; i < 9; ++i) {
            const std::size_t at = kBegin + kFacet * t + 12 + 4 * i;
            const double value = scale * static_cast<double>(std::bit_cast<float>(wholeAt(bytes, at)));
            if (!std::isfinite(value)) {
                report.add({MeshProblem::badNumber,
                            "triangle " + std::to_string(t + 1) + " (byte " + std::to_string(at) + ")",
                            "not a finite number", "a finite number"});
                return mesh;
            }
            corners[i / 3][static_cast<Eigen::Index>(i % 3)] = value;
        }
        push(mesh, corners, 0);
    }
    return mesh;
}

bool truncated(const MeshLines& lines, const char* expected, MeshReport& report) {
    report.add({MeshProblem::truncated, lines.place(), "the end of the file", expected});
    return false;
}

/// The lines of one facet after "facet normal ...": outer loop, three vertices, endloop, endfacet.
bool readFacet(MeshLines& lines, double scale, ReadMesh& mesh, MeshReport& report) {
    const std::uint32_t begin = lines.number();
    std::array<core::Vec3, 3> corners;
    std::size_t count = 0;
    while (lines.next()) {
        const std::string_view tag = lines.word();
        if (tag.empty() || tag == "outer" || tag == "endloop")
            continue;
        if (tag == "endfacet") {
            if (count != 3) {
                report.add({MeshProblem::badLine, "line " + std::to_string(begin),
                            "a facet of " + std::to_string(count) + " vertices", "3"});
                return false;
            }
            if (mesh.shape.triangles.size() == TriangleMesh::kMostTriangles) {
                report.add(tooMany(lines.place(), TriangleMesh::kMostTriangles + 1));
                return false;
            }
            push(mesh, corners, begin);
            return true;
        }
        if (tag != "vertex") {
            report.add({MeshProblem::badLine, lines.place(), "\"" + std::string(tag.substr(0, 40)) + "\"",
                        "vertex or endfacet"});
            return false;
        }
        core::Vec3 p;
        if (!readPoint(lines, scale, p, report))
            return false;
        if (count < 3)
            corners[count] = p;
        ++count;
    }
    return truncated(lines, "endfacet", report);
}

ReadMesh readText(std::string_view bytes, double scale, MeshReport& report) {
    ReadMesh mesh;
    MeshLines lines(bytes);
    bool open = false;
    while (lines.next()) {
        const std::string_view tag = lines.word();
        if (tag == "solid") {
            open = true;
        } else if (tag == "endsolid") {
            open = false;
        } else if (tag == "facet") {
            if (!readFacet(lines, scale, mesh, report))
                return mesh;
        } else if (!tag.empty()) {
            report.add({MeshProblem::badLine, lines.place(), "\"" + std::string(tag.substr(0, 40)) + "\"",
                        "facet or endsolid"});
            return mesh;
        }
    }
    if (open)
        truncated(lines, "endsolid", report);
    return mesh;
}

} // namespace

ReadMesh readStl(std::string_view bytes, double metresPerUnit, MeshReport& report) {
    // Binary files may also begin with "solid". Text contains no zero bytes, and the number of triangles
    // always has one.
    static_assert(TriangleMesh::kMostTriangles < 1U << 24);
    const bool textual =
        bytes.substr(0, 5) == "solid" && bytes.substr(0, kBegin).find('\0') == std::string_view::npos;
    if (bytes.size() >= kBegin && !textual)
        return readBinary(bytes, metresPerUnit, report);
    if (textual)
        return readText(bytes, metresPerUnit, report);
    report.add({MeshProblem::truncated, "byte " + std::to_string(bytes.size()), "the end of the file",
                "84 bytes at least, or \"solid\""});
    return {};
}

std::optional<MeshFormat> guessMeshFormat(std::string_view bytes) noexcept {
    if (bytes.size() >= kBegin && bytes.size() == expectedSize(bytes))
        return MeshFormat::stl;
    MeshLines lines(bytes.substr(0, 65'536));
    for (int n = 0; n < 2'000 && lines.next(); ++n) {
        const std::string_view tag = lines.word();
        if (tag.empty() || tag.front() == '#')
            continue;
        if (tag == "solid" || tag == "facet")
            return MeshFormat::stl;
        if (tag == "v" || tag == "f" || tag == "o" || tag == "g" || tag == "mtllib" || tag == "vn" ||
            tag == "vt" || tag == "s" || tag == "usemtl") {
            if (tag == "v" || tag == "f")
                return MeshFormat::obj;
            continue;
        }
        break;
    }
    return std::nullopt;
}

} // namespace chiron::simulation
