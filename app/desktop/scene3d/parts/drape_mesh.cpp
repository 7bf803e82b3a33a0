// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/drape_mesh.h"

#include "core/geometry.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr int kSpokes = 144;
constexpr double kEdge_mm = 3.2; // thickness of the rolled edge
constexpr double kEnd_mm = 520.0;

/// A point of the cloth's profile without folds: distance from the opening, and height.
struct Outline {
    double away_mm;
    double height_mm;
    double light;
};

std::vector<Outline> outline() {
    std::vector<Outline> rows;
    for (int i = 0; i <= 8; ++i) { // the rolled edge, from below
        const double angle = core::kPi * i / 8;
        rows.push_back({kEdge_mm * (1.0 - std::cos(angle)), kEdge_mm * (0.1 + std::sin(angle)),
                        i < 2 ? 0.45 : (i > 6 ? 0.75 : 1.0)});
    }
    for (int i = 1; i <= 18; ++i) {
        const double t = i / 18.0;
        rows.push_back({2.0 * kEdge_mm + (kEnd_mm - 2.0 * kEdge_mm) * t * t, 0.4 - 26.0 * t,
                        0.75 + 0.25 * std::min(1.0, 8.0 * t)});
    }
    return rows;
}

/// Folds run outwards and grow with the distance.
double fold(double angle, double away_mm) {
    const double grown = std::clamp((away_mm - 8.0) / 90.0, 0.0, 1.0);
    return 4.6 * grown * grown *
           (std::sin(7.0 * angle + 0.011 * away_mm) + 0.6 * std::sin(13.0 * angle - 0.017 * away_mm + 1.7) +
            0.5 * std::sin(0.045 * away_mm + 3.0 * std::sin(2.0 * angle)));
}

core::Vec3 place(const Outline& row, double angle, double opening_mm) {
    const double away = opening_mm + row.away_mm;
    return {away * std::cos(angle), away * std::sin(angle), row.height_mm + fold(angle, row.away_mm)};
}

} // namespace

TriangleMesh drapeMesh(double opening_mm) {
    const std::vector<Outline> rows = outline();
    TriangleMesh mesh;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (int i = 0; i < kSpokes; ++i) {
            const double angle = 2.0 * core::kPi * i / kSpokes;
            const double step = 2.0 * core::kPi / kSpokes;
            const core::Vec3 p = place(rows[r], angle, opening_mm);
            const core::Vec3 around =
                place(rows[r], angle + step, opening_mm) - place(rows[r], angle - step, opening_mm);
            const core::Vec3 out = place(rows[std::min(r + 1, rows.size() - 1)], angle, opening_mm) -
                                   place(rows[r == 0 ? 0 : r - 1], angle, opening_mm);
            const core::Vec3 normal = out.cross(around).normalized();
            MeshVertex v;
            for (int k = 0; k < 3; ++k) {
                v.position_mm[k] = static_cast<float>(p[k]);
                v.normal[k] = static_cast<float>(normal[k]);
            }
            v.light = static_cast<float>(rows[r].light);
            mesh.vertices.push_back(v);
        }
    }
    for (std::uint32_t r = 0; r + 1 < rows.size(); ++r) {
        for (std::uint32_t i = 0; i < kSpokes; ++i) {
            const std::uint32_t a = r * kSpokes + i;
            const std::uint32_t b = r * kSpokes + (i + 1) % kSpokes;
            for (std::uint32_t index : {a, a + kSpokes, b + kSpokes, a, b + kSpokes, b})
                mesh.indices.push_back(index);
        }
    }
    return mesh;
}

} // namespace chiron::scene3d
