// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "simulation/geometry/mesh/make_mesh.h"
#include "simulation/geometry/mesh/mesh_bumps.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// One circle of vertices of the revolved outline. The vertices have consecutive numbers; every second circle
/// is rotated by half a step.
struct Ring {
    std::uint32_t first = 0;
    std::uint32_t count = 1; ///< 1: a single vertex on the axis
    double turn = 0.0;       ///< angle of its first vertex, in full turns
};

struct OutlinePoint {
    double rho = 0.0, z = 0.0;
    double normalRho = 0.0, normalZ = 1.0;
    double bumps = 0.0; ///< share of the bumps' height that is applied here
};

double smooth(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The outline from the apex down the dome, out over the plate, down its side and back to the axis below.
std::vector<OutlinePoint> outline(const MeshSource& s) {
    const double R = s.halfAxisX_m;
    const double fade2 = std::max(0.25 * R * R, 4.0 * R * s.bumpHeight_m);
    const double margin = std::min(s.bumpWavelength_m, 0.25 * R); // the bumps fade out within this distance
    std::vector<OutlinePoint> points;
    const auto steps = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length / s.edge_m)));
    };
    const int onDome = std::max(3, steps(0.5 * core::kPi * R));
    for (int i = 0; i <= onDome; ++i) {
        const double angle = 0.5 * core::kPi * i / onDome;
        const double rho = i == 0 ? 0.0 : R * std::sin(angle), z = i == onDome ? 0.0 : R * std::cos(angle);
        const double toPlate = R * (0.5 * core::kPi - angle);
        points.push_back({rho, z, std::sin(angle), std::cos(angle),
                          std::min(1.0, rho * rho / fade2) * smooth(toPlate / margin)});
    }
    const int onPlate = steps(s.plateRadius_m - R);
    for (int i = 1; i <= onPlate; ++i) {
        const double rho = R + (s.plateRadius_m - R) * i / onPlate;
        points.push_back(
            {rho, 0.0, 0.0, 1.0, smooth((rho - R) / margin) * smooth((s.plateRadius_m - rho) / margin)});
    }
    const int onSide = steps(s.plateThickness_m);
    for (int i = 1; i <= onSide; ++i)
        points.push_back({s.plateRadius_m, -s.plateThickness_m * i / onSide, 1.0, 0.0, 0.0});
    const int below = steps(s.plateRadius_m);
    for (int i = below - 1; i >= 0; --i)
        points.push_back({s.plateRadius_m * i / below, -s.plateThickness_m, 0.0, -1.0, 0.0});
    return points;
}

Ring addRing(const OutlinePoint& at, double edge, bool odd, const MeshBumps& bumps, MeshShape& shape) {
    Ring ring;
    ring.first = static_cast<std::uint32_t>(shape.vertices.size());
    if (at.rho > 0.0)
        ring.count = std::max(6U, static_cast<std::uint32_t>(std::lround(2.0 * core::kPi * at.rho / edge)));
    ring.turn = odd ? 0.5 / ring.count : 0.0;
    for (std::uint32_t i = 0; i < ring.count; ++i) {
        const double angle = 2.0 * core::kPi * (ring.turn + static_cast<double>(i) / ring.count);
        const core::Vec3 out(std::cos(angle), std::sin(angle), 0.0);
        const core::Vec3 base = at.rho * out + at.z * core::Vec3::UnitZ();
        const double height = at.bumps > 0.0 ? at.bumps * bumps.height_m(base) : 0.0;
        shape.vertices.push_back(base + height * (at.normalRho * out + at.normalZ * core::Vec3::UnitZ()));
    }
    return ring;
}

/// Fills the strip between two circles with triangles. In each step the circle whose next vertex comes first,
/// by angle, advances.
void stitch(const Ring& inner, const Ring& outer, MeshShape& shape) {
    const auto vertex = [](const Ring& ring, std::uint32_t i) { return ring.first + i % ring.count; };
    const auto angle = [](const Ring& ring, std::uint32_t i) {
        return ring.turn + static_cast<double>(i) / ring.count;
    };
    const std::uint32_t innerSteps = inner.count == 1 ? 0 : inner.count;
    const std::uint32_t outerSteps = outer.count == 1 ? 0 : outer.count;
    std::uint32_t i = 0, o = 0;
    while (i < innerSteps || o < outerSteps) {
        const bool goOuter =
            i == innerSteps || (o < outerSteps && angle(outer, o + 1) <= angle(inner, i + 1));
        if (goOuter) {
            shape.triangles.push_back({vertex(inner, i), vertex(outer, o), vertex(outer, o + 1)});
            ++o;
        } else {
            shape.triangles.push_back({vertex(inner, i), vertex(outer, o), vertex(inner, i + 1)});
            ++i;
        }
    }
}

} // namespace

MeshShape domeShape(const MeshSource& source) {
    const MeshBumps bumps(source.bumpHeight_m, source.bumpWavelength_m, source.seed);
    const std::vector<OutlinePoint> points = outline(source);
    MeshShape shape;
    Ring before = addRing(points.front(), source.edge_m, false, bumps, shape);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Ring ring = addRing(points[i], source.edge_m, i % 2 == 1, bumps, shape);
        stitch(before, ring, shape);
        before = ring;
    }
    return shape;
}

} // namespace chiron::simulation
