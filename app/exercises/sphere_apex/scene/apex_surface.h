// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/parts/dent.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "simulation/attributes/dimple.h"
#include "simulation/geometry/hemisphere_on_plane.h"
#include "simulation/geometry/mesh/mesh_source.h"

#include <optional>

namespace chiron::scene3d {

/// The surface of sphere_apex as it is drawn: the felt one (HemisphereOnPlane with the level's dimple) if the
/// level shows it, else the bare plane, which reveals nothing. A plain value.
/// Unit: m.
/// Frame: W.
/// Thread: any.
struct ApexSurface {
    /// False: a flat cover; ball and dimple then keep fixed values, independent of the state.
    bool shown = false;
    simulation::HemisphereOnPlane ball;
    simulation::Dimple dimple;
    /// For levels on meshes: the generated dome that is felt, at rest, turned about the vertical; empty if
    /// the ball is exact.
    std::optional<simulation::MeshSource> mesh;
    double turn_rad = 0.0;
    double fieldRadius_m = 0.080; ///< the surface is drawn in this disc round W's origin

    static ApexSurface of(const simulation::SphereApexParameters& parameters, const SceneState& state);

    /// z of the highest drawn point at this place, without any dent.
    double height_m(double x_m, double y_m) const;
    /// The drawn point of the ball in the unit direction `u` (u.z ≥ 0) from its centre.
    core::Vec3 pointOfBall(const core::Vec3& u) const;
    /// Outward unit normal of the drawn surface at a point of it.
    core::Vec3 normalAt(const core::Vec3& p_W) const;
    /// The dent under a tip at this position, according to the felt contact. There is no contact under a
    /// cover.
    Dent dentUnder(const core::Vec3& p_WT) const;
    /// The same for a tool as it is shown; on a mesh, the scene provides the contact point.
    Dent dentUnder(const ToolView& tool) const;

    bool operator==(const ApexSurface& other) const;
};

} // namespace chiron::scene3d
