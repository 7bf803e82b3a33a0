// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "core/units.h"
#include "simulation/geometry/mesh/make_mesh.h"
#include "simulation/geometry/mesh/mesh_place.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <vector>

namespace chiron::simulation::testing {

using core::Vec3;

inline MeshSource ellipsoid(double x_m, double y_m, double z_m, double edge_m, double bumps_m = 0.0) {
    MeshSource s;
    s.shape = MeshSource::Shape::ellipsoid;
    s.halfAxisX_m = x_m;
    s.halfAxisY_m = y_m;
    s.halfAxisZ_m = z_m;
    s.edge_m = edge_m;
    s.bumpHeight_m = bumps_m;
    return s;
}

/// The organ of the tests and of the benchmark: 50,000 triangles, bumps of 0.4 mm every 8 mm (round to 4 mm).
inline MeshSource bumpyOrgan(double edge_m = 0.0007) {
    return ellipsoid(0.040, 0.030, 0.025, edge_m, 0.0004);
}

inline MeshSource bumpyDome() {
    MeshSource s;
    s.shape = MeshSource::Shape::dome;
    s.bumpHeight_m = 0.0003;
    return s;
}

/// A box cut into nx × ny × nz cells, only its skin, laid into space by `map` of (0..1)³.
inline MeshShape slab(int nx, int ny, int nz, const std::function<Vec3(const Vec3&)>& map) {
    MeshShape shape;
    std::map<std::array<int, 3>, std::uint32_t> made;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [entry, isNew] = made.try_emplace(at, static_cast<std::uint32_t>(shape.vertices.size()));
        if (isNew)
            shape.vertices.push_back(
                map(Vec3(static_cast<double>(at[0]) / nx, static_cast<double>(at[1]) / ny,
                         static_cast<double>(at[2]) / nz)));
        return entry->second;
    };
    const std::array<int, 3> cells{nx, ny, nz};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (int i = 0; i < cells[u]; ++i)
                for (int j = 0; j < cells[v]; ++j) {
                    std::array<std::uint32_t, 4> corner{};
                    for (std::size_t k = 0; k < 4; ++k) {
                        std::array<int, 3> at{};
                        at[axis] = high ? cells[axis] : 0;
                        at[u] = i + (k == 1 || k == 2 ? 1 : 0);
                        at[v] = j + (k >= 2 ? 1 : 0);
                        corner[k] = vertex(at);
                    }
                    if (!high)
                        std::swap(corner[1], corner[3]);
                    shape.triangles.push_back({corner[0], corner[1], corner[2]});
                    shape.triangles.push_back({corner[0], corner[2], corner[3]});
                }
        }
    return shape;
}

/// A flat plate, its top at z = 0, `width_m` square, centred.
inline MeshShape plate(double width_m, double thickness_m, double edge_m) {
    const int n = static_cast<int>(std::lround(width_m / edge_m)),
              k = std::max(1, static_cast<int>(std::lround(thickness_m / edge_m)));
    return slab(n, n, k, [=](const Vec3& q) {
        return Vec3(width_m * (q.x() - 0.5), width_m * (q.y() - 0.5), thickness_m * (q.z() - 1.0));
    });
}

/// A sheet bent round into a U: two flat legs of 30 mm and a half turn of `bend_m` radius (of its middle),
/// `thickness_m` thick. The upper leg's outside lies at z = bend + thickness/2, looking up; the bend is
/// towards −x.
inline MeshShape fold(double bend_m, double thickness_m, double edge_m) {
    const double leg = 0.030, arc = core::kPi * bend_m, length = 2.0 * leg + arc, width = 0.030;
    const auto cells = [&](double l) { return std::max(1, static_cast<int>(std::lround(l / edge_m))); };
    return slab(cells(length), cells(width), cells(thickness_m), [=](const Vec3& q) {
        const double s = length * q.x(), y = width * (q.y() - 0.5),
                     out = bend_m + thickness_m * (q.z() - 0.5);
        if (s < leg) // the lower leg, towards the bend: its outside looks down
            return Vec3(leg - s, y, -out);
        if (s > leg + arc)
            return Vec3(s - leg - arc, y, out);
        const double angle = (s - leg) / bend_m; // from straight down round −x to straight up
        return Vec3(-out * std::sin(angle), y, -out * std::cos(angle));
    });
}

/// A plate 40 mm square whose side towards +x is a half circle of half its thickness.
inline MeshShape roundedPlate(double thickness_m, double edge_m) {
    const double r = 0.5 * thickness_m, flat = 0.040, quarter = 0.5 * core::kPi * r;
    const auto cells = [&](double l) { return std::max(2, static_cast<int>(std::lround(l / edge_m))); };
    const double length =
        flat + quarter - quarter / cells(quarter); // the tip is a row of its own between both halves
    return slab(cells(length), cells(flat), 2, [=](const Vec3& q) {
        const double s = length * q.x(), up = 2.0 * q.z() - 1.0, y = flat * (q.y() - 0.5);
        if (q.x() == 1.0 && up == 0.0)
            return Vec3(r, y, 0.0);
        const double over = std::max(0.0, s - flat);
        return Vec3(std::min(s, flat) - flat + r * std::sin(over / r), y, up * r * std::cos(over / r));
    });
}

inline double volume(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const SurfaceTriangle& t : mesh.triangles())
        sum += mesh.position(t.vertex[0]).dot(mesh.position(t.vertex[1]).cross(mesh.position(t.vertex[2]))) /
               6.0;
    return sum;
}

/// The nearest point by looking everywhere: the nearest triangle has a corner within its longest side of the
/// nearest corner's distance. Knows nothing of the tree, the walk or the neighbours.
class BruteForce {
public:
    explicit BruteForce(const TriangleMesh& mesh) : m_mesh(mesh), m_around(mesh.vertices().size()) {
        for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
            for (const std::uint32_t v : mesh.triangle(t).vertex)
                m_around[v].push_back(t);
        for (const SurfaceVertex& v : mesh.vertices()) {
            m_x.push_back(static_cast<float>(v.position.x()));
            m_y.push_back(static_cast<float>(v.position.y()));
            m_z.push_back(static_cast<float>(v.position.z()));
        }
        m_d2.resize(m_x.size());
    }

    MeshPlace nearest(const Vec3& p) {
        const auto x = static_cast<float>(p.x()), y = static_cast<float>(p.y()),
                   z = static_cast<float>(p.z());
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t v = 0; v < m_x.size(); ++v) {
            const float dx = m_x[v] - x, dy = m_y[v] - y, dz = m_z[v] - z;
            m_d2[v] = dx * dx + dy * dy + dz * dz;
            least = m_d2[v] < least ? m_d2[v] : least;
        }
        const double reach = std::sqrt(static_cast<double>(least)) + m_mesh.longestEdge_m() + 1e-6;
        const auto reach2 = static_cast<float>(reach * reach);
        MeshPlace best;
        double best2 = std::numeric_limits<double>::infinity();
        for (std::size_t v = 0; v < m_x.size(); ++v) {
            if (m_d2[v] > reach2)
                continue;
            for (const std::uint32_t t : m_around[v]) {
                const SurfaceTriangle& tri = m_mesh.triangle(t);
                const MeshPlace place{t, nearestWeights(m_mesh.position(tri.vertex[0]),
                                                        m_mesh.position(tri.vertex[1]),
                                                        m_mesh.position(tri.vertex[2]), p)};
                const double d2 = (pointAt(m_mesh, place) - p).squaredNorm();
                if (d2 < best2) {
                    best2 = d2;
                    best = place;
                }
            }
        }
        return best;
    }

    /// Half the thickness of the part under the surface point x with inward direction −n: the radius of the
    /// largest ball that touches there and holds no vertex (those within `near_m` left out: there the facets'
    /// own roughness would decide).
    double halfThickness(const Vec3& x, const Vec3& n, double near_m) const {
        double least = std::numeric_limits<double>::infinity();
        for (const SurfaceVertex& v : m_mesh.vertices()) {
            const Vec3 to = v.position - x;
            const double below = -n.dot(to), d2 = to.squaredNorm();
            if (d2 > near_m * near_m && below > 0.0)
                least = std::min(least, 0.5 * d2 / below);
        }
        return least;
    }

private:
    const TriangleMesh& m_mesh;
    std::vector<std::vector<std::uint32_t>> m_around;
    std::vector<float> m_x, m_y, m_z, m_d2;
};

/// A hand over an ellipsoid with the given half axes: wanders over all of it, `speed` rad/s, and presses
/// between lift_m above and press_m below the given mesh. Tip of `radius_m`. A position a tick.
inline std::vector<Vec3> strokes(BruteForce& brute, const TriangleMesh& mesh, const Vec3& axes,
                                 std::uint64_t seed, int ticks, double radius_m, double press_m,
                                 double lift_m) {
    core::Random random = core::Random::stream(seed, "mesh.strokes");
    const double a = random.uniform(0.0, 6.0), b = random.uniform(0.7, 1.3), c = random.uniform(0.5, 0.9),
                 e = random.uniform(3.0, 5.0);
    std::vector<Vec3> path;
    // the way over the surface every 20th tick, and a smooth line between
    constexpr int kStep = 20;
    std::vector<Vec3> knots, normals;
    for (int i = 0; i <= ticks / kStep + 1; ++i) {
        const double t = 0.001 * kStep * i, theta = 1.57 + 1.1 * std::sin(c * t + a),
                     phi = b * t + 0.7 * std::sin(2.1 * t);
        const Vec3 q = Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta))
                           .cwiseProduct(axes);
        const MeshPlace place = brute.nearest(q);
        knots.push_back(pointAt(mesh, place));
        normals.push_back(normalAt(mesh, place));
    }
    for (int n = 0; n < ticks; ++n) {
        const std::size_t i = static_cast<std::size_t>(n / kStep);
        const double share = static_cast<double>(n % kStep) / kStep, t = 0.001 * n;
        const double depth = 0.5 * (press_m - lift_m) + 0.5 * (press_m + lift_m) * std::sin(e * t);
        const Vec3 x = (1.0 - share) * knots[i] + share * knots[i + 1],
                   normal = ((1.0 - share) * normals[i] + share * normals[i + 1]).normalized();
        path.push_back(x + (radius_m - depth) * normal);
    }
    return path;
}

} // namespace chiron::simulation::testing
