// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "simulation/geometry/mesh/mesh_dents.h"
#include "simulation/geometry/mesh/mesh_tracker.h"
#include "simulation/objects/felt_place.h"
#include "simulation/objects/object_contact.h"

#include <cstdint>

namespace chiron::simulation {

/// State of the contact between one tool and one mesh: the tool's place on the mesh, its bristle and its
/// dent.
struct MeshContactState {
    MeshTracker tracker;
    FeltPlace felt;
    ObjectContactState object;
    /// How far the touched places have moved with the surface so far, m.
    core::Vec3 carried = core::Vec3::Zero();
    double depth_m = 0.0; ///< depth in the previous tick
    void reset() noexcept { *this = MeshContactState(); }
};

/// Response of a mesh to a tool. Forces are on the tool, in the mesh's frame.
struct MeshResponse {
    ObjectContactResponse contact; ///< force and its parts, normal, depth, energy, stiffness, inContact
    MeshFoot foot; ///< place on the surface: triangle, weights, point, blended normal, how it was found
    /// Where a tool that is shown to stay at the surface is drawn: its centre, raised by the depth; p out of
    /// contact.
    core::Vec3 surfaced = core::Vec3::Zero();
};

/// Computes the force of a spherical tool tip (radius r ≥ 0) on a watertight mesh with an object's
/// attributes:
///   direction = the blend of the touched triangle's vertex normals (P2 figure 6);  d = (x − p)·n + r;
///   force from d by ObjectContact: elasticity, deformation, roughness, damping, viscosity, friction.
/// conservative: false. Blended normals are not the gradient of a potential, so a closed path creates or
/// takes a little energy. The amount grows with the angle between facet and blended normal (a finer mesh
/// creates less; tests/unit/simulation/test_mesh_energy states it), and the passivity controller limits it.
/// The force never pulls. Without dents, damping and friction it is a function of the tool's position
/// wherever the place is `tracked`. The surface is a TriangleMesh, or a moving one with its own
/// position(vertex) and normal(vertex) (moved_mesh.h). Immutable; the caller keeps all state: one
/// MeshContactState per tool and, if the surface gives way, one MeshDents per mesh. Source: P2 "Deformation",
/// figure 6, "Deformation Model"; models.md §2.2.
/// Thread: haptic.
class MeshContact {
public:
    static constexpr bool kConservative = false;

    MeshContact() = default;
    MeshContact(const ObjectAttributes& attributes, double toolRadius_m) noexcept
        : m_object(attributes), m_toolRadius_m(toolRadius_m) {}

    /// Advances to tick number `tick`. `p` (m) and `v` (m/s) are those of the tip's centre, in the mesh's
    /// frame. Call it in every tick.
    template <class Surface>
    MeshResponse respond(const Surface& surface, const core::Vec3& p, const core::Vec3& v, std::uint64_t tick,
                         MeshContactState& state, MeshDents* dents = nullptr) const noexcept {
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
            // the dent of the previous tick, because press() advances it from there
            const double stretch =
                dents->at(triangle, out.foot.place.weights, tick > 0 ? tick - 1 : 0, core::kTickSeconds);
            state.object.dent.resume(stretch, state.depth_m);
        }
        out.contact = m_object.respond(place, core::kTickSeconds, state.object);
        state.depth_m = out.contact.depth_m;
        if (dented)
            dents->set(surface.triangle(out.foot.place.triangle), out.foot.place.weights,
                       state.object.dent.stretch_m(), tick, core::kTickSeconds);
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
