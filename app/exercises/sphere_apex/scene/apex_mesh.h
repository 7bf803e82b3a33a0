// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/scene/apex_surface.h"
#include "desktop/scene3d/drawn_mesh.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

namespace chiron::scene3d {

/// The triangles of the surface: rings round the ball's axis, 1.3 mm apart on the ball, wider on the plane.
/// Every vertex lies on the felt surface. A hidden ball gives the plain disc, the same for every state. Pure
/// function; allocates; takes about 1 ms.
TriangleMesh apexMesh(const ApexSurface& surface);

} // namespace chiron::scene3d
