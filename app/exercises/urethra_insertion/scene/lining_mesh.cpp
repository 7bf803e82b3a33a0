// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/lining_mesh.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr int kBladderRows = 26;
constexpr int kSkirtRows = 9;
constexpr double kGlansRadius_m = 0.014; // radius of the rounded head; assumption, for the picture alone
constexpr double kGlansReach_m = 0.013;  // distance from the axis up to which it is drawn
constexpr double kLip_m = 0.0012;        // length over which the opening's edge is rounded

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

void addVertex(TriangleMesh& mesh, const core::Vec3& p, const core::Vec3& normal, double u, double v) {
    MeshVertex vertex;
    for (int k = 0; k < 3; ++k) {
        vertex.position_mm[k] = float(p[k] * 1e3);
        vertex.normal[k] = float(normal[k]);
    }
    vertex.texture[0] = float(u);
    vertex.texture[1] = float(v);
    mesh.vertices.push_back(vertex);
}

/// Joins rows of `columns` + 1 vertices, of which the last is a copy of the first; the front is on the side
/// of the normals.
void addRows(TriangleMesh& mesh, std::uint32_t rows, std::uint32_t columns) {
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = row * (columns + 1) + i;
            const std::uint32_t b = a + columns + 1;
            for (std::uint32_t index : {a, a + 1, b, a + 1, b + 1, b})
                mesh.indices.push_back(index);
        }
}

} // namespace

LiningMesh::LiningMesh(const UrethraDrawing& drawing, std::vector<core::Vec3> first,
                       std::vector<core::Vec3> last)
    : m_drawing(drawing), m_first(std::move(first)), m_last(std::move(last)),
      m_brim_rad(drawing.parameters().anatomy.bladderOpening_rad) {
    const simulation::CentrelinePoint neck = drawing.centreline().atZ(drawing.parameters().anatomy.zEnd_m);
    for (const core::Vec3& p : m_last) {
        const core::Vec3 from = p - neck.p_A;
        m_azimuths.push_back(std::atan2(from.dot(neck.n_A), from.x()));
    }
}

TriangleMesh LiningMesh::bladder() const {
    TriangleMesh mesh;
    const std::size_t columns = m_azimuths.size();
    for (int row = 0; row < kBladderRows; ++row) {
        const double polar = (core::kPi - m_brim_rad) * row / (kBladderRows - 1);
        for (std::size_t i = 0; i <= columns; ++i) {
            const double turn = azimuth(i);
            const core::Vec3 out = m_drawing.bladderDirection_A(polar, turn);
            addVertex(mesh, m_drawing.bladderWall_A(polar, turn), -out, double(i) / double(columns),
                      polar / core::kPi);
        }
    }
    addRows(mesh, kBladderRows, std::uint32_t(columns));
    return mesh;
}

LiningMesh::Place LiningMesh::neckAt(std::size_t column, double way,
                                     const std::vector<core::Vec3>& last) const {
    const std::size_t i = column % m_azimuths.size();
    const double radius = m_drawing.parameters().anatomy.bladderRadius_m;
    const double least = std::asin(std::min(0.9, m_drawing.parameters().anatomy.radius_m / radius));
    const double polar = core::kPi - (m_brim_rad + (least - m_brim_rad) * way);
    const core::Vec3 onSphere = m_drawing.bladderWall_A(polar, azimuth(i));
    const core::Vec3 edge = m_drawing.bladderWall_A(core::kPi - least, azimuth(i));
    Place place;
    place.p = onSphere + smooth(way) * (last[i] - edge);
    place.across = polar / core::kPi;
    return place;
}

TriangleMesh LiningMesh::neck(const std::vector<core::Vec3>& last) const {
    TriangleMesh mesh;
    const std::size_t columns = m_azimuths.size();
    const core::Vec3 axis = m_drawing.bladderDirection_A(0.0, 0.0);
    for (int row = 0; row < kSkirtRows; ++row) {
        const double way = double(row) / (kSkirtRows - 1);
        for (std::size_t i = 0; i <= columns; ++i) {
            const Place place = neckAt(i, way, last);
            const core::Vec3 inwards = -m_drawing.bladderDirection_A(core::kPi - m_brim_rad, azimuth(i));
            // The lip is shaded as rounded: towards the ring, the normal turns from the bladder's to the
            // canal's.
            core::Vec3 toAxis = -(place.p - m_drawing.bladderCentre_A());
            toAxis -= axis * axis.dot(toAxis);
            const double lip = smooth((way - 0.45) / 0.55);
            const core::Vec3 normal = ((1.0 - lip) * inwards + lip * toAxis.normalized()).normalized();
            addVertex(mesh, place.p, normal, double(i) / double(columns), place.across);
        }
    }
    addRows(mesh, kSkirtRows, std::uint32_t(columns));
    return mesh;
}

LiningMesh::Place LiningMesh::glansAt(std::size_t column, double way,
                                      const std::vector<core::Vec3>& first) const {
    const std::size_t i = column % m_first.size();
    const double rest = std::max(1e-6, m_first[i].head<2>().norm());
    const core::Vec3 out(m_first[i].x() / rest, m_first[i].y() / rest, 0.0);
    const double radius = rest + (kGlansReach_m - rest) * way * way; // denser rows at the lip
    const double lip = std::exp(-(radius - rest) / kLip_m);
    const double rounded =
        kGlansRadius_m - std::sqrt(std::max(0.0, kGlansRadius_m * kGlansRadius_m - radius * radius));
    const double slope = radius / std::sqrt(kGlansRadius_m * kGlansRadius_m - radius * radius);
    Place place;
    // A raised lip round the opening; the ring itself stays at the urethra's end.
    place.p = radius * out + core::Vec3(0.0, 0.0, (rounded - 1.6 * kLip_m * lip * (1.0 - lip)));
    place.p += (1.0 - smooth(way * 1.6)) * (first[i] - m_first[i]) +
               lip * core::Vec3(0.0, 0.0, m_first[i].z() - rest * rest / (2.0 * kGlansRadius_m));
    place.normal =
        (slope * out * (1.0 - lip) - core::Vec3::UnitZ() * (1.0 - 0.6 * lip) - lip * out).normalized();
    place.across = way;
    return place;
}

TriangleMesh LiningMesh::glans(const std::vector<core::Vec3>& first) const {
    TriangleMesh mesh;
    const std::size_t columns = m_first.size();
    for (int row = 0; row < kSkirtRows; ++row) {
        const double way = double(row) / (kSkirtRows - 1);
        for (std::size_t i = 0; i <= columns; ++i) {
            const Place place = glansAt(i, way, first);
            addVertex(mesh, place.p, place.normal, double(i) / double(columns), place.across);
        }
    }
    addRows(mesh, kSkirtRows, std::uint32_t(columns));
    return mesh;
}

} // namespace chiron::scene3d
