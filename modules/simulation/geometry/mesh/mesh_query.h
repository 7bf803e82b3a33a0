// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/mesh_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace chiron::simulation {

/// The point of a whole surface that is nearest to a query point. `signedDistance_m` is negative inside.
struct NearestOnMesh {
    MeshPlace place;
    core::Vec3 point = core::Vec3::Zero(); ///< m
    double signedDistance_m = std::numeric_limits<double>::infinity();
};

/// Outward direction of the triangle, side or corner on which the place lies. For a point whose nearest place
/// this is, it always decides correctly whether the point is outside or inside (Bærentzen & Aanæs 2005,
/// angle-weighted pseudo-normal).
template <class Surface> core::Vec3 pseudoNormal(const Surface& surface, const MeshPlace& place) noexcept {
    const SurfaceTriangle& t = surface.triangle(place.triangle);
    std::size_t zeros = 0, zero = 0, other = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool none = place.weights[static_cast<Eigen::Index>(i)] <= 0.0;
        zeros += none ? 1 : 0;
        (none ? zero : other) = i;
    }
    if (zeros >= 2)
        return surface.normal(t.vertex[other]);
    const core::Vec3 mine = facet(surface, place.triangle).normalized();
    return zeros == 0 ? mine : core::Vec3(mine + facet(surface, t.neighbour[zero]).normalized());
}

namespace detail {

struct TreeStack {
    std::array<std::uint32_t, MeshTree::kMostDepth> node{};
    std::array<double, MeshTree::kMostDepth> distance2{};
    std::size_t count = 0;

    void push(std::uint32_t index, double d2) noexcept {
        if (count < node.size()) {
            node[count] = index;
            distance2[count] = d2;
            ++count;
        }
    }
};

/// The squared distance of a box, reduced by how far its triangles may have moved.
inline double reachable2(double distance2, double moved_m) noexcept {
    if (moved_m == 0.0)
        return distance2;
    const double rest = std::sqrt(distance2) - moved_m;
    return rest > 0.0 ? rest * rest : 0.0;
}

template <class Surface>
void nearestInLeaf(const Surface& surface, const MeshTree::Node& leaf, const core::Vec3& p,
                   NearestOnMesh& best, double& best2) noexcept {
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const std::uint32_t index = leaf.first + i;
        const SurfaceTriangle& t = surface.triangle(index);
        const core::Vec3 &a = surface.position(t.vertex[0]), &b = surface.position(t.vertex[1]),
                         &c = surface.position(t.vertex[2]);
        const core::Vec3 w = nearestWeights(a, b, c, p);
        const core::Vec3 point = w[0] * a + w[1] * b + w[2] * c;
        const double d2 = (p - point).squaredNorm();
        if (d2 < best2) {
            best2 = d2;
            best.place = {index, w};
            best.point = point;
        }
    }
}

} // namespace detail

/// Finds the nearest point of the surface and the sign of its distance. The search is bounded, because it
/// visits each node once; it takes 1 µs in 50,000 triangles, and more where many are equally near. Defined
/// for every finite p. `guess` is a triangle to look at first; a near one saves most of the search.
/// Thread: haptic.
template <class Surface>
NearestOnMesh nearestOnMesh(const Surface& surface, const core::Vec3& p, std::uint32_t guess = 0) noexcept {
    NearestOnMesh best;
    double best2 = std::numeric_limits<double>::infinity();
    const auto nodes = surface.tree().nodes();
    const double moved = surface.largestDisplacement_m();
    if (nodes.empty())
        return best;
    detail::nearestInLeaf(surface, {{}, {}, guess, 1}, p, best, best2);
    detail::TreeStack stack;
    stack.push(0, 0.0);
    while (stack.count > 0) {
        --stack.count;
        if (stack.distance2[stack.count] >= best2)
            continue;
        const MeshTree::Node& node = nodes[stack.node[stack.count]];
        if (node.count > 0) {
            detail::nearestInLeaf(surface, node, p, best, best2);
            continue;
        }
        const double first = detail::reachable2(nodes[node.first].distance2(p), moved);
        const double second = detail::reachable2(nodes[node.first + 1].distance2(p), moved);
        const bool nearFirst = first <= second; // the nearer child is visited first
        stack.push(nearFirst ? node.first + 1 : node.first, nearFirst ? second : first);
        stack.push(nearFirst ? node.first : node.first + 1, nearFirst ? first : second);
    }
    const double side = (p - best.point).dot(pseudoNormal(surface, best.place));
    best.signedDistance_m = std::copysign(std::sqrt(best2), side);
    return best;
}

namespace detail {

/// Says whether the path from p along `way` (0..`until` of it) meets the box, widened by `moved`.
inline bool meetsBox(const MeshTree::Node& node, const core::Vec3& p, const core::Vec3& way, double until,
                     double moved) noexcept {
    double from = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        const double low = static_cast<double>(node.low[axis]) - moved - p[k],
                     high = static_cast<double>(node.high[axis]) + moved - p[k];
        if (way[k] == 0.0) {
            if (low > 0.0 || high < 0.0)
                return false;
            continue;
        }
        const double s1 = low / way[k], s2 = high / way[k];
        from = std::max(from, std::min(s1, s2));
        until = std::min(until, std::max(s1, s2));
    }
    return from <= until;
}

/// Returns where `way` enters the triangle from outside, as a share of `way`, and the weights there; nothing
/// if it does not. Source: Möller & Trumbore 1997.
inline std::optional<std::pair<double, core::Vec3>> enters(const core::Vec3& a, const core::Vec3& b,
                                                           const core::Vec3& c, const core::Vec3& p,
                                                           const core::Vec3& way) noexcept {
    constexpr double kEdge = 1e-9; // a path along an edge meets at least one of its two triangles
    const core::Vec3 ab = b - a, ac = c - a, h = way.cross(ac);
    const double det = ab.dot(h);
    if (!(det > 0.0)) // seen from behind or edge-on
        return std::nullopt;
    const core::Vec3 s = p - a, q = s.cross(ab);
    const double u = s.dot(h) / det, v = way.dot(q) / det, at = ac.dot(q) / det;
    if (u < -kEdge || v < -kEdge || u + v > 1.0 + kEdge || at < 0.0)
        return std::nullopt;
    return std::pair{at, core::Vec3(1.0 - u - v, u, v)};
}

} // namespace detail

/// Returns the first place at which the straight path from `from` to `to` enters the surface, or nothing if
/// it does not. Bounded.
/// Thread: haptic.
template <class Surface>
std::optional<MeshPlace> firstEntry(const Surface& surface, const core::Vec3& from,
                                    const core::Vec3& to) noexcept {
    const auto nodes = surface.tree().nodes();
    const core::Vec3 way = to - from;
    std::optional<MeshPlace> found;
    double until = 1.0;
    detail::TreeStack stack;
    if (!nodes.empty())
        stack.push(0, 0.0);
    while (stack.count > 0) {
        const MeshTree::Node& node = nodes[stack.node[--stack.count]];
        if (!detail::meetsBox(node, from, way, until, surface.largestDisplacement_m()))
            continue;
        if (node.count == 0) {
            stack.push(node.first, 0.0);
            stack.push(node.first + 1, 0.0);
            continue;
        }
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const std::uint32_t index = node.first + i;
            const SurfaceTriangle& t = surface.triangle(index);
            const auto hit = detail::enters(surface.position(t.vertex[0]), surface.position(t.vertex[1]),
                                            surface.position(t.vertex[2]), from, way);
            if (hit && hit->first <= until) {
                until = hit->first;
                found = MeshPlace{index, hit->second.cwiseMax(0.0) / hit->second.cwiseMax(0.0).sum()};
            }
        }
    }
    return found;
}

} // namespace chiron::simulation
