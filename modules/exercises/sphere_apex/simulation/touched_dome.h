// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/deformable/deformable_organ.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
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

/// The dome of a level on meshes, in its own frame: centre at the origin, the plate's top at z = 0, the apex at (0, 0, R); in W
/// it is turned by the trial's turn_rad about the vertical and put at (centre, planeHeight). A pure function of the content:
/// who draws it makes the same mesh with makeMeshShape().
MeshSource apexDomeSource(const SphereApexParameters& parameters);

/// So deep, as a share of the radius, the dome's laws have their place: the force turns by at most 1.5 times what it changes on a
/// plane there (R/r − 1 of hemisphere_on_plane.h), and three quarters of the radius is where a mesh's field folds. Assumption.
inline constexpr double kDeepestShare = 0.6;

/// The surface that is touched in the sphere-apex levels mesh and organ: the generated dome on its plate, at rest or as the
/// slow model has it, and beyond the plate the plane that it lies on. The plate's last millimetres blend into the plane, so that
/// depth and normal are continuous. Force by ObjectContact along the blended normals (P2 figure 6): not conservative; the
/// passivity controller stands behind. The tool is a point, as in the levels on the exact sphere.
/// Thread: make() anywhere; the rest haptic.
class TouchedDome {
public:
    /// Fails (badInput) where the mesh or the organ cannot be made.
    static core::Result<std::unique_ptr<TouchedDome>> make(const SphereApexParameters& parameters,
                                                           const std::vector<SphereApexTrial>& trials);
    TouchedDome(const TouchedDome&) = delete;
    TouchedDome& operator=(const TouchedDome&) = delete;
    ~TouchedDome();

    /// The dome of this trial appears at this tick: untouched and at rest.
    void begin(std::size_t trial, std::uint64_t tick) noexcept;
    /// Once a tick before respond(); true when an answer of the slow model took effect.
    bool update(std::uint64_t tick, SlowUpdate when) noexcept;
    /// What tool `tool` (0..kMaxTools-1) feels, on the tool, W. Once a tick for each that touches; release() for the others.
    /// `mostDamping_Ns_per_m`: of its budget.
    ContactResponse respond(std::size_t tool, const core::Vec3& p_WT, const core::Vec3& v_WT,
                            double mostDamping_Ns_per_m = kUnboundedDamping) noexcept;
    void release(std::size_t tool) noexcept;
    /// Once a tick after respond(), while the dome is there: asks the slow model when it is time.
    void ask(std::uint64_t tick) noexcept;

    double organEnergy_J() const noexcept { return m_organ ? m_organ->elasticEnergy_J() : 0.0; }
    DeformableOrgan* organ() noexcept { return m_organ.get(); } ///< null for a mesh that does not move
    const TriangleMesh& mesh() const noexcept { return m_mesh; } ///< at rest

    /// Where a tool that stays at the rest surface is drawn, W; p itself outside. For playback: the rest shape, also of an organ.
    core::Vec3 restPoint(std::size_t trial, const core::Vec3& p_WT) const noexcept;

private:
    struct Tool {
        MeshTracker tracker;
        FeltPlace felt;
        ObjectContactState object;
        core::Vec3 carried = core::Vec3::Zero(); ///< how far the touched places have moved with the surface, m
        ContactYield yield;
        bool used = false;
        bool onPlane = true;                     ///< beyond the mesh; of a tool not seen before: it can only have come in from above
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
    std::vector<Place> m_places; ///< one a trial
    YieldLaw m_yield;
    double m_planeHeight_m = 0.0;
    double m_radius_m = 0.0;
    double m_deepest_m = 0.0; ///< deeper, the dome gives way
    double m_blendFrom_m = 0.0; ///< horizontal distance from which the plane comes in ...
    double m_blendTo_m = 0.0;   ///< ... and from which it is alone
    std::size_t m_trial = 0;
    std::array<Tool, core::kMaxTools> m_tools{};
    OrganTouches m_touches{};
};

} // namespace chiron::simulation
