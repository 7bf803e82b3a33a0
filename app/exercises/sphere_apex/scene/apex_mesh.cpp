// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/scene/apex_mesh.h"

#include "core/units.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "simulation/geometry/mesh/make_mesh.h"

#include <algorithm>

namespace chiron::scene3d {

namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
constexpr int kSpokes = 120;
constexpr int kBallRings = 24;
constexpr int kPlaneRings = 26;
constexpr double kCreaseShade_m = 0.009; // distance up to which the corner between ball and plane is shaded

class MeshMaker {
public:
    explicit MeshMaker(const ApexSurface& surface) : m_surface(surface) {}

    TriangleMesh make() {
        if (m_surface.shown && m_surface.mesh)
            dome();
        else if (m_surface.shown)
            ball();
        plane();
        return std::move(m_mesh);
    }

private:
    core::Vec2 spoke(int i) const {
        const double angle = 2.0 * core::kPi * i / kSpokes;
        return {std::cos(angle), std::sin(angle)};
    }

    void vertex(const core::Vec3& p_W, const core::Vec3& normal, const core::Vec2& along_m, double light) {
        MeshVertex v;
        for (int k = 0; k < 3; ++k) {
            v.position_mm[k] = static_cast<float>(p_W[k] * 1000.0);
            v.normal[k] = static_cast<float>(normal[k]);
        }
        v.texture[0] = static_cast<float>(along_m.x() * 1000.0);
        v.texture[1] = static_cast<float>(along_m.y() * 1000.0);
        v.light = static_cast<float>(light);
        m_mesh.vertices.push_back(v);
    }

    /// Joins two rings of vertices, given by the index of their first vertex.
    void join(std::uint32_t inner, std::uint32_t outer) {
        for (std::uint32_t i = 0; i < kSpokes; ++i) {
            const std::uint32_t next = (i + 1) % kSpokes;
            for (std::uint32_t index :
                 {inner + i, outer + i, outer + next, inner + i, outer + next, inner + next})
                m_mesh.indices.push_back(index);
        }
    }

    std::uint32_t size() const { return static_cast<std::uint32_t>(m_mesh.vertices.size()); }

    /// Texture coordinates are distances along the surface from the apex, so that the texture is not
    /// stretched on the flank.
    core::Vec2 along(const core::Vec2& direction, double distance_m) const {
        return m_surface.ball.centre_m + distance_m * direction;
    }

    void ball() {
        std::uint32_t before = 0;
        for (int ring = 0; ring <= kBallRings; ++ring) {
            const double angle = 0.5 * core::kPi * ring / kBallRings;
            const double toRim_m = (0.5 * core::kPi - angle) * m_surface.ball.radius_m;
            const std::uint32_t first = size();
            for (int i = 0; i < kSpokes; ++i) {
                const core::Vec2 out = spoke(i);
                const core::Vec3 u(std::sin(angle) * out.x(), std::sin(angle) * out.y(),
                                   ring == kBallRings ? 0.0 : std::cos(angle));
                const core::Vec3 p = m_surface.pointOfBall(u);
                const core::Vec3 normal = ring == kBallRings ? u : m_surface.normalAt(p);
                vertex(p, normal, along(out, angle * m_surface.ball.radius_m), crease(toRim_m));
            }
            if (ring > 0)
                join(before, first);
            before = first;
        }
    }

    /// Adds the triangles that are felt, turned and moved into position, except those under the plate and
    /// beyond the field.
    void dome() {
        const auto shape = simulation::makeMeshShape(*m_surface.mesh);
        if (!shape) { // the catalogue refuses levels whose mesh cannot be made
            ball();
            return;
        }
        std::vector<core::Vec3> places;
        for (const core::Vec3& p : shape->vertices)
            places.push_back(placed(p));
        std::vector<core::Vec3> normals(places.size(), core::Vec3::Zero());
        std::vector<std::uint32_t> number(places.size(), kNone);
        for (const auto& t : shape->triangles) {
            const core::Vec3 across = (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]);
            for (const std::uint32_t i : t)
                normals[i] += across;
        }
        for (const auto& t : shape->triangles) {
            if (!isSeen(places[t[0]]) && !isSeen(places[t[1]]) && !isSeen(places[t[2]]))
                continue;
            for (const std::uint32_t i : t) {
                if (number[i] == kNone) {
                    number[i] = size();
                    domeVertex(places[i], normals[i].normalized());
                }
                m_mesh.indices.push_back(number[i]);
            }
        }
    }

    core::Vec3 placed(const core::Vec3& p) const {
        const double c = std::cos(m_surface.turn_rad);
        const double s = std::sin(m_surface.turn_rad);
        return {m_surface.ball.centre_m.x() + c * p.x() - s * p.y(),
                m_surface.ball.centre_m.y() + s * p.x() + c * p.y(), m_surface.ball.planeHeight_m + p.z()};
    }

    bool isSeen(const core::Vec3& p_W) const {
        return p_W.z() > m_surface.ball.planeHeight_m - 0.0005 &&
               p_W.head<2>().norm() < m_surface.fieldRadius_m;
    }

    void domeVertex(const core::Vec3& p_W, const core::Vec3& normal) {
        const core::Vec2 beside = p_W.head<2>() - m_surface.ball.centre_m;
        const double r_m = beside.norm();
        const double radius_m = m_surface.ball.radius_m;
        const double up_m = p_W.z() - m_surface.ball.planeHeight_m;
        const bool onBall = r_m < radius_m && up_m > 0.05 * radius_m;
        const double arc_m = onBall ? radius_m * std::atan2(r_m, up_m)
                                    : 0.5 * core::kPi * radius_m + std::max(0.0, r_m - radius_m);
        const double toRim_m = onBall ? up_m : std::abs(r_m - radius_m);
        vertex(p_W, normal, along(r_m > 1e-9 ? core::Vec2(beside / r_m) : core::Vec2(1.0, 0.0), arc_m),
               crease(toRim_m));
    }

    static double crease(double away_m) {
        const double near = std::clamp(1.0 - away_m / kCreaseShade_m, 0.0, 1.0);
        return 1.0 - 0.55 * near * near;
    }

    /// Adds the plane from the rim of the ball (or from the middle, under the cover) to the edge of the
    /// field.
    void plane() {
        const double rim_m = !m_surface.shown ? 0.0
                             : m_surface.mesh ? m_surface.mesh->plateRadius_m
                                              : m_surface.ball.radius_m;
        const core::Vec2 centre = m_surface.shown ? m_surface.ball.centre_m : core::Vec2(0.0, 0.0);
        std::uint32_t before = 0;
        for (int ring = 0; ring <= kPlaneRings; ++ring) {
            const double t = static_cast<double>(ring) / kPlaneRings;
            const double share = 0.45 * t + 0.55 * t * t; // finer near the rim, where the tip works
            const std::uint32_t first = size();
            for (int i = 0; i < kSpokes; ++i) {
                const core::Vec2 out = spoke(i);
                const double away_m =
                    share *
                    std::max(0.0, toEdge(centre, out) - rim_m); // the plate may reach beyond the field
                const core::Vec2 at = centre + (rim_m + away_m) * out;
                const double radius_m = m_surface.ball.radius_m;
                const double arc_m =
                    m_surface.shown ? 0.5 * core::kPi * radius_m + rim_m - radius_m + away_m : away_m;
                vertex({at.x(), at.y(), m_surface.ball.planeHeight_m}, core::Vec3::UnitZ(), along(out, arc_m),
                       m_surface.shown ? crease(rim_m - m_surface.ball.radius_m + away_m) : 1.0);
            }
            if (ring > 0)
                join(before, first);
            before = first;
        }
    }

    /// The distance from `from` to the edge of the field in the unit direction `out`.
    double toEdge(const core::Vec2& from, const core::Vec2& out) const {
        const double along = from.dot(out);
        const double rest = m_surface.fieldRadius_m * m_surface.fieldRadius_m - from.squaredNorm();
        return -along + std::sqrt(std::max(0.0, along * along + rest));
    }

    ApexSurface m_surface;
    TriangleMesh m_mesh;
};

} // namespace

TriangleMesh apexMesh(const ApexSurface& surface) {
    return MeshMaker(surface).make();
}

} // namespace chiron::scene3d
