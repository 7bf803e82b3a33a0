// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_reading.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

namespace chiron::simulation {

namespace {

/// The statements of OBJ files other than vertices and faces; they are skipped.
constexpr std::array<std::string_view, 26> kPassedOver{
    "vn",     "vt",     "vp",    "o",        "g",        "s",    "usemtl",     "mtllib",    "l",
    "p",      "mg",     "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "usemap",
    "maplib", "cstype", "deg",   "bmat",     "step",     "parm", "end",        "call"};

class ObjReader {
public:
    ObjReader(std::string_view bytes, double scale, MeshReport& report)
        : m_lines(bytes), m_scale(scale), m_report(report) {}

    ReadMesh read() {
        while (m_lines.next())
            if (!line())
                return std::move(m_mesh);
        for (std::size_t t = 0; t < m_mesh.shape.triangles.size(); ++t)
            for (const std::uint32_t corner : m_mesh.shape.triangles[t])
                if (corner >= m_mesh.shape.vertices.size()) {
                    m_report.add({MeshProblem::badIndex, trianglePlace(m_mesh, t),
                                  "vertex " + std::to_string(corner + 1ULL),
                                  "1 to " + std::to_string(m_mesh.shape.vertices.size())});
                    return std::move(m_mesh);
                }
        return std::move(m_mesh);
    }

private:
    bool line() {
        const std::string_view tag = m_lines.word();
        if (tag.empty() || tag.front() == '#')
            return true;
        if (tag == "v")
            return vertex();
        if (tag == "f")
            return face();
        if (std::find(kPassedOver.begin(), kPassedOver.end(), tag) != kPassedOver.end())
            return true;
        m_report.add({MeshProblem::badLine, m_lines.place(), "\"" + std::string(tag.substr(0, 40)) + "\"",
                      "an OBJ statement (v, f, vn, ...)"});
        return false;
    }

    bool vertex() {
        core::Vec3 p;
        if (!readPoint(m_lines, m_scale, p, m_report))
            return false;
        if (m_mesh.shape.vertices.size() == 3 * TriangleMesh::kMostTriangles) {
            m_report.add(tooMany(m_lines.place(), TriangleMesh::kMostTriangles + 1));
            return false;
        }
        m_mesh.shape.vertices.push_back(p);
        return true;
    }

    /// Reads "7", "7/2", "7//3" or "-1": the first number is the vertex, counted from 1, or backwards from
    /// the last one.
    bool corner(std::string_view word, std::uint32_t& out) {
        const std::string_view digits = word.substr(0, word.find('/'));
        long long index = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        const auto count = static_cast<long long>(m_mesh.shape.vertices.size());
        const long long at = index < 0 ? count + index : index - 1;
        if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size() || index == 0 ||
            at < 0 || at >= 0x7fffffffLL) {
            m_report.add({MeshProblem::badIndex, m_lines.place(),
                          "\"" + std::string(word.substr(0, 40)) + "\"", "the number of a vertex"});
            return false;
        }
        out = static_cast<std::uint32_t>(at);
        return true;
    }

    bool face() {
        std::array<std::uint32_t, 3> corners{};
        std::size_t count = 0;
        for (std::string_view word = m_lines.word(); !word.empty() && word.front() != '#';
             word = m_lines.word()) {
            std::uint32_t at = 0;
            if (!corner(word, at))
                return false;
            if (count >= 3)
                corners[1] = corners[2];
            corners[std::min<std::size_t>(count, 2)] = at;
            ++count;
            if (count >= 3 && !addTriangle(m_mesh, corners, m_lines.number(), m_report))
                return false;
        }
        if (count < 3) {
            m_report.add({MeshProblem::badLine, m_lines.place(),
                          "a face of " + std::to_string(count) + " corners", "three or more"});
            return false;
        }
        if (count > 3)
            m_report.add({MeshProblem::polygons, m_lines.place(),
                          "a face of " + std::to_string(count) + " corners, cut into triangles", "triangles",
                          1, true});
        return true;
    }

    MeshLines m_lines;
    double m_scale;
    MeshReport& m_report;
    ReadMesh m_mesh;
};

} // namespace

ReadMesh readObj(std::string_view bytes, double metresPerUnit, MeshReport& report) {
    return ObjReader(bytes, metresPerUnit, report).read();
}

} // namespace chiron::simulation
