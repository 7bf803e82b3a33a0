// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/make_mesh.h"
#include "simulation/geometry/mesh/mesh_bumps.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::simulation {

namespace {

using Corners = std::array<std::uint32_t, 3>;

// atan 2: the angle that an edge subtends at the centre
constexpr double kIcosahedronEdge_rad = 1.1071487177940904;

struct Icosahedron {
    std::array<core::Vec3, 12> vertices;
    std::array<Corners, 20> faces;
};

Icosahedron icosahedron() {
    const double g = 0.5 * (1.0 + std::sqrt(5.0)), n = 1.0 / std::sqrt(1.0 + g * g), a = n, b = g * n;
    return {{{{-a, b, 0},
              {a, b, 0},
              {-a, -b, 0},
              {a, -b, 0},
              {0, -a, b},
              {0, a, b},
              {0, -a, -b},
              {0, a, -b},
              {b, 0, -a},
              {b, 0, a},
              {-b, 0, -a},
              {-b, 0, a}}},
            {{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}}};
}

/// Divides every side of an icosahedron into n parts and puts the vertices on the unit sphere.
class CutIcosahedron {
public:
    explicit CutIcosahedron(std::uint32_t n) : m_n(n), m_base(icosahedron()) {
        m_shape.vertices.assign(m_base.vertices.begin(), m_base.vertices.end());
        for (const Corners& face : m_base.faces)
            cut(face);
    }
    MeshShape take() { return std::move(m_shape); }

private:
    /// Vertex i of 0..n from corner a to corner b. It is made once for the two faces that share the side.
    std::uint32_t onSide(std::uint32_t a, std::uint32_t b, std::uint32_t i) {
        if (i == 0 || i == m_n)
            return i == 0 ? a : b;
        if (a > b)
            return onSide(b, a, m_n - i);
        auto [first, made] = m_sides.try_emplace({a, b}, static_cast<std::uint32_t>(m_shape.vertices.size()));
        if (made)
            for (std::uint32_t k = 1; k < m_n; ++k)
                add(((m_n - k) * m_base.vertices[a] + k * m_base.vertices[b]) / m_n);
        return first->second + i - 1;
    }
    void add(const core::Vec3& p) { m_shape.vertices.push_back(p.normalized()); }

    void cut(const Corners& face) {
        std::vector<std::uint32_t> above, row;
        for (std::uint32_t r = 0; r <= m_n; ++r) {
            row.clear();
            const core::Vec3 left =
                ((m_n - r) * m_base.vertices[face[0]] + r * m_base.vertices[face[1]]) / m_n;
            const core::Vec3 right =
                ((m_n - r) * m_base.vertices[face[0]] + r * m_base.vertices[face[2]]) / m_n;
            for (std::uint32_t c = 0; c <= r; ++c)
                row.push_back(place(face, left, right, r, c));
            for (std::uint32_t c = 0; c < r; ++c) {
                m_shape.triangles.push_back({above[c], row[c], row[c + 1]});
                if (c + 1 < r)
                    m_shape.triangles.push_back({above[c], row[c + 1], above[c + 1]});
            }
            above = row;
        }
    }
    std::uint32_t place(const Corners& face, const core::Vec3& left, const core::Vec3& right, std::uint32_t r,
                        std::uint32_t c) {
        if (c == 0)
            return onSide(face[0], face[1], r);
        if (c == r)
            return onSide(face[0], face[2], r);
        if (r == m_n)
            return onSide(face[1], face[2], c);
        add(left + (right - left) * (static_cast<double>(c) / r));
        return static_cast<std::uint32_t>(m_shape.vertices.size() - 1);
    }

    std::uint32_t m_n;
    Icosahedron m_base;
    MeshShape m_shape;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_sides;
};

} // namespace

MeshShape ellipsoidShape(const MeshSource& source) {
    const core::Vec3 axes(source.halfAxisX_m, source.halfAxisY_m, source.halfAxisZ_m);
    const auto cuts = static_cast<std::uint32_t>(
        std::max(1L, std::lround(kIcosahedronEdge_rad * axes.mean() / source.edge_m)));
    const MeshBumps bumps(source.bumpHeight_m, source.bumpWavelength_m, source.seed);
    MeshShape shape = CutIcosahedron(cuts).take();
    for (core::Vec3& vertex : shape.vertices) {
        const core::Vec3 base = vertex.cwiseProduct(axes);
        vertex = base + bumps.height_m(base) * vertex.cwiseQuotient(axes).normalized();
    }
    return shape;
}

} // namespace chiron::simulation
