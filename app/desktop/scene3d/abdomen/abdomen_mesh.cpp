// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/abdomen/abdomen_mesh.h"

#include "core/geometry.h"
#include "core/units.h"
#include "desktop/scene3d/parts/sweep.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kFlatBeyond_mm = 8.0; // beyond the workspace
constexpr double kEnd_mm = 340.0;
constexpr int kSpokes = 108;
constexpr int kInnerRings = 26; // over the flat part, which the tips dent
constexpr int kOuterRings = 22;

double floorHeight_mm(double flat_mm, double angle, double r_mm) {
    const double out = std::max(0.0, r_mm - flat_mm);
    const double grown = std::min(1.0, out / 70.0);
    const double fold = 3.4 * std::sin(3.0 * angle + 0.045 * r_mm) +
                        2.2 * std::sin(7.0 * angle - 0.06 * r_mm + 1.3) +
                        1.4 * std::sin(12.0 * angle + 0.09 * r_mm + 0.4);
    return 0.0022 * out * out * std::min(1.0, 160.0 / (out + 1.0)) + grown * grown * fold;
}

core::Vec3 floorPoint(double flat_mm, double angle, double r_mm) {
    return {r_mm * std::cos(angle), r_mm * std::sin(angle), floorHeight_mm(flat_mm, angle, r_mm)};
}

double ringRadius_mm(double flat_mm, int ring) {
    if (ring <= kInnerRings)
        return flat_mm * ring / kInnerRings;
    const double t = static_cast<double>(ring - kInnerRings) / kOuterRings;
    return flat_mm + (kEnd_mm - flat_mm) * (0.4 * t + 0.6 * t * t);
}

/// Adds a loop of bowel along an arc round the field, pinched every 22 mm.
void addLoop(TriangleMesh& mesh, double flat_mm, double away_mm, double thick_mm, double from_deg,
             double to_deg, double phase) {
    constexpr int kRings = 64;
    std::vector<SweepRing> rings;
    double way_mm = 0.0;
    for (int i = 0; i <= kRings; ++i) {
        const double t = static_cast<double>(i) / kRings;
        const double angle = (from_deg + (to_deg - from_deg) * t) * core::kPi / 180.0;
        const double r = flat_mm + away_mm + 7.0 * std::sin(6.0 * angle + phase) +
                         4.0 * std::sin(11.0 * angle + 2.0 * phase);
        core::Vec3 p = floorPoint(flat_mm, angle, r);
        p.z() += 0.55 * thick_mm + 2.5 * std::sin(5.0 * angle + 1.7 * phase);
        if (!rings.empty())
            way_mm += (p - rings.back().p_mm).norm();
        const double pinch = std::pow(std::abs(std::sin(core::kPi * way_mm / 22.0 + phase)), 0.7);
        const double ends = std::sqrt(std::min(1.0, 6.0 * std::min(t, 1.0 - t)));
        rings.push_back({p, thick_mm * (0.88 + 0.12 * pinch) * (0.55 + 0.45 * ends), 0.80 + 0.2 * pinch});
    }
    addSweep(mesh, rings, SweepEnd::round, SweepEnd::round, 20);
}

} // namespace

TriangleMesh peritoneumMesh(double workspace_mm) {
    const double flat_mm = workspace_mm + kFlatBeyond_mm;
    TriangleMesh mesh;
    constexpr int kRings = kInnerRings + kOuterRings;
    for (int ring = 0; ring <= kRings; ++ring)
        for (int i = 0; i < kSpokes; ++i) {
            const double r = ringRadius_mm(flat_mm, ring);
            const double angle = 2.0 * core::kPi * i / kSpokes;
            const core::Vec3 p = floorPoint(flat_mm, angle, r);
            const core::Vec3 out =
                floorPoint(flat_mm, angle, r + 1.0) - floorPoint(flat_mm, angle, std::max(0.01, r - 1.0));
            const core::Vec3 round = floorPoint(flat_mm, angle + 0.01, std::max(0.1, r)) -
                                     floorPoint(flat_mm, angle - 0.01, std::max(0.1, r));
            const core::Vec3 n =
                r <= flat_mm ? core::Vec3(core::Vec3::UnitZ()) : core::Vec3(out.cross(round).normalized());
            MeshVertex v;
            for (int k = 0; k < 3; ++k) {
                v.position_mm[k] = static_cast<float>(p[k]);
                v.normal[k] = static_cast<float>(n[k]);
            }
            v.texture[0] = v.position_mm[0];
            v.texture[1] = v.position_mm[1];
            const double beyond = std::clamp((r - flat_mm) / 190.0, 0.0, 1.0);
            v.light =
                static_cast<float>(1.0 - 0.62 * beyond * (2.0 - beyond)); // the lamp is at the laparoscope
            mesh.vertices.push_back(v);
        }
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t i = 0; i < kSpokes; ++i) {
            const std::uint32_t a = ring * kSpokes + i;
            const std::uint32_t b = ring * kSpokes + (i + 1) % kSpokes;
            for (std::uint32_t index : {a, a + kSpokes, b + kSpokes, a, b + kSpokes, b})
                mesh.indices.push_back(index);
        }
    return mesh;
}

TriangleMesh bowelMesh(double workspace_mm) {
    const double flat_mm = workspace_mm + kFlatBeyond_mm;
    TriangleMesh mesh;
    addLoop(mesh, flat_mm, 20.0, 11.5, 4.0, 58.0, 0.3);
    addLoop(mesh, flat_mm, 46.0, 13.5, 8.0, 66.0, 1.9);
    addLoop(mesh, flat_mm, 22.0, 12.0, 122.0, 176.0, 4.0);
    addLoop(mesh, flat_mm, 49.0, 13.0, 112.0, 172.0, 0.9);
    addLoop(mesh, flat_mm, 79.0, 14.5, 2.0, 178.0, 2.4);
    return mesh;
}

TriangleMesh fatMesh(double workspace_mm) {
    const double flat_mm = workspace_mm + kFlatBeyond_mm;
    TriangleMesh mesh;
    std::uint32_t seed = 7;
    for (const double side : {1.0, -1.0})
        for (int i = 0; i < 16; ++i)
            for (int row = 0; row < 3; ++row) {
                const double angle = -0.5 * core::kPi + side * (0.50 + 0.078 * i + 0.03 * row);
                const double r = flat_mm + 9.0 + 8.5 * row + 3.0 * std::sin(2.7 * i + 1.3 * row + side);
                const core::Vec3 p = floorPoint(flat_mm, angle, r);
                const double size = 6.2 + 1.4 * row + 1.5 * std::sin(1.9 * i + 2.3 * row + 2.0 * side);
                addLobe(mesh, p - core::Vec3(0.0, 0.0, 0.30 * size), {1.2 * size, 1.1 * size, 0.72 * size},
                        0.10, seed++, 7);
            }
    return mesh;
}

TriangleMesh uterusMesh(double workspace_mm) {
    TriangleMesh mesh;
    const double y = workspace_mm + kFlatBeyond_mm + 36.0;
    addLobe(mesh, {2.0, y, 4.0}, {33.0, 25.0, 25.0}, 0.03, 5, 26);
    // The round ligaments run from its corners to the sides.
    for (const double side : {1.0, -1.0}) {
        std::vector<SweepRing> rings;
        for (int i = 0; i <= 24; ++i) {
            const double t = i / 24.0;
            rings.push_back({{2.0 + side * (22.0 + 62.0 * t), y - 6.0 - 14.0 * t * t,
                              17.0 - 8.0 * std::sin(2.4 * t) - 6.0 * t},
                             4.4 - 1.4 * t,
                             0.9});
        }
        addSweep(mesh, rings, SweepEnd::round, SweepEnd::round, 12);
    }
    return mesh;
}

} // namespace chiron::scene3d
