// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/mesh_place.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// The local data set of a surface that gives way (P2 "Deformation Model": "a local data set in the haptic
/// loop"). It stores how far the surface has given way at each vertex, q of attributes/deformation.h, which
/// recovers with the time constant τ: q(t) = q(t₀) e^{−(t−t₀)/τ}. The value is stored with the tick of the
/// last press and evaluated when it is read, so vertices that nobody touches cost nothing. Between vertices
/// it is interpolated like the normals, so a sliding tool meets no step, and a tool that comes back finds its
/// own dent. A press moves three vertices, so a dent is about as wide as the triangles. Use one instance per
/// mesh, shared by all tools.
/// Thread: haptic; the constructor allocates and runs elsewhere.
class MeshDents {
public:
    MeshDents() = default; ///< for a surface that does not give way
    MeshDents(std::size_t vertices, double recoveryTime_s);

    bool any() const noexcept { return !m_dents.empty(); }

    /// Returns q of a vertex (m, ≥ 0) at tick `now`; a tick lasts `tick_s`.
    double at(std::uint32_t vertex, std::uint64_t now, double tick_s) const noexcept {
        const Dent& dent = m_dents[vertex];
        if (dent.stretch_m == 0.0 || now <= dent.tick)
            return dent.stretch_m;
        return dent.stretch_m * std::exp(-static_cast<double>(now - dent.tick) * tick_s / m_recoveryTime_s);
    }
    double at(const SurfaceTriangle& triangle, const core::Vec3& weights, std::uint64_t now,
              double tick_s) const noexcept {
        return weights[0] * at(triangle.vertex[0], now, tick_s) +
               weights[1] * at(triangle.vertex[1], now, tick_s) +
               weights[2] * at(triangle.vertex[2], now, tick_s);
    }

    /// Changes q of the three corners by as little as possible so that q at `weights` becomes `stretch_m`. No
    /// corner falls below 0.
    void set(const SurfaceTriangle& triangle, const core::Vec3& weights, double stretch_m, std::uint64_t now,
             double tick_s) noexcept {
        const double step = (stretch_m - at(triangle, weights, now, tick_s)) / weights.squaredNorm();
        for (std::size_t i = 0; i < 3; ++i) {
            const double q =
                at(triangle.vertex[i], now, tick_s) + step * weights[static_cast<Eigen::Index>(i)];
            m_dents[triangle.vertex[i]] = {q > 0.0 ? q : 0.0, now};
        }
    }
    void clear() noexcept {
        for (Dent& dent : m_dents)
            dent = {};
    }

private:
    struct Dent {
        double stretch_m = 0.0;
        std::uint64_t tick = 0;
    };
    std::vector<Dent> m_dents;
    double m_recoveryTime_s = 0.0;
};

} // namespace chiron::simulation
