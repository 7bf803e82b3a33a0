// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/tissue_mesh.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kStep_m = 0.0016;
constexpr double kLift_m = 0.00025;        // lift of a ribbon, so that no half of it lies below the surface
constexpr double kReachPerPad = 1.9;       // radius of a dent, relative to that of the pad
constexpr double kShadePerCurve_m = 0.003; // darkening of a hollow per curvature
constexpr std::uint32_t kNone = 0xffffffffU;

MeshVertex vertexOn(const simulation::TissueSurface& surface, const core::Vec2& xy_m, double lift_m) {
    const simulation::SurfaceHeight at = surface.heightAt(xy_m);
    const core::Vec3 normal = core::Vec3(-at.slope.x(), -at.slope.y(), 1.0).normalized();
    const core::Vec3 p_mm = 1e3 * (core::Vec3(xy_m.x(), xy_m.y(), at.z_m) + lift_m * normal);
    MeshVertex v;
    for (int k = 0; k < 3; ++k) {
        v.position_mm[k] = static_cast<float>(p_mm[k]);
        v.normal[k] = static_cast<float>(normal[k]);
    }
    v.texture[0] = v.position_mm[0];
    v.texture[1] = v.position_mm[1];
    v.light = static_cast<float>(
        std::clamp(1.0 - kShadePerCurve_m * std::max(0.0, at.curvature_per_m.trace()), 0.6, 1.0));
    return v;
}

} // namespace

TriangleMesh tissueMesh(const simulation::TissueSurface& surface, double reach_m) {
    TriangleMesh mesh;
    const int half = std::max(1, static_cast<int>(std::ceil(reach_m / kStep_m)));
    const int side = 2 * half + 1;
    std::vector<std::uint32_t> number(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), kNone);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const core::Vec2 xy(kStep_m * (i - half), kStep_m * (j - half));
            if (xy.norm() > reach_m + kStep_m)
                continue;
            number[static_cast<std::size_t>(j * side + i)] = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(vertexOn(surface, xy, 0.0));
        }
    for (int j = 0; j + 1 < side; ++j)
        for (int i = 0; i + 1 < side; ++i) {
            const auto at = [&](int right, int up) {
                return number[static_cast<std::size_t>((j + up) * side + i + right)];
            };
            const std::array<std::uint32_t, 4> corner{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
            if (std::find(corner.begin(), corner.end(), kNone) != corner.end())
                continue;
            for (const std::size_t k : {0U, 1U, 2U, 0U, 2U, 3U})
                mesh.indices.push_back(corner[k]);
        }
    return mesh;
}

TriangleMesh areaMesh(const simulation::TissueSurface& surface, const core::Vec2& half_m, double wide_mm) {
    TriangleMesh mesh;
    const core::Vec2 out = core::Vec2::Constant(0.5e-3 * wide_mm);
    const std::array<core::Vec2, 5> corner{core::Vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    for (std::size_t side = 0; side < 4; ++side) {
        const core::Vec2 way = (corner[side + 1] - corner[side]).cwiseProduct(half_m);
        const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / kStep_m)));
        for (int i = 0; i <= steps; ++i) {
            const double t = 2.0 * i / steps - 1.0;
            const core::Vec2 unit =
                0.5 * (corner[side] + corner[side + 1]) + 0.5 * t * (corner[side + 1] - corner[side]);
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(vertexOn(surface, unit.cwiseProduct(half_m + out), kLift_m));
            mesh.vertices.push_back(vertexOn(surface, unit.cwiseProduct(half_m - out), kLift_m));
            // Counter-clockwise as seen from above: the outer edge is to the right of the direction of
            // travel.
            if (i > 0)
                for (const std::uint32_t index :
                     {first - 2, first, first + 1, first - 2, first + 1, first - 1})
                    mesh.indices.push_back(index);
        }
    }
    for (MeshVertex& v : mesh.vertices)
        v.light = 1.0F;
    return mesh;
}

Dent fingerDent(const simulation::TissueSurface& surface, double padRadius_m, const ToolView& tool) {
    Dent dent;
    if (!tool.present || tool.drawnAtSurface || !tool.p_WT.allFinite())
        return dent;
    const simulation::SurfaceFoot foot = surface.nearest(tool.p_WT, tool.p_WT.head<2>());
    if (!(foot.depth_m > 0.0))
        return dent;
    dent.p_WSurface = foot.p_W;
    dent.normal = foot.normal;
    dent.depth_m = foot.depth_m;
    dent.reach_m = kReachPerPad * padRadius_m + Dent::kReachPerDepth * foot.depth_m;
    return dent;
}

double rimHeight_m(const simulation::TissueSurface& surface, double radius_m) {
    double highest_m = -1.0;
    for (int i = 0; i < 72; ++i) {
        const double angle = 2.0 * core::kPi * i / 72;
        highest_m = std::max(highest_m,
                             surface.heightAt(radius_m * core::Vec2(std::cos(angle), std::sin(angle))).z_m);
    }
    return highest_m;
}

} // namespace chiron::scene3d
