// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "simulation/geometry/mesh/mesh_dents.h"
#include "simulation/geometry/mesh/mesh_tracker.h"
#include "simulation/objects/felt_place.h"
#include "simulation/objects/object_contact.h"

#include <cstdint>

namespace chiron::simulation {

/// What one tool has done to one mesh so far: where it is on it, its bristle, its dent.
struct MeshContactState {
    MeshTracker tracker;
    FeltPlace felt;
    ObjectContactState object;
    core::Vec3 carried = core::Vec3::Zero(); ///< how far the touched places have moved with the surface, m
    double depth_m = 0.0;                    ///< of the tick before
    void reset() noexcept { *this = MeshContactState(); }
};

/// What a tool feels on a mesh, on the tool, in the mesh's frame.
struct MeshResponse {
    ObjectContactResponse contact; ///< force, its shares, normal, depth, energy, stiffness, inContact
    MeshFoot foot;                 ///< place on the surface: triangle, weights, point, blended normal, how it was found
    /// Where a tool that stays at the surface is drawn: its centre, lifted by the depth; p out of contact.
    core::Vec3 surfaced = core::Vec3::Zero();
};

/// The force of a spherical tool tip (radius r ≥ 0) on a watertight mesh with an object's attributes:
///   direction = the blend of the touched triangle's vertex normals (P2 figure 6);  d = (x − p)·n + r;
///   force from d by ObjectContact: elasticity, deformation, roughness, damping, viscosity, friction.
/// conservative: false. Blended normals are the gradient of no potential: a closed path makes or takes a little energy, which
/// grows with the angle between facet and blended normal (a finer mesh makes less; tests/unit/simulation/test_mesh_energy
/// states it), and the passivity controller stands behind. The force never pulls and, without dents, damping and friction, is
/// a function of the tool's place wherever the place is `tracked`.
/// Surface: TriangleMesh, or a moving one with position(vertex) and normal(vertex) of its own (moved_mesh.h).
/// Immutable; all state is the caller's: MeshContactState one a tool, MeshDents one a mesh (none: plain). Thread: haptic.
/// Source: P2 "Deformation", figure 6, "Deformation Model"; models.md §2.2.
class MeshContact {
public:
    static constexpr bool kConservative = false;

    MeshContact() = default;
    MeshContact(const ObjectAttributes& attributes, double toolRadius_m) noexcept : m_object(attributes), m_toolRadius_m(toolRadius_m) {}

    /// One tick, number `tick`. `p` m and `v` m/s of the tip's centre, in the mesh's frame. Call it every tick.
    template <class Surface>
    MeshResponse respond(const Surface& surface, const core::Vec3& p, const core::Vec3& v, std::uint64_t tick, MeshContactState& state,
                         MeshDents* dents = nullptr) const noexcept {
        MeshResponse out;
        out.foot = state.tracker.update(surface, p, m_toolRadius_m, m_object.reach_m());
        state.carried += out.foot.surfaceMotion;
        ContactPlace place;
        place.depth_m = out.foot.within() ? out.foot.depth_m : -1.0;
        place.normal = out.foot.normal;
        place.depthGradient = -out.foot.normal;
        place.foot = out.foot.point;
        place.position = p - state.carried;
        place.velocity = v - out.foot.surfaceMotion / core::kTickSeconds;
        place = state.felt.step(place, p, out.foot.track == MeshTrack::acquired, MeshTracker::kFollowFast);
        const bool dented = dents != nullptr && dents->any() && out.foot.within();
        if (dented) {
            const SurfaceTriangle& triangle = surface.triangle(out.foot.place.triangle);
            // as it was a tick ago: press() lets it go on from there
            const double stretch = dents->at(triangle, out.foot.place.weights, tick > 0 ? tick - 1 : 0, core::kTickSeconds);
            state.object.dent.resume(stretch, state.depth_m);
        }
        out.contact = m_object.respond(place, core::kTickSeconds, state.object);
        state.depth_m = out.contact.depth_m;
        if (dented)
            dents->set(surface.triangle(out.foot.place.triangle), out.foot.place.weights, state.object.dent.stretch_m(), tick, core::kTickSeconds);
        out.surfaced = out.contact.inContact ? core::Vec3(p + out.contact.depth_m * place.normal) : p;
        return out;
    }

    const ObjectContact& object() const noexcept { return m_object; }
    double toolRadius_m() const noexcept { return m_toolRadius_m; }

private:
    ObjectContact m_object;
    double m_toolRadius_m = 0.0;
};

} // namespace chiron::simulation
