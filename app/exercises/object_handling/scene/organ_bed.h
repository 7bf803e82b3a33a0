// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"
#include "desktop/scene3d/parts/dent.h"
#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <vector>

namespace chiron::scene3d {

/// The organ on which the objects lie: the level's mesh at rest, with its highest point at W's origin. Empty
/// if the mesh cannot be made. Pure function; allocates.
/// Unit: mm.
/// Frame: W.
TriangleMesh organMesh(const simulation::ObjectHandlingParameters& parameters);
/// Height of its upper side above a point, without its bumps; 0 if the objects lie on the floor. Pure
/// function.
/// Unit: m.
/// Frame: W.
double organHeight_m(const simulation::ObjectHandlingParameters& parameters, double x_m, double y_m);
/// The dents made by tips and bodies that are below its upper side. The dents depend on the arguments alone:
/// the shape of the slow model is not shown.
std::vector<Dent> organDents(const simulation::ObjectHandlingParameters& parameters, const SceneState& state);
/// Returns the mesh with its vertices moved by the dents; the normals are unchanged.
TriangleMesh dented(TriangleMesh mesh, const std::vector<Dent>& dents);

} // namespace chiron::scene3d
