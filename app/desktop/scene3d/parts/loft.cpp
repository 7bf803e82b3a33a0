// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/loft.h"

#include "core/geometry.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

core::Vec3 vec(const Point_mm& p) {
    return {p[0], p[1], p[2]};
}

std::uint32_t addVertex(TriangleMesh& mesh, const Point_mm& p, const core::Vec3& normal, double steel) {
    MeshVertex v;
    for (int k = 0; k < 3; ++k) {
        v.position_mm[k] = static_cast<float>(p[static_cast<std::size_t>(k)]);
        v.normal[k] = static_cast<float>(normal[k]);
    }
    v.texture[0] = static_cast<float>(steel);
    mesh.vertices.push_back(v);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Normal at a point of the surface: perpendicular to its two tangent directions there.
core::Vec3 normalOf(const std::vector<Section>& sections, std::size_t row, std::size_t column) {
    const std::size_t sides = sections.front().size();
    const std::size_t below = row == 0 ? 0 : row - 1;
    const std::size_t above = std::min(row + 1, sections.size() - 1);
    core::Vec3 around =
        vec(sections[row][(column + 1) % sides]) - vec(sections[row][(column + sides - 1) % sides]);
    if (around.norm() < 1e-6) { // at a tip the outline is a single point, so the neighbouring outline is used
        const std::size_t other = row == 0 ? above : below;
        around =
            vec(sections[other][(column + 1) % sides]) - vec(sections[other][(column + sides - 1) % sides]);
    }
    const core::Vec3 up = vec(sections[above][column]) - vec(sections[below][column]);
    const core::Vec3 normal = around.cross(up);
    return normal.norm() > 1e-12 ? core::Vec3(normal.normalized()) : core::Vec3(core::Vec3::UnitZ());
}

void addLid(TriangleMesh& mesh, const Section& section, const core::Vec3& normal, double steel) {
    std::vector<std::uint32_t> rim;
    for (const Point_mm& p : section)
        rim.push_back(addVertex(mesh, p, normal, steel));
    for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
        const bool up = normal.z() > 0.0;
        for (std::uint32_t index : {rim[0], up ? rim[i] : rim[i + 1], up ? rim[i + 1] : rim[i]})
            mesh.indices.push_back(index);
    }
}

Section circle(double radius_mm, double z_mm, int sides) {
    Section section;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * core::kPi * i / sides;
        section.push_back({radius_mm * std::cos(angle), radius_mm * std::sin(angle), z_mm});
    }
    return section;
}

} // namespace

void addLoft(TriangleMesh& mesh, const std::vector<Section>& sections, double steel) {
    const auto sides = static_cast<std::uint32_t>(sections.front().size());
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t row = 0; row < sections.size(); ++row)
        for (std::size_t column = 0; column < sides; ++column)
            addVertex(mesh, sections[row][column], normalOf(sections, row, column), steel);
    for (std::uint32_t row = 0; row + 1 < sections.size(); ++row) {
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t a = first + row * sides + i;
            const std::uint32_t b = first + row * sides + (i + 1) % sides;
            for (std::uint32_t index : {a, b, b + sides, a, b + sides, a + sides})
                mesh.indices.push_back(index);
        }
    }
    addLid(mesh, sections.front(), -core::Vec3::UnitZ(), steel);
    addLid(mesh, sections.back(), core::Vec3::UnitZ(), steel);
}

void addTurned(TriangleMesh& mesh, const std::vector<std::array<double, 2>>& profile_mm, double steel,
               int sides) {
    std::vector<Section> sections;
    for (const auto& [z, radius] : profile_mm)
        sections.push_back(circle(radius, z, sides));
    addLoft(mesh, sections, steel);
}

TriangleMesh ringMesh(double radius_mm, double thickness_mm) {
    constexpr int kAround = 36;
    constexpr int kSides = 8;
    TriangleMesh mesh;
    for (int i = 0; i < kAround; ++i) {
        const double a = 2.0 * core::kPi * i / kAround;
        for (int k = 0; k < kSides; ++k) {
            const double b = 2.0 * core::kPi * k / kSides;
            const core::Vec3 normal(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
            const double away = radius_mm + thickness_mm * std::cos(b);
            addVertex(mesh, {away * std::cos(a), away * std::sin(a), thickness_mm * std::sin(b)}, normal,
                      0.0);
        }
    }
    for (std::uint32_t i = 0; i < kAround; ++i) {
        for (std::uint32_t k = 0; k < kSides; ++k) {
            const std::uint32_t j = (i + 1) % kAround;
            const std::uint32_t l = (k + 1) % kSides;
            for (std::uint32_t index : {i * kSides + k, j * kSides + k, j * kSides + l, i * kSides + k,
                                        j * kSides + l, i * kSides + l})
                mesh.indices.push_back(index);
        }
    }
    return mesh;
}

} // namespace chiron::scene3d
