// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/mesh_place.h"

#include <cmath>
#include <utility>

namespace chiron::simulation {

/// Limits for how a place follows a point: along the field of blended normals where that is unique, otherwise
/// by gliding over the surface.
struct MeshWalk {
    static constexpr int kMostSteps = 64;       ///< triangles or Newton steps per tick; 2–3 are usual
    static constexpr int kMostRound = 32;       ///< triangles around a vertex that are searched
    static constexpr double kResidual_m = 1e-8; ///< 5 µN at 500 N/m
    /// The surface, moved inwards along its normals, may shrink to this share of its area. Beyond that the
    /// normals are about to cross (a ridge is pressed deeper than its radius), and the point alone no longer
    /// decides which of them applies.
    static constexpr double kLeastShrink = 0.08;
};

namespace detail {

/// Returns the share of a change of weights that stays in the triangle, and the corner opposite to the side
/// through which the change leaves it (-1: it stays).
inline std::pair<double, int> within(const core::Vec3& weights, const core::Vec3& change) noexcept {
    std::pair<double, int> out{1.0, -1};
    for (int i = 0; i < 3; ++i)
        if (weights[i] + change[i] < 0.0 && weights[i] + out.first * change[i] < 0.0)
            out = {weights[i] / -change[i], i};
    return out;
}

} // namespace detail

/// Finds the place x whose blended normal points to p: p = x − t n̂(x), where n̂ is the blend of the vertex
/// normals, not normalised. In a triangle with corners a + u e₁ + v e₂ this is F(u,v,t) = p, solved by
/// Newton's method (F is bilinear in (u,v) and t, so the residual after a step is exactly δt (δu Δn₁ + δv
/// Δn₂)). A step that leaves the triangle stops at its side and continues in the neighbour. Position and
/// normal agree there, so the place is a continuous function of p as long as the field does not fold. `place`
/// and `along` (t, m; > 0 inside) hold the start and receive the result. Returns false and leaves `place`
/// unchanged if the field is folded, or if no solution was found in kMostSteps. The idea: Phong projection
/// (Panozzo et al. 2013); P2 figure 6 gives the field.
template <class Surface>
bool projectAlongNormals(const Surface& surface, const core::Vec3& p, MeshPlace& place,
                         double& along) noexcept {
    MeshPlace now = place;
    double t = along;
    for (int step = 0; step < MeshWalk::kMostSteps; ++step) {
        const SurfaceTriangle& triangle = surface.triangle(now.triangle);
        const core::Vec3 &a = surface.position(triangle.vertex[0]), &na = surface.normal(triangle.vertex[0]);
        const core::Vec3 e1 = surface.position(triangle.vertex[1]) - a,
                         e2 = surface.position(triangle.vertex[2]) - a;
        const core::Vec3 d1 = surface.normal(triangle.vertex[1]) - na,
                         d2 = surface.normal(triangle.vertex[2]) - na;
        const double u = now.weights[1], v = now.weights[2];
        const core::Vec3 n = na + u * d1 + v * d2;
        const core::Vec3 r = (p - a) - (u * e1 + v * e2) + t * n;
        const core::Vec3 m1 = e1 - t * d1, m2 = e2 - t * d2, area = m1.cross(m2);
        const double volume = area.dot(n);
        // Checked in every step, because another sheet lies beyond a fold
        if (!(volume > MeshWalk::kLeastShrink * e1.cross(e2).dot(n)))
            return false;
        const double inverse = 1.0 / volume;
        const double du = inverse * r.dot(m2.cross(n)), dv = inverse * r.dot(n.cross(m1)),
                     dt = -inverse * r.dot(area);
        const core::Vec3 change(-du - dv, du, dv);
        const auto [share, leaves] = detail::within(now.weights, change);
        now.weights = (now.weights + share * change).cwiseMax(0.0);
        t += share * dt;
        if (leaves < 0) {
            if ((dt * (du * d1 + dv * d2)).squaredNorm() < MeshWalk::kResidual_m * MeshWalk::kResidual_m) {
                place = now;
                along = t;
                return true;
            }
            continue;
        }
        now.weights[leaves] = 0.0;
        now = across(surface, now, static_cast<std::size_t>(leaves));
    }
    return false;
}

namespace detail {

template <class Surface>
double nearestIn(const Surface& surface, std::uint32_t index, const core::Vec3& q,
                 MeshPlace& place) noexcept {
    const SurfaceTriangle& t = surface.triangle(index);
    place.triangle = index;
    place.weights = nearestWeights(surface.position(t.vertex[0]), surface.position(t.vertex[1]),
                                   surface.position(t.vertex[2]), q);
    return (q - pointAt(surface, place)).squaredNorm();
}

/// Looks for a triangle around the vertex that contains a nearer point; returns false if there is none.
template <class Surface>
bool nearerRoundVertex(const Surface& surface, const core::Vec3& q, std::size_t corner, MeshPlace& place,
                       double& distance2) noexcept {
    const std::uint32_t vertex = surface.triangle(place.triangle).vertex[corner];
    std::uint32_t index = surface.triangle(place.triangle).neighbour[(corner + 1) % 3];
    for (int round = 0; round < MeshWalk::kMostRound && index != place.triangle; ++round) {
        MeshPlace there;
        const double d2 = nearestIn(surface, index, q, there);
        if (d2 < distance2) {
            place = there;
            distance2 = d2;
            return true;
        }
        const std::size_t at = cornerOf(surface.triangle(index), vertex);
        if (at == 3)
            return false;
        index = surface.triangle(index).neighbour[(at + 1) % 3];
    }
    return false;
}

} // namespace detail

/// Moves over the surface from `place` downhill to the nearest place to q that can be reached in this way.
/// Every step comes strictly nearer; there are at most kMostSteps. For q near the surface the result is the
/// nearest place of this sheet.
/// Thread: haptic.
template <class Surface>
MeshPlace glide(const Surface& surface, MeshPlace place, const core::Vec3& q) noexcept {
    double distance2 = detail::nearestIn(surface, place.triangle, q, place);
    for (int step = 0; step < MeshWalk::kMostSteps; ++step) {
        std::size_t zeros = 0, zero = 0, other = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const bool none = place.weights[static_cast<Eigen::Index>(i)] <= 0.0;
            zeros += none ? 1 : 0;
            (none ? zero : other) = i;
        }
        if (zeros == 0)
            break;
        if (zeros >= 2) {
            if (!detail::nearerRoundVertex(surface, q, other, place, distance2))
                break;
            continue;
        }
        MeshPlace there;
        const double d2 =
            detail::nearestIn(surface, surface.triangle(place.triangle).neighbour[zero], q, there);
        if (!(d2 < distance2))
            break;
        place = there;
        distance2 = d2;
    }
    return place;
}

} // namespace chiron::simulation
