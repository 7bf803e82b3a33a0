// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_state.h"
#include "desktop/scene3d/parts/dent.h"
#include "desktop/scene3d/triangle_mesh.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <vector>

namespace chiron::scene3d {

/// The organ that objects lie on: the level's mesh with its highest point at W's origin, at rest. W, millimetres. Empty where the
/// mesh cannot be made. Pure; allocates.
TriangleMesh organMesh(const simulation::ObjectHandlingParameters& parameters);
/// Height of its upper side over a place, without its bumps; 0 where objects lie on the floor. W, metres. Pure.
double organHeight_m(const simulation::ObjectHandlingParameters& parameters, double x_m, double y_m);
/// How it gives way under tips and bodies that are below its upper side. The slow model's own shape is not shown: pure.
std::vector<Dent> organDents(const simulation::ObjectHandlingParameters& parameters, const SceneState& state);
/// A mesh with its vertices moved by the dents; normals stay.
TriangleMesh dented(TriangleMesh mesh, const std::vector<Dent>& dents);

} // namespace chiron::scene3d
