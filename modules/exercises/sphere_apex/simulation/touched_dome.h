// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "simulation/deformable/deformable_organ.h"
#include "simulation/geometry/mesh/mesh_source.h"
#include "simulation/geometry/mesh/mesh_tracker.h"
#include "simulation/objects/contact_yield.h"
#include "simulation/objects/felt_place.h"
#include "simulation/objects/object_contact.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::simulation {

/// The dome of a level on meshes, in its own frame: the centre is at the origin, the plate's top at z = 0 and
/// the apex at (0, 0, R). In W it is rotated by the trial's turn_rad about the vertical and placed at
/// (centre, planeHeight). It is a pure function of the content, so whatever draws it gets the same mesh from
/// makeMeshShape().
MeshSource apexDomeSource(const SphereApexParameters& parameters);

/// Greatest depth, as a share of the radius, down to which the dome's laws are defined. Down to it the force
/// turns by at most 1.5 times its change on a plane (R/r − 1 of hemisphere_on_plane.h); three quarters of the
/// radius is where a mesh's field folds. Assumption.
inline constexpr double kDeepestShare = 0.6;

/// The surface that is touched in the sphere-apex levels mesh and organ: the generated dome on its plate, at
/// rest or as deformed by the slow model, and beyond the plate the plane on which it lies. The plate's last
/// millimetres blend into the plane, so that depth and normal are continuous. ObjectContact computes the
/// force along the blended normals (P2 figure 6); this is not conservative, and the passivity controller
/// limits it. The tool is a point, as in the levels on the exact sphere.
/// Thread: any for make(); haptic for the rest.
class TouchedDome {
public:
    /// Errors: badInput where the mesh or the organ cannot be made.
    static core::Result<std::unique_ptr<TouchedDome>> make(const SphereApexParameters& parameters,
                                                           const std::vector<SphereApexTrial>& trials);
    TouchedDome(const TouchedDome&) = delete;
    TouchedDome& operator=(const TouchedDome&) = delete;
    ~TouchedDome();

    /// Lets the dome of this trial appear at this tick, untouched and at rest.
    void begin(std::size_t trial, std::uint64_t tick) noexcept;
    /// Call once per tick before respond(). Returns true when an answer of the slow model took effect.
    bool update(std::uint64_t tick, SlowUpdate when) noexcept;
    /// Computes what tool `tool` (0..kMaxTools-1) feels, as a force on the tool in W. Call it once per tick
    /// for each tool that touches, and release() for the others. `mostDamping_Ns_per_m` is the tool's damping
    /// budget.
    ContactResponse respond(std::size_t tool, const core::Vec3& p_WT, const core::Vec3& v_WT,
                            double mostDamping_Ns_per_m = kUnboundedDamping) noexcept;
    void release(std::size_t tool) noexcept;
    /// Call once per tick after respond(), while the dome is there: sends a request to the slow model when it
    /// is time.
    void ask(std::uint64_t tick) noexcept;

    double organEnergy_J() const noexcept { return m_organ ? m_organ->elasticEnergy_J() : 0.0; }
    DeformableOrgan* organ() noexcept { return m_organ.get(); }  ///< null for a mesh that does not move
    const TriangleMesh& mesh() const noexcept { return m_mesh; } ///< at rest

    /// Where a tool that stays at the rest surface is drawn, W; p itself outside. Playback uses it, with the
    /// rest shape even for an organ.
    core::Vec3 restPoint(std::size_t trial, const core::Vec3& p_WT) const noexcept;

private:
    struct Tool {
        MeshTracker tracker;
        FeltPlace felt;
        ObjectContactState object;
        /// How far the touched places have moved with the surface so far, m.
        core::Vec3 carried = core::Vec3::Zero();
        ContactYield yield;
        bool used = false;
        /// The tool is beyond the mesh. Also true for a new tool, because it can only have come in from
        /// above.
        bool onPlane = true;
    };
    struct Place {
        core::Vec2 centre_m = core::Vec2::Zero();
        double cosine = 1.0, sine = 0.0;
        ObjectContact contact;
    };

    TouchedDome() = default;
    template <class Surface>
    ContactPlace placeOn(const Surface& surface, Tool& tool, const core::Vec3& p, const core::Vec3& v,
                         double reach_m) noexcept;
    bool isClear(const core::Vec3& p) const noexcept;
    bool isBreached(const Tool& tool, const core::Vec3& p) const noexcept;
    double turnsPerWay(double depth_m) const noexcept;
    core::Vec3 toMesh(const Place& place, const core::Vec3& p_W) const noexcept;

    TriangleMesh m_mesh;
    std::unique_ptr<DeformableOrgan> m_organ;
    std::vector<Place> m_places; ///< one per trial
    YieldLaw m_yield;
    double m_planeHeight_m = 0.0;
    double m_radius_m = 0.0;
    double m_deepest_m = 0.0;   ///< the dome gives way below this depth
    double m_blendFrom_m = 0.0; ///< horizontal distance at which the plane begins to blend in ...
    double m_blendTo_m = 0.0;   ///< ... and at which only the plane is left
    std::size_t m_trial = 0;
    std::array<Tool, core::kMaxTools> m_tools{};
    OrganTouches m_touches{};
};

} // namespace chiron::simulation
