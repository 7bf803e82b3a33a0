// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/floor_shade.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kAboveFloor_mm = 0.12; // so that shadow and floor do not z-fight

} // namespace

double shadeOf(double above_m) {
    return 0.62 / (1.0 + 45.0 * std::max(0.0, above_m));
}

MeshVertex shadeVertex(const core::Vec2& p_m, double floor_m, double dark) {
    MeshVertex v;
    v.position_mm[0] = static_cast<float>(p_m.x() * 1e3);
    v.position_mm[1] = static_cast<float>(p_m.y() * 1e3);
    v.position_mm[2] = static_cast<float>(floor_m * 1e3 + kAboveFloor_mm);
    v.light = static_cast<float>(dark);
    return v;
}

void addShade(TriangleMesh& mesh, const core::Vec3& p_W, double radius_m, double floor_m) {
    constexpr int kSides = 28;
    const double above_m = p_W.z() - radius_m - floor_m;
    const double wide_m = 1.25 * radius_m + 0.10 * std::max(0.0, above_m);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(shadeVertex(p_W.head<2>(), floor_m, shadeOf(above_m)));
    for (int ring = 0; ring < 2; ++ring)
        for (int i = 0; i < kSides; ++i) {
            const double angle = 2.0 * core::kPi * i / kSides;
            const core::Vec2 out(std::cos(angle), std::sin(angle));
            mesh.vertices.push_back(shadeVertex(p_W.head<2>() + (ring == 0 ? 0.6 : 1.0) * wide_m * out,
                                                floor_m, ring == 0 ? 0.7 * shadeOf(above_m) : 0.0));
        }
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t next = (i + 1) % kSides;
        const std::uint32_t inner = first + 1;
        const std::uint32_t outer = inner + kSides;
        for (std::uint32_t index : {first, inner + i, inner + next, inner + i, outer + i, outer + next,
                                    inner + i, outer + next, inner + next})
            mesh.indices.push_back(index);
    }
}

} // namespace chiron::scene3d
