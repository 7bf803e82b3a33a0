// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact_loops.h"
#include "simulation/palpation/tissue_contact.h"

#include <array>
#include <cmath>
#include <vector>

/// Tissues that the tests of palpation share.
namespace chiron::simulation::testing {

using core::Vec2;
using core::Vec3;

/// The flat pad without friction and damping: the potential alone.
inline TissueParameters quietPad() {
    TissueParameters p;
    p.friction = 0.0;
    p.damping_Ns_per_m.setZero();
    return p;
}

/// A dome with a furrow that runs askew over it.
inline SurfaceShape furrowedDome() {
    SurfaceShape shape;
    shape.planeHeight_m = 0.002;
    shape.bumps = {{Vec2(0.002, -0.001), Vec2(0.040, 0.034), 0.3, 0.011},
                   {Vec2(0.004, 0.003), Vec2(0.011, 0.030), 0.7, -0.0015}};
    return shape;
}

inline TissueParameters quietDome() {
    TissueParameters p = quietPad();
    p.shape = furrowedDome();
    return p;
}

/// models.md §3's three, side by side.
inline std::vector<Lump> threeLumps() {
    return {{Vec2(0.0, 0.0), 0.012, 0.0075, 10.0},
            {Vec2(0.020, 0.004), 0.012, 0.0075, 3.0},
            {Vec2(-0.014, 0.012), 0.010, 0.005, 10.0}};
}

inline StiffRegion harderRegion() {
    return {"ridge", Vec2(-0.012, -0.010), Vec2(0.012, 0.007), 0.5, 0.4};
}

inline TissueContact contactOf(const TissueParameters& parameters,
                               const std::vector<Lump>& lumps = threeLumps()) {
    TissueContact contact(parameters);
    contact.setLumps(lumps);
    return contact;
}

inline core::ToolState toolAt(const Vec3& p_W, const Vec3& v_W = Vec3::Zero()) {
    core::ToolState tool;
    tool.p_WT = p_W;
    tool.v_WT = v_W;
    return tool;
}

/// A finger that has just arrived.
inline TissueResponse pressAt(const TissueContact& contact, const Vec3& p_W, const Vec3& v_W = Vec3::Zero()) {
    TissueTouch touch;
    return contact.respond(toolAt(p_W, v_W), touch);
}

/// `depth_m` under the surface at (x, y), along the normal there.
inline Vec3 under(const TissueContact& contact, const Vec2& xy_m, double depth_m) {
    return contact.surface().pointAt(xy_m) - depth_m * contact.surface().normalAt(xy_m);
}

inline Vec3 randomUnder(core::Random& random, const TissueContact& contact, double reach_m,
                        double deepest_m) {
    return under(contact, Vec2(random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m)),
                 random.uniform(0.0, deepest_m));
}

inline Vec3 randomUnit(core::Random& random) {
    const double z = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 2.0 * core::kPi),
                 r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Work (J) that the hand puts in along a path in ticks of 1 ms, by the trapezoid rule, with the least by
/// which it ever led the change of what the tissue holds: < 0 when the tissue made energy.
struct PathBooks {
    double work_J = 0.0;
    double lead_J = 0.0;
    double mostHeld_J = 0.0;
};
inline PathBooks walk(const TissueContact& contact, const std::vector<Vec3>& path, double tick_s = 0.001) {
    PathBooks books;
    TissueTouch touch;
    TissueResponse before = contact.respond(toolAt(path.front()), touch);
    const double held = before.energy_J;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vec3 moved = path[i] - path[i - 1];
        const TissueResponse now = contact.respond(toolAt(path[i], moved / tick_s), touch);
        books.work_J -= 0.5 * (before.force + now.force).dot(moved);
        books.lead_J = std::min(books.lead_J, books.work_J - (now.energy_J - held));
        books.mostHeld_J = std::max(books.mostHeld_J, now.energy_J);
        before = now;
    }
    return books;
}

} // namespace chiron::simulation::testing
