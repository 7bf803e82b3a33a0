// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/sweep.h"

#include "core/units.h"
#include "desktop/scene3d/parts/picture_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::scene3d {

namespace {

MeshVertex vertexOf(const core::Vec3& p_mm, const core::Vec3& normal, double u_mm, double v_mm,
                    double light) {
    MeshVertex v;
    for (int k = 0; k < 3; ++k) {
        v.position_mm[k] = static_cast<float>(p_mm[k]);
        v.normal[k] = static_cast<float>(normal[k]);
    }
    v.texture[0] = static_cast<float>(u_mm);
    v.texture[1] = static_cast<float>(v_mm);
    v.light = static_cast<float>(light);
    return v;
}

/// The direction of a line at each of its points.
std::vector<core::Vec3> tangents(const std::vector<SweepRing>& rings) {
    std::vector<core::Vec3> along;
    core::Vec3 last = core::Vec3::UnitZ();
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const core::Vec3 way = rings[std::min(i + 1, rings.size() - 1)].p_mm - rings[i == 0 ? 0 : i - 1].p_mm;
        if (way.norm() > 1e-9)
            last = way.normalized();
        along.push_back(last);
    }
    return along;
}

/// Adds rows of vertices to one surface and joins each row with the previous one. The first and the last
/// column coincide, so the texture has a seam there.
class Skin {
public:
    Skin(TriangleMesh& mesh, int sides) : m_mesh(mesh), m_sides(sides) {}

    /// `tilt` inclines the normal along the line; 0 = perpendicular to it.
    void row(const core::Vec3& p_mm, const std::array<core::Vec3, 3>& frame, double radius_mm, double tilt,
             double along_mm, double light, double fringe_mm = 0.0) {
        const auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
        for (int i = 0; i <= m_sides; ++i) {
            const double angle = 2.0 * core::kPi * i / m_sides;
            const core::Vec3 out = std::cos(angle) * frame[0] + std::sin(angle) * frame[1];
            const core::Vec3 normal =
                (out * std::sqrt(std::max(0.0, 1.0 - tilt * tilt)) + tilt * frame[2]).normalized();
            const double reach_mm =
                fringe_mm * (0.5 + 0.5 * std::sin(5.0 * angle + 0.7) * std::cos(2.0 * angle));
            m_mesh.vertices.push_back(vertexOf(p_mm + radius_mm * out + reach_mm * frame[2], normal, along_mm,
                                               angle * std::max(1.0, m_round_mm), light));
        }
        if (m_rows++ > 0)
            join(m_before, first);
        m_before = first;
    }
    void setRound(double radius_mm) { m_round_mm = radius_mm; }

private:
    void join(std::uint32_t below, std::uint32_t above) {
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(m_sides); ++i)
            for (std::uint32_t index :
                 {below + i, below + i + 1, above + i + 1, below + i, above + i + 1, above + i})
                m_mesh.indices.push_back(index);
    }

    TriangleMesh& m_mesh;
    int m_sides;
    int m_rows = 0;
    double m_round_mm = 1.0;
    std::uint32_t m_before = 0;
};

constexpr int kCapRows = 4;

void addCap(Skin& skin, const SweepRing& ring, const std::array<core::Vec3, 3>& frame, double along_mm,
            SweepEnd end, bool first) {
    const double way = first ? -1.0 : 1.0;
    for (int i = first ? kCapRows : 1; first ? i >= 1 : i <= kCapRows; i += first ? -1 : 1) {
        const double angle = 0.5 * core::kPi * i / kCapRows;
        const double share = static_cast<double>(i) / kCapRows;
        const bool torn = end == SweepEnd::ragged;
        const double radius =
            torn ? ring.radius_mm * (1.12 - 1.1 * share * share) : ring.radius_mm * std::cos(angle);
        const double out =
            torn ? 0.9 * ring.radius_mm * std::sin(core::kPi * share) : ring.radius_mm * std::sin(angle);
        skin.row(ring.p_mm + way * out * frame[2], frame, std::max(0.01, radius), way * std::sin(angle),
                 along_mm + way * out, torn ? -0.9 : ring.light,
                 torn ? way * 1.3 * std::sin(core::kPi * share) : 0.0);
    }
}

} // namespace

void addSweep(TriangleMesh& mesh, const std::vector<SweepRing>& rings, SweepEnd first, SweepEnd last,
              int sides) {
    if (rings.size() < 2)
        return;
    const std::vector<core::Vec3> along = tangents(rings);
    Skin skin(mesh, sides);
    skin.setRound(rings[rings.size() / 2].radius_mm);
    core::Vec3 x = along.front().unitOrthogonal();
    double way_mm = 0.0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const core::Vec3& t = along[i];
        const core::Vec3 kept = x - t * t.dot(x);
        x = kept.norm() > 1e-6 ? core::Vec3(kept.normalized()) : core::Vec3(t.unitOrthogonal());
        const std::array<core::Vec3, 3> frame{x, t.cross(x), t};
        if (i == 0 && first != SweepEnd::open)
            addCap(skin, rings[i], frame, way_mm, first, true);
        if (i > 0)
            way_mm += (rings[i].p_mm - rings[i - 1].p_mm).norm();
        skin.row(rings[i].p_mm, frame, rings[i].radius_mm, 0.0, way_mm, rings[i].light);
        if (i + 1 == rings.size() && last != SweepEnd::open)
            addCap(skin, rings[i], frame, way_mm, last, false);
    }
}

void addLobe(TriangleMesh& mesh, const core::Vec3& centre_mm, const core::Vec3& halfAxes_mm, double lobes,
             std::uint32_t seed, int rows) {
    Dice dice(seed);
    std::array<core::Vec3, 5> bump;
    std::array<double, 5> phase{};
    for (std::size_t k = 0; k < bump.size(); ++k) {
        const auto wave = [&dice] { return 2.6 * static_cast<double>(dice.around()); };
        bump[k] = core::Vec3(wave(), wave(), wave());
        phase[k] = 6.3 * static_cast<double>(dice.next());
    }
    const auto pointOf = [&](double polar, double azimuth) -> core::Vec3 {
        const core::Vec3 u(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                           std::cos(polar));
        double out = 1.0;
        for (std::size_t k = 0; k < bump.size(); ++k)
            out += lobes * std::sin(2.0 * bump[k].dot(u) + phase[k]) / 2.5;
        return centre_mm + out * u.cwiseProduct(halfAxes_mm);
    };
    const int sides = 2 * rows;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    constexpr double kStep = 0.02;
    for (int r = 0; r <= rows; ++r)
        for (int i = 0; i <= sides; ++i) {
            const double polar = core::kPi * r / rows;
            const double azimuth = 2.0 * core::kPi * i / sides;
            // The derivative round the axis vanishes at a pole.
            const double inside = std::clamp(polar, kStep, core::kPi - kStep);
            const core::Vec3 down = pointOf(inside + kStep, azimuth) - pointOf(inside - kStep, azimuth);
            const core::Vec3 round = pointOf(inside, azimuth + kStep) - pointOf(inside, azimuth - kStep);
            const core::Vec3 p = pointOf(polar, azimuth);
            // The texture is projected from above and the front, which gives no poles and no visible seam.
            mesh.vertices.push_back(vertexOf(p, down.cross(round).normalized(), p.x() + 0.35 * p.z(),
                                             p.y() - 0.8 * p.z(),
                                             0.66 + 0.34 * (0.5 + 0.5 * std::cos(polar))));
        }
    const auto wide = static_cast<std::uint32_t>(sides + 1);
    for (std::uint32_t r = 0; r < static_cast<std::uint32_t>(rows); ++r)
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(sides); ++i) {
            const std::uint32_t a = first + r * wide + i;
            for (std::uint32_t index : {a, a + wide, a + wide + 1, a, a + wide + 1, a + 1})
                mesh.indices.push_back(index);
        }
}

} // namespace chiron::scene3d
