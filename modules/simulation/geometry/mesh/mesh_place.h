// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/geometry/mesh/triangle_mesh.h"

#include <cstddef>
#include <cstdint>

namespace chiron::simulation {

/// A place on a surface: a triangle and the weights of its corners (≥ 0, sum 1). Moves with the surface.
struct MeshPlace {
    std::uint32_t triangle = 0;
    core::Vec3 weights = core::Vec3::Constant(1.0 / 3.0);
};

template <class Surface> core::Vec3 pointAt(const Surface& surface, const MeshPlace& place) noexcept {
    const SurfaceTriangle& t = surface.triangle(place.triangle);
    return place.weights[0] * surface.position(t.vertex[0]) +
           place.weights[1] * surface.position(t.vertex[1]) +
           place.weights[2] * surface.position(t.vertex[2]);
}

/// The blend of the three vertex normals, normalised (P2 figure 6); it is continuous over the whole surface.
template <class Surface> core::Vec3 normalAt(const Surface& surface, const MeshPlace& place) noexcept {
    const SurfaceTriangle& t = surface.triangle(place.triangle);
    return (place.weights[0] * surface.normal(t.vertex[0]) + place.weights[1] * surface.normal(t.vertex[1]) +
            place.weights[2] * surface.normal(t.vertex[2]))
        .normalized();
}

/// Twice the area times the outward unit normal of the triangle itself.
template <class Surface> core::Vec3 facet(const Surface& surface, std::uint32_t triangle) noexcept {
    const SurfaceTriangle& t = surface.triangle(triangle);
    const core::Vec3& a = surface.position(t.vertex[0]);
    return (surface.position(t.vertex[1]) - a).cross(surface.position(t.vertex[2]) - a);
}

/// Weights of the triangle's point nearest to p. A weight is exactly 0 where that point lies on a side or in
/// a corner.
/// Source: Ericson, Real-Time Collision Detection (2005), §5.1.5.
inline core::Vec3 nearestWeights(const core::Vec3& a, const core::Vec3& b, const core::Vec3& c,
                                 const core::Vec3& p) noexcept {
    const core::Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
                 d6 = ac.dot(cp);
    if (d1 <= 0.0 && d2 <= 0.0)
        return {1.0, 0.0, 0.0};
    if (d3 >= 0.0 && d4 <= d3)
        return {0.0, 1.0, 0.0};
    if (d6 >= 0.0 && d5 <= d6)
        return {0.0, 0.0, 1.0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double v = d1 / (d1 - d3);
        return {1.0 - v, v, 0.0};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double w = d2 / (d2 - d6);
        return {1.0 - w, 0.0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - w, w};
    }
    const double inverse = 1.0 / (va + vb + vc);
    return {va * inverse, vb * inverse, vc * inverse};
}

/// Index of the corner of `triangle` that is `vertex`; 3 if none is.
inline std::size_t cornerOf(const SurfaceTriangle& triangle, std::uint32_t vertex) noexcept {
    for (std::size_t i = 0; i < 3; ++i)
        if (triangle.vertex[i] == vertex)
            return i;
    return 3;
}

/// Expresses a place on the side opposite to `corner` in the triangle across that side.
template <class Surface>
MeshPlace across(const Surface& surface, const MeshPlace& place, std::size_t corner) noexcept {
    const SurfaceTriangle& here = surface.triangle(place.triangle);
    MeshPlace there{here.neighbour[corner], core::Vec3::Zero()};
    const SurfaceTriangle& beyond = surface.triangle(there.triangle);
    for (std::size_t k = 1; k < 3; ++k) {
        const std::size_t mine = (corner + k) % 3;
        const std::size_t theirs = cornerOf(beyond, here.vertex[mine]);
        if (theirs < 3)
            there.weights[static_cast<Eigen::Index>(theirs)] = place.weights[static_cast<Eigen::Index>(mine)];
    }
    return there;
}

} // namespace chiron::simulation
