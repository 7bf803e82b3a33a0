// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/instrument_mesh.h"

#include "core/units.h"
#include "desktop/scene3d/parts/loft.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {
constexpr double kShaftRadius_mm = 2.5;
constexpr double kShaftEnd_mm = 340.0; // beyond the picture
} // namespace

TriangleMesh instrumentBody() {
    TriangleMesh mesh;
    addTurned(
        mesh,
        {{kHinge_mm - 2.2, 0.9}, {kHinge_mm - 1.6, 1.7}, {kHinge_mm + 1.0, 2.15}, {kHinge_mm + 7.0, 2.2}},
        1.0);
    addTurned(
        mesh,
        {{kHinge_mm + 7.0, 2.2}, {kHinge_mm + 7.6, kShaftRadius_mm}, {kHinge_mm + 9.0, kShaftRadius_mm}},
        0.7);
    addTurned(mesh, {{kHinge_mm + 9.0, 2.35}, {60.0, 2.35}, {140.0, 2.35}, {kShaftEnd_mm, 2.35}}, 0.0);
    // The pin that holds the jaws, across y.
    TriangleMesh pin;
    addTurned(pin, {{-2.45, 0.9}, {2.45, 0.9}}, 0.85, 12);
    for (MeshVertex& v : pin.vertices) {
        v = {{v.position_mm[2], v.position_mm[0], v.position_mm[1] + static_cast<float>(kHinge_mm)},
             {v.normal[2], v.normal[0], v.normal[1]},
             {v.texture[0], v.texture[1]},
             v.light};
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), pin.vertices.begin(), pin.vertices.end());
    for (std::uint32_t index : pin.indices)
        mesh.indices.push_back(first + index);
    return mesh;
}

TriangleMesh instrumentJaw() {
    constexpr int kRows = 14;
    constexpr int kArc = 10;
    std::vector<Section> sections;
    for (int row = 0; row <= kRows; ++row) {
        const double t = static_cast<double>(row) / kRows;
        // Rows lie close together where the tip is round.
        const double z = kHinge_mm * t * t * (1.6 - 0.6 * t);
        const double blunt = std::sqrt(std::min(1.0, z / 1.8) * (2.0 - std::min(1.0, z / 1.8)));
        const double wide = blunt * (1.15 + 0.75 * t);
        const double thick = blunt * (0.95 + 0.75 * t);
        const double bite = row > 2 && row < kRows - 2 ? 0.12 + 0.10 * (row % 2) : 0.08; // the teeth
        Section section;
        for (int i = 0; i <= kArc; ++i) {
            const double angle = core::kPi * i / kArc;
            section.push_back({wide * std::cos(angle), std::max(bite * blunt, thick * std::sin(angle)), z});
        }
        sections.push_back(section);
    }
    TriangleMesh mesh;
    addLoft(mesh, sections, 1.0);
    return mesh;
}

TriangleMesh instrumentRings(int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const double z = kHinge_mm + 12.0 + 6.5 * i;
        addTurned(mesh, {{z, 2.40}, {z + 0.3, 2.75}, {z + 3.7, 2.75}, {z + 4.0, 2.40}}, 0.0, 24);
    }
    return mesh;
}

TriangleMesh instrumentCollar() {
    TriangleMesh mesh = ringMesh(5.4, 0.75);
    for (MeshVertex& v : mesh.vertices)
        v.position_mm[2] += static_cast<float>(kHinge_mm + 5.0);
    return mesh;
}

} // namespace chiron::scene3d
