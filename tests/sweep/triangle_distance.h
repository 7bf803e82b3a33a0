// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/geometry/mesh/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

/// Distances from triangles without any of the product's searches: every triangle in turn.
namespace chiron::tests {

/// The point of a triangle nearest to p (Ericson, Real-Time Collision Detection, §5.1.5).
inline core::Vec3 nearestOnTriangle(const core::Vec3& a, const core::Vec3& b, const core::Vec3& c,
                                    const core::Vec3& p) {
    const core::Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0)
        return a;
    const core::Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3)
        return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
        return a + (d1 / (d1 - d3)) * ab;
    const core::Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6)
        return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
        return a + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
        return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
    return a + (vb / (va + vb + vc)) * ab + (vc / (va + vb + vc)) * ac;
}

/// Distance of p from a closed surface, negative within. `position` gives a vertex of it, which stays where
/// it is; no edge is longer than `longest_m`. Where edge or corner is nearest, the triangle that p faces most
/// squarely tells the side.
template <class Position>
double signedDistance_m(std::span<const simulation::SurfaceTriangle> triangles, Position&& position,
                        const core::Vec3& p, double longest_m) {
    constexpr double kTie_m = 1e-12;
    double nearest_m = std::numeric_limits<double>::infinity(), squarest = 0.0;
    for (const simulation::SurfaceTriangle& triangle : triangles) {
        const core::Vec3& a = position(triangle.vertex[0]);
        const double most_m = nearest_m + longest_m;
        if ((p - a).squaredNorm() > most_m * most_m)
            continue;
        const core::Vec3 &b = position(triangle.vertex[1]), &c = position(triangle.vertex[2]);
        const core::Vec3 away = p - nearestOnTriangle(a, b, c, p);
        const double distance_m = away.norm();
        if (distance_m > nearest_m + kTie_m)
            continue;
        const core::Vec3 normal = (b - a).cross(c - a).normalized();
        const double square = distance_m > 0.0 ? normal.dot(away) / distance_m : 1.0;
        if (distance_m < nearest_m - kTie_m || std::abs(square) > std::abs(squarest))
            squarest = square;
        nearest_m = std::min(nearest_m, distance_m);
    }
    return squarest < 0.0 ? -nearest_m : nearest_m;
}

} // namespace chiron::tests
