// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_reading.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace chiron::simulation {

bool MeshLines::next() noexcept {
    if (m_rest.empty())
        return false;
    const std::size_t end = m_rest.find('\n');
    m_line = m_rest.substr(0, end);
    m_rest = end == std::string_view::npos ? std::string_view{} : m_rest.substr(end + 1);
    ++m_number;
    return true;
}

std::string_view MeshLines::word() noexcept {
    constexpr std::string_view kSpace = " \t\r\f\v";
    const std::size_t begin = m_line.find_first_not_of(kSpace);
    if (begin == std::string_view::npos)
        return {};
    const std::size_t end = std::min(m_line.find_first_of(kSpace, begin), m_line.size());
    const std::string_view word = m_line.substr(begin, end - begin);
    m_line.remove_prefix(end);
    return word;
}

bool readPoint(MeshLines& lines, double scale, core::Vec3& out, MeshReport& report) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::string_view word = lines.word();
        if (!word.empty() && word.front() == '+')
            word.remove_prefix(1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || error != std::errc{} || end != word.data() + word.size() ||
            !std::isfinite(value) || !std::isfinite(value * scale)) {
            report.add({MeshProblem::badNumber, lines.place(),
                        word.empty() ? std::string("a missing coordinate")
                                     : "\"" + std::string(word.substr(0, 40)) + "\"",
                        "a finite number"});
            return false;
        }
        out[axis] = value * scale;
    }
    return true;
}

MeshFinding tooMany(const std::string& place, std::size_t found) {
    return {MeshProblem::tooManyTriangles, place, std::to_string(found) + " triangles or more",
            "at most " + std::to_string(TriangleMesh::kMostTriangles)};
}

bool addTriangle(ReadMesh& mesh, const std::array<std::uint32_t, 3>& corners, std::uint32_t line,
                 MeshReport& report) {
    if (mesh.shape.triangles.size() == TriangleMesh::kMostTriangles) {
        report.add(tooMany("line " + std::to_string(line), TriangleMesh::kMostTriangles + 1));
        return false;
    }
    mesh.shape.triangles.push_back(corners);
    mesh.lines.push_back(line);
    return true;
}

std::string trianglePlace(const ReadMesh& mesh, std::size_t triangle) {
    std::string place = "triangle " + std::to_string(triangle + 1);
    if (triangle < mesh.lines.size() && mesh.lines[triangle] > 0)
        place += " (line " + std::to_string(mesh.lines[triangle]) + ")";
    return place;
}

std::string edgePlace(const ReadMesh& mesh, std::uint64_t key) {
    const auto low = static_cast<std::size_t>(key >> 32U), high = static_cast<std::size_t>(key & 0xffffffffU);
    const core::Vec3 middle = 500.0 * (mesh.shape.vertices[low] + mesh.shape.vertices[high]); // mm
    char text[120];
    std::snprintf(text, sizeof text, "edge %zu-%zu at (%.2f, %.2f, %.2f) mm", low + 1, high + 1, middle.x(),
                  middle.y(), middle.z());
    return text;
}

} // namespace chiron::simulation
